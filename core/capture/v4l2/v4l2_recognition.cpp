// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/v4l2_recognition.h"

#include <algorithm>
#include <cerrno>

namespace odo {

V4l2KnownCamera::V4l2KnownCamera(V4l2Address address, const V4l2Device &device)
    : m_address(std::move(address)), m_identity(device.identity())
{
    // Cheap cameras of one model often carry one serial number.
    const auto sharesIt = [this](const auto &other) {
        return other->identity().serial == m_identity.serial &&
               other->identity().busInfo != m_identity.busInfo;
    };
    m_isSerialUnique = !m_identity.serial.empty() && std::ranges::none_of(openV4l2Devices(), sharesIt);
}

bool V4l2KnownCamera::isAtItsPort(const V4l2Identity &other) const
{
    return other.busInfo == m_identity.busInfo && other.name == m_identity.name &&
           other.serial == m_identity.serial && other.index == m_identity.index;
}

bool V4l2KnownCamera::isElsewhere(const V4l2Identity &other) const
{
    return m_isSerialUnique && other.serial == m_identity.serial && other.name == m_identity.name &&
           other.index == m_identity.index;
}

Result<std::shared_ptr<V4l2Device>> V4l2KnownCamera::find() const
{
    const auto devices = openV4l2Devices();
    for (const auto &test : {&V4l2KnownCamera::isAtItsPort, &V4l2KnownCamera::isElsewhere}) {
        for (const auto &device : devices) {
            if ((this->*test)(device->identity()))
                return device;
        }
    }
    const auto inItsPlace = openV4l2Place(m_address);
    if (inItsPlace)
        return fail(ErrorCode::Unavailable, "camera " + m_address.uri,
                    "another camera (" + (*inItsPlace)->identity().name + ") is in its place",
                    "plug " + m_identity.name + " in again");
    if (inItsPlace.error().code == ErrorCode::NotFound)
        return tl::unexpected(v4l2Failure(m_address.uri, ENODEV));
    return tl::unexpected(inItsPlace.error());
}

} // namespace odo
