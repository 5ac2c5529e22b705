// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/vm/uvc_descriptors.h"

namespace odo::test {

namespace {

constexpr std::uint8_t videoControl = 0x24, interfaceDescriptor = 4, videoClass = 0x0e;
constexpr std::uint8_t uncompressedFrame = 5, mjpegFrame = 7;

void append(UsbBytes &to, const UsbBytes &from)
{
    to.insert(to.end(), from.begin(), from.end());
}

void setLength(UsbBytes &bytes, std::size_t at)
{
    bytes[at] = static_cast<std::uint8_t>(bytes.size());
    bytes[at + 1] = static_cast<std::uint8_t>(bytes.size() >> 8);
}

UsbBytes frames(std::uint8_t kind)
{
    UsbBytes all;
    for (std::size_t i = 0; i < uvcSizes.size(); ++i) {
        const std::uint32_t bytes = uvcSizes[i].widthPx * uvcSizes[i].heightPx * 2U;
        UsbBytes frame{static_cast<std::uint8_t>(26 + 4 * uvcPeriods.size()), videoControl, kind,
                       static_cast<std::uint8_t>(i + 1), 0};
        put16(frame, uvcSizes[i].widthPx);
        put16(frame, uvcSizes[i].heightPx);
        put32(frame, bytes * 8 * 5);
        put32(frame, bytes * 8 * 30);
        put32(frame, bytes);
        put32(frame, uvcPeriods[0]);
        frame.push_back(uvcPeriods.size());
        for (const std::uint32_t period : uvcPeriods)
            put32(frame, period);
        append(all, frame);
    }
    return all;
}

UsbBytes formats()
{
    const UsbBytes colours{6, videoControl, 0x0d, 1, 1, 4};
    UsbBytes all{27,
                 videoControl,
                 4,
                 1,
                 uvcSizes.size(),
                 'Y',
                 'U',
                 'Y',
                 '2',
                 0,
                 0,
                 0x10,
                 0,
                 0x80,
                 0,
                 0,
                 0xaa,
                 0,
                 0x38,
                 0x9b,
                 0x71,
                 16,
                 1,
                 0,
                 0,
                 0,
                 0};
    append(all, frames(uncompressedFrame));
    append(all, colours);
    append(all, {11, videoControl, 6, 2, uvcSizes.size(), 1, 1, 0, 0, 0, 0});
    append(all, frames(mjpegFrame));
    append(all, colours);
    return all;
}

} // namespace

void put16(UsbBytes &bytes, unsigned value)
{
    bytes.push_back(static_cast<std::uint8_t>(value));
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
}

void put32(UsbBytes &bytes, std::uint32_t value)
{
    put16(bytes, value & 0xffff);
    put16(bytes, value >> 16);
}

std::uint32_t get32(std::span<const std::uint8_t> bytes)
{
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8 | static_cast<std::uint32_t>(bytes[2]) << 16 |
           static_cast<std::uint32_t>(bytes[3]) << 24;
}

UsbBytes deviceDescriptor()
{
    return {18, 1, 0x00, 0x02, 0xef, 2, 1, 64, 0x6b, 0x1d, 0x42, 0x42, 0x00, 0x01, 1, 2, 3, 1};
}

UsbBytes configurationDescriptor()
{
    UsbBytes control{13, videoControl, 1, 0x00, 0x01, 0, 0, 0x80, 0x8d, 0x5b, 0x00, 1, 1};
    // Exposure: mode, priority, time; focus, and its automatic.
    append(control,
           {18, videoControl, 2, uvcTerminal, 0x01, 0x02, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0x2e, 0x00, 0x02});
    // Brightness, white balance, gain; the automatic of white balance.
    append(control, {11, videoControl, 5, uvcProcessing, uvcTerminal, 0, 0, 2, 0x41, 0x12, 0});
    append(control, {9, videoControl, 3, 3, 0x01, 0x01, 0, uvcProcessing, 0}); // where it leaves
    setLength(control, 5);

    UsbBytes streaming{15, videoControl, 1, 2, 0, 0, uvcEndpoint, 0, 3, 0, 0, 0, 1, 0, 0};
    append(streaming, formats());
    setLength(streaming, 4);

    UsbBytes all{9, 2, 0, 0, 2, 1, 0, 0x80, 250};
    append(all, {8, 11, 0, 2, videoClass, 3, 0, 2});
    append(all, {9, interfaceDescriptor, 0, 0, 0, videoClass, 1, 0, 2});
    append(all, control);
    append(all, {9, interfaceDescriptor, 1, 0, 1, videoClass, 2, 0, 0});
    append(all, streaming);
    append(all, {7, 5, uvcEndpoint, 2, 0x00, 0x02, 0});
    setLength(all, 2);
    return all;
}

UsbBytes stringDescriptor(const std::string &text)
{
    UsbBytes bytes{static_cast<std::uint8_t>(2 + 2 * text.size()), 3};
    for (const char c : text)
        put16(bytes, static_cast<unsigned char>(c));
    return bytes;
}

} // namespace odo::test
