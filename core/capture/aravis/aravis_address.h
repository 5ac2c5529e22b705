// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"

#include <optional>
#include <string>
#include <utility>

namespace odo {

/// What an address of a GigE Vision or USB3 Vision camera says: "aravis:192.168.1.20" or "aravis:SERIAL", and
/// behind a '?', joined by
/// '&', the requested settings: rate=30 (frames/s), exposure_ms=5, gain=6 (as the camera counts it),
/// format=BayerRG8, size=640x480, trigger=software, packet_size=9000 (bytes), packet_delay_us=10. What is not
/// said stays as the camera has it, but for the format, which is the best one for tracking.
struct AravisAddress
{
    enum class Trigger { None, Software };

    std::string uri;
    std::string location; ///< an IPv4 address or a serial number
    std::optional<double> framesPerSecond, gain;
    std::optional<Nanoseconds> exposure, packetDelay;
    std::optional<std::string> format;
    std::optional<std::pair<int, int>> sizePx; ///< width and height
    std::optional<int> packetSize;
    Trigger trigger = Trigger::None;
};

/// True for the addresses of this kind.
bool isAravisAddress(const std::string &uri);

/// Errors: InvalidInput for what is not understood.
Result<AravisAddress> parseAravisAddress(const std::string &uri);

} // namespace odo
