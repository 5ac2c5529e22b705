// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace odo::test {

using UsbBytes = std::vector<std::uint8_t>;

struct UvcSize
{
    std::uint16_t widthPx, heightPx;
};
constexpr std::array<UvcSize, 2> uvcSizes{{{640, 480}, {320, 240}}};
constexpr std::array<std::uint32_t, 3> uvcPeriods{333333, 666666, 2000000}; ///< in 100 ns
constexpr std::uint8_t uvcEndpoint = 0x81;
constexpr std::uint8_t uvcTerminal = 1, uvcProcessing = 2; ///< the entities that have controls

void put16(UsbBytes &bytes, unsigned value);
void put32(UsbBytes &bytes, std::uint32_t value);
std::uint32_t get32(std::span<const std::uint8_t> bytes);

/// The descriptors (USB 2.0 §9.6; USB Video Class 1.0 §3) of a webcam with a bulk endpoint that gives YUYV
/// and MJPEG, with exposure, focus, brightness, gain and white balance, the automatic ones too.
UsbBytes deviceDescriptor();
UsbBytes configurationDescriptor();
UsbBytes stringDescriptor(const std::string &text);

} // namespace odo::test
