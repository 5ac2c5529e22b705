// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/v4l2/internal/v4l2_mode.h"

#include <string>
#include <string_view>

namespace odo {

/// A camera's address taken apart: "v4l2:PLACE?size=1280x720&rate=30&format=MJPG", all after the question
/// mark may be left out. PLACE is a node (/dev/video0), a link to one (/dev/v4l/by-id/...), or the port
/// (usb-0000:00:14.0-1).
struct V4l2Address
{
    std::string uri, location;
    V4l2Request request;
};

/// What such addresses begin with.
inline constexpr std::string_view v4l2Scheme = "v4l2:";

/// True for the addresses of this kind.
bool isV4l2Address(const std::string &uri);

/// InvalidInput for a part that is not understood.
Result<V4l2Address> parseV4l2Address(const std::string &uri);

/// Opens the camera at the address' place. Errors: those of V4l2Device::open; NotFound where no camera is at
/// the port.
Result<std::shared_ptr<V4l2Device>> openV4l2Device(const V4l2Address &address);

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
