// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/v4l2/v4l2_address.h"

namespace odo {

/// A camera that was opened and is to be found again after it was gone, wherever its node is then.
class V4l2KnownCamera
{
public:
    V4l2KnownCamera(V4l2Address address, const V4l2Device &device);

    /// Opens it: at the port where it was; by its serial number (where no other camera shares that) at any.
    /// Errors: Unavailable while it is not there, or another camera is in its place; those of
    /// V4l2Device::open.
    Result<std::shared_ptr<V4l2Device>> find() const;

private:
    bool isAtItsPort(const V4l2Identity &other) const;
    bool isElsewhere(const V4l2Identity &other) const;

    const V4l2Address m_address;
    const V4l2Identity m_identity;
    bool m_isSerialUnique = false;
};

} // namespace odo
