// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/ssl_vision.h"

#include "core/base/units.h"

#include <bit>

namespace odo {

namespace {

/// Writes the fields of one message (Protocol Buffers' encoding: a tag of number and wire type, then the
/// value).
class WireMessage
{
public:
    void whole(unsigned field, std::uint64_t value)
    {
        tag(field, 0);
        varint(value);
    }
    void real(unsigned field, double value)
    {
        tag(field, 1);
        littleEndian(std::bit_cast<std::uint64_t>(value), 8);
    }
    void shortReal(unsigned field, double value)
    {
        tag(field, 5);
        littleEndian(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
    }
    void message(unsigned field, const WireMessage &inner)
    {
        tag(field, 2);
        varint(inner.m_bytes.size());
        m_bytes += inner.m_bytes;
    }
    const std::string &bytes() const { return m_bytes; }

private:
    void tag(unsigned field, unsigned wireType) { varint(field << 3 | wireType); }
    void varint(std::uint64_t value)
    {
        for (; value >= 0x80; value >>= 7)
            m_bytes += static_cast<char>(0x80 | (value & 0x7f));
        m_bytes += static_cast<char>(value);
    }
    void littleEndian(std::uint64_t bits, int bytes)
    {
        for (int i = 0; i < bytes; ++i)
            m_bytes += static_cast<char>(bits >> 8 * i & 0xff);
    }

    std::string m_bytes;
};

WireMessage robotMessage(const SslRobot &robot)
{
    WireMessage message;
    message.shortReal(1, robot.confidence);
    message.whole(2, robot.id);
    message.shortReal(3, toMillimetres(robot.xM));
    message.shortReal(4, toMillimetres(robot.yM));
    if (robot.yawRad)
        message.shortReal(5, *robot.yawRad);
    message.shortReal(6, 0);
    message.shortReal(7, 0);
    if (robot.heightM)
        message.shortReal(8, toMillimetres(*robot.heightM));
    return message;
}

} // namespace

std::string sslVisionPacket(const SslFrame &frame)
{
    WireMessage detection;
    detection.whole(1, frame.number);
    detection.real(2, frame.capturedS);
    detection.real(3, frame.sentS);
    detection.whole(4, frame.camera);
    for (const bool isYellow : {true, false}) {
        for (const SslRobot &robot : frame.robots) {
            if (robot.isYellow == isYellow)
                detection.message(isYellow ? 6 : 7, robotMessage(robot));
        }
    }
    WireMessage packet;
    packet.message(1, detection);
    return packet.bytes();
}

} // namespace odo
