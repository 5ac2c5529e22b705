// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/aravis_address.h"

#include "core/capture/camera_source.h"

#include <cmath>

namespace odo {

namespace {

constexpr std::string_view scheme = "aravis:";

std::optional<double> positive(std::string_view text)
{
    const auto number = parseNumber(text);
    if (!number || *number <= 0)
        return std::nullopt;
    return *number;
}

std::optional<int> wholePixels(std::string_view text)
{
    const auto number = positive(text);
    if (!number || *number != std::floor(*number) || *number > 65535)
        return std::nullopt;
    return static_cast<int>(*number);
}

bool setSize(AravisAddress &address, std::string_view value)
{
    const std::size_t times = value.find('x');
    if (times == std::string_view::npos)
        return false;
    const auto width = wholePixels(value.substr(0, times)), height = wholePixels(value.substr(times + 1));
    if (!width || !height)
        return false;
    address.sizePx = {*width, *height};
    return true;
}

bool setTime(std::optional<Nanoseconds> &time, std::string_view value, double unitS)
{
    const auto number = positive(value);
    if (number)
        time = fromSeconds(*number * unitS);
    return number.has_value();
}

/// False for what is not understood.
bool applySetting(AravisAddress &address, std::string_view name, std::string_view value)
{
    if (name == "rate")
        return (address.framesPerSecond = positive(value)).has_value();
    if (name == "exposure_ms")
        return setTime(address.exposure, value, 1e-3);
    if (name == "packet_delay_us")
        return setTime(address.packetDelay, value, 1e-6);
    if (name == "packet_size")
        return (address.packetSize = wholePixels(value)).has_value();
    if (name == "size")
        return setSize(address, value);
    if (name == "gain") {
        const auto number = parseNumber(value);
        if (number)
            address.gain = *number;
        return number.has_value();
    }
    if (name == "format" && !value.empty()) {
        address.format = std::string(value);
        return true;
    }
    if (name == "trigger" && value == "software") {
        address.trigger = AravisAddress::Trigger::Software;
        return true;
    }
    return false;
}

} // namespace

bool isAravisAddress(const std::string &uri)
{
    return uri.starts_with(scheme);
}

Result<AravisAddress> parseAravisAddress(const std::string &uri)
{
    CameraUri split = splitCameraUri(uri, scheme);
    AravisAddress address;
    address.uri = uri;
    address.location = std::move(split.location);
    if (address.location.empty())
        return fail(
            ErrorCode::InvalidInput, cameraAtAddress(uri),
            ODO_TEXT("capture.aravis_place_missing", "it contains neither an address nor a serial number"),
            joined({ODO_TEXT("capture.give_aravis_place", "give one as aravis:192.168.1.20 or aravis:SERIAL"),
                    ODO_TEXT("capture.cameras_are_listed", "odograph cameras lists them")},
                   Join::Semicolon));
    for (const CameraSetting &setting : split.cameraSettings) {
        if (!applySetting(address, setting.name, setting.value))
            return notUnderstood(uri, setting.text,
                                 ODO_TEXT("capture.aravis_wishes",
                                          "use rate, exposure_ms, gain, format, size, trigger=software, "
                                          "packet_size or packet_delay_us, as in ?rate=30&size=640x480"));
    }
    return address;
}

} // namespace odo
