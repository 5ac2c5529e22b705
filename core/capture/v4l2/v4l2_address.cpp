// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/v4l2_address.h"

#include "core/base/file_system.h"
#include "core/capture/camera_source.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <linux/videodev2.h>
#include <string_view>

namespace odo {

namespace {

tl::unexpected<Error> v4l2NotUnderstood(const std::string &uri, const std::string &part)
{
    return notUnderstood(uri, part,
                         ODO_TEXT("capture.v4l2_address_example",
                                  "write it like v4l2:/dev/video0?size=1280x720&rate=30&format=MJPG"));
}

template <class Number>
std::optional<Number> numberIn(std::string_view text)
{
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || !(number > 0))
        return std::nullopt;
    return number;
}

bool readSize(std::string_view value, V4l2Request &request)
{
    const std::size_t x = value.find('x');
    if (x == std::string_view::npos)
        return false;
    request.widthPx = numberIn<int>(value.substr(0, x));
    request.heightPx = numberIn<int>(value.substr(x + 1));
    return request.widthPx && request.heightPx;
}

bool readFormat(std::string_view value, V4l2Request &request)
{
    if (value.empty() || value.size() > 4)
        return false;
    const auto letter = [&](std::size_t i) { return i < value.size() ? value[i] : ' '; };
    request.format = v4l2_fourcc(letter(0), letter(1), letter(2), letter(3));
    return true;
}

bool readSetting(const CameraSetting &setting, V4l2Request &request)
{
    if (setting.name == "size")
        return readSize(setting.value, request);
    if (setting.name == "format")
        return readFormat(setting.value, request);
    if (setting.name != "rate")
        return false;
    request.framesPerSecond = numberIn<double>(setting.value);
    return request.framesPerSecond && std::isfinite(*request.framesPerSecond);
}

} // namespace

bool isV4l2Address(const std::string &uri)
{
    return uri.starts_with(v4l2Scheme);
}

Result<V4l2Address> parseV4l2Address(const std::string &uri)
{
    CameraUri split = splitCameraUri(uri, v4l2Scheme);
    V4l2Address address{uri, std::move(split.location), {}};
    if (address.location.empty())
        return v4l2NotUnderstood(uri, uri);
    for (const CameraSetting &setting : split.cameraSettings) {
        if (!readSetting(setting, address.request))
            return v4l2NotUnderstood(uri, setting.text);
    }
    return address;
}

Result<std::shared_ptr<V4l2Device>> openV4l2Device(const V4l2Address &address)
{
    if (address.location.starts_with('/')) {
        std::error_code error;
        const std::filesystem::path node = files::realPath(address.location, error); // sysfs knows no links
        return V4l2Device::open(error ? std::filesystem::path(address.location) : node, address.uri);
    }
    for (auto &device : openV4l2Devices()) {
        if (device->identity().busInfo == address.location)
            return std::move(device);
    }
    return tl::unexpected(v4l2Failure(address.uri, ENOENT));
}

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
    const auto inItsPlace = openV4l2Device(m_address);
    if (inItsPlace)
        return fail(ErrorCode::Unavailable, cameraAtAddress(m_address.uri),
                    ODO_TEXT("capture.other_camera_in_place",
                             "another camera (%1) has replaced it")((*inItsPlace)->identity().name),
                    ODO_TEXT("capture.plug_camera_in_again", "plug %1 in again")(m_identity.name));
    if (inItsPlace.error().code == ErrorCode::NotFound)
        return tl::unexpected(v4l2Failure(m_address.uri, ENODEV));
    return tl::unexpected(inItsPlace.error());
}

} // namespace odo
