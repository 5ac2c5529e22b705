// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/gige/gige_packets.h"

#include "tests/support/gige/gige_registers.h"

#include <algorithm>

namespace odo::test {

namespace {

enum class Kind : std::uint32_t { Leader = 1, Trailer = 2, Payload = 3 };
constexpr std::size_t packetHeader = 8, ipAndUdpHeaders = 28;
constexpr std::uint16_t imagePayload = 1, packetUnavailable = 0x800c;

Packet emptyPacket(Kind kind, std::uint16_t imageId, std::uint32_t number, std::size_t size)
{
    Packet packet(packetHeader + size);
    writeBig16(&packet[2], imageId);
    writeBig32(&packet[4], static_cast<std::uint32_t>(kind) << 24 | number);
    return packet;
}

Packet leaderOf(const GigeImage &image)
{
    Packet leader = emptyPacket(Kind::Leader, image.id, 0, 36);
    std::uint8_t *content = leader.data() + packetHeader;
    writeBig16(content + 2, imagePayload);
    writeBig32(content + 4, static_cast<std::uint32_t>(image.ticks >> 32));
    writeBig32(content + 8, static_cast<std::uint32_t>(image.ticks));
    writeBig32(content + 12, image.pixelFormat);
    writeBig32(content + 16, image.width);
    writeBig32(content + 20, image.height);
    return leader;
}

Packet trailerOf(const GigeImage &image, std::uint32_t number)
{
    Packet trailer = emptyPacket(Kind::Trailer, image.id, number, 8);
    writeBig16(&trailer[packetHeader + 2], imagePayload);
    writeBig32(&trailer[packetHeader + 4], image.height);
    return trailer;
}

} // namespace

std::vector<Packet> packetsOf(const GigeImage &image, std::span<const std::uint8_t> pixels,
                              std::size_t packetSize)
{
    const std::size_t block = packetSize - ipAndUdpHeaders - packetHeader;
    std::vector<Packet> packets{leaderOf(image)};
    for (std::size_t at = 0; at < pixels.size(); at += block) {
        const auto part = pixels.subspan(at, std::min(block, pixels.size() - at));
        packets.push_back(
            emptyPacket(Kind::Payload, image.id, static_cast<std::uint32_t>(packets.size()), part.size()));
        std::ranges::copy(part, packets.back().begin() + packetHeader);
    }
    packets.push_back(trailerOf(image, static_cast<std::uint32_t>(packets.size())));
    return packets;
}

Packet unavailablePacket(std::uint16_t imageId, std::uint32_t packet)
{
    Packet answer(packetHeader);
    writeBig16(&answer[0], packetUnavailable);
    writeBig16(&answer[2], imageId);
    writeBig32(&answer[4], static_cast<std::uint32_t>(Kind::Payload) << 24 | packet);
    return answer;
}

} // namespace odo::test
