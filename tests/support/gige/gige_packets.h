// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace odo::test {

/// A picture as GVSP tells it in its leader.
struct GigeImage
{
    std::uint16_t id = 0;
    std::uint64_t ticks = 0;
    std::uint32_t pixelFormat = 0, width = 0, height = 0;
};

using Packet = std::vector<std::uint8_t>;

/// The packets of one picture: leader, payload, trailer (GigE Vision 2.0, 24 and 25.3). packetSize: with IP
/// and UDP headers.
std::vector<Packet> packetsOf(const GigeImage &image, std::span<const std::uint8_t> pixels,
                              std::size_t packetSize);

/// What a camera says when a packet that is asked for again is not there any more.
Packet unavailablePacket(std::uint16_t imageId, std::uint32_t packet);

} // namespace odo::test
