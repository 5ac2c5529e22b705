// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace odo::test {

/// Big-endian numbers, as they travel in GVCP and GVSP (AIA, GigE Vision 2.0).
std::uint32_t readBig32(const std::uint8_t *bytes);
std::uint16_t readBig16(const std::uint8_t *bytes);
void writeBig32(std::uint8_t *bytes, std::uint32_t value);
void writeBig16(std::uint8_t *bytes, std::uint16_t value);

/// Addresses of a simulated camera's registers: those that GigE Vision lays down (table 28-1), and its own
/// from 0x1000 on.
namespace reg {
enum Address : std::uint32_t {
    Version = 0x0000,
    DeviceMode = 0x0004,
    MacHigh = 0x0008,
    MacLow = 0x000c,
    IpConfiguration = 0x0014,
    Ip = 0x0024,
    Vendor = 0x0048,
    Model = 0x0068,
    DeviceVersion = 0x0088,
    Serial = 0x00d8,
    XmlUrl = 0x0200,
    Interfaces = 0x0600,
    StreamChannels = 0x0904,
    Capability = 0x0934,
    HeartbeatTimeout = 0x0938,
    TickFrequencyHigh = 0x093c,
    TickFrequencyLow = 0x0940,
    TimestampControl = 0x0944,
    TimestampHigh = 0x0948,
    TimestampLow = 0x094c,
    ControlPrivilege = 0x0a00,
    StreamPort = 0x0d00,
    PacketSize = 0x0d04,
    PacketDelay = 0x0d08,
    StreamAddress = 0x0d18,

    SensorWidth = 0x1000,
    SensorHeight = 0x1004,
    Width = 0x1008,
    Height = 0x100c,
    OffsetX = 0x1010,
    OffsetY = 0x1014,
    PixelFormat = 0x1018,
    Payload = 0x101c,
    Acquisition = 0x1020,
    AcquisitionMode = 0x1024,
    FrameRate = 0x1028,    ///< float
    ExposureTime = 0x102c, ///< float, microseconds
    ExposureAuto = 0x1030,
    Gain = 0x1034, ///< float, dB
    GainAuto = 0x1038,
    TriggerMode = 0x103c,
    TriggerSource = 0x1040,
    TriggerActivation = 0x1044,
    TriggerSelector = 0x1048,
    TriggerSoftware = 0x104c,
    XmlText = 0x4000,
    End = 0x10000
};
} // namespace reg

/// The memory of a simulated camera. Not thread-safe.
class GigeRegisters
{
public:
    GigeRegisters() : m_bytes(reg::End) {}

    bool holds(std::uint32_t address, std::size_t size) const
    {
        return address % 4 == 0 && address + size <= m_bytes.size();
    }
    std::uint32_t get(std::uint32_t address) const { return readBig32(m_bytes.data() + address); }
    void set(std::uint32_t address, std::uint32_t value) { writeBig32(m_bytes.data() + address, value); }
    float getFloat(std::uint32_t address) const;
    void setFloat(std::uint32_t address, float value);
    void setText(std::uint32_t address, const std::string &text);
    std::span<const std::uint8_t> bytes(std::uint32_t address, std::size_t size) const
    {
        return {m_bytes.data() + address, size};
    }

private:
    std::vector<std::uint8_t> m_bytes;
};

} // namespace odo::test
