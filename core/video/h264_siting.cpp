// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/h264_siting.h"

#include <algorithm>
#include <array>
#include <vector>

namespace odo {

namespace {

using Bytes = std::span<const std::uint8_t>;

/// Reads a raw byte sequence payload bit by bit; beyond its end it gives zeros and remembers.
class BitReader
{
public:
    explicit BitReader(Bytes data)
    {
        // Emulation prevention: 00 00 03 stands for 00 00 (§7.4.1).
        int zeros = 0;
        for (const std::uint8_t byte : data) {
            if (zeros >= 2 && byte == 3) {
                zeros = 0;
                continue;
            }
            zeros = byte == 0 ? zeros + 1 : 0;
            m_bytes.push_back(byte);
        }
    }
    unsigned bits(int count)
    {
        unsigned value = 0;
        for (int i = 0; i < count; ++i)
            value = value << 1 | bit();
        return value;
    }
    bool flag() { return bit() != 0; }
    /// Exp-Golomb, unsigned (§9.1). A signed one has the same length, and none of their values is needed
    /// here.
    unsigned golomb()
    {
        int zeros = 0;
        while (!exhausted() && bit() == 0)
            ++zeros;
        return zeros > 31 ? 0 : (1U << zeros) - 1 + bits(zeros);
    }
    bool exhausted() const { return m_at > m_bytes.size() * 8; }

private:
    unsigned bit()
    {
        const std::size_t at = m_at++;
        return at / 8 < m_bytes.size() ? m_bytes[at / 8] >> (7 - at % 8) & 1U : 0U;
    }
    std::vector<std::uint8_t> m_bytes;
    std::size_t m_at = 0;
};

constexpr unsigned sequenceParameterSet = 7;

/// The payload of the first sequence parameter set after its header byte; empty when there is none.
Bytes findParameterSet(Bytes data)
{
    if (data.size() > 8 &&
        data[0] == 1) { // avcC: version, profile, compatibility, level, lengths, count, size
        const std::size_t size = static_cast<std::size_t>(data[6]) << 8 | data[7];
        return (data[5] & 0x1f) > 0 && size > 1 && 8 + size <= data.size() ? data.subspan(9, size - 1)
                                                                           : Bytes();
    }
    for (std::size_t i = 0; i + 4 < data.size(); ++i)
        if (data[i] == 0 && data[i + 1] == 0 && data[i + 2] == 1 &&
            (data[i + 3] & 0x1f) == sequenceParameterSet)
            return data.subspan(i + 4);
    return {};
}

void skipScalingList(BitReader &reader, int size)
{
    unsigned last = 8, next = 8;
    for (int i = 0; i < size && !reader.exhausted(); ++i) {
        if (next != 0) {
            const unsigned code = reader.golomb();
            const unsigned delta = code % 2 == 1 ? code / 2 + 1 : 0U - code / 2; // of any size where the file is damaged
            next = (last + delta) % 256;
        }
        last = next == 0 ? last : next;
    }
}

void skipHighProfileFields(BitReader &reader)
{
    const unsigned chromaFormat = reader.golomb();
    if (chromaFormat == 3)
        reader.flag();
    reader.golomb(); // bit depths
    reader.golomb();
    reader.flag();
    if (!reader.flag())
        return;
    for (int i = 0; i < (chromaFormat == 3 ? 12 : 8); ++i)
        if (reader.flag())
            skipScalingList(reader, i < 6 ? 16 : 64);
}

bool isHighProfile(unsigned profile)
{
    constexpr std::array high{100U, 110U, 122U, 244U, 44U, 83U, 86U, 118U, 128U, 138U, 139U, 134U, 135U};
    return std::ranges::find(high, profile) != high.end();
}

/// Everything of the parameter set before vui_parameters_present_flag.
void skipToVui(BitReader &reader)
{
    const unsigned profile = reader.bits(8);
    reader.bits(16);
    reader.golomb();
    if (isHighProfile(profile))
        skipHighProfileFields(reader);
    reader.golomb(); // log2_max_frame_num
    const unsigned orderType = reader.golomb();
    if (orderType == 0) {
        reader.golomb();
    } else if (orderType == 1) {
        reader.flag();
        reader.golomb();
        reader.golomb();
        for (unsigned i = reader.golomb(); i > 0 && !reader.exhausted(); --i)
            reader.golomb();
    }
    reader.golomb(); // reference frames
    reader.flag();
    reader.golomb(); // width
    reader.golomb(); // height
    if (!reader.flag())
        reader.flag();
    reader.flag();
    if (reader.flag()) // cropping
        for (int i = 0; i < 4; ++i)
            reader.golomb();
}

} // namespace

std::optional<unsigned> h264ChromaLocation(Bytes data)
{
    constexpr unsigned extendedAspect = 255;
    BitReader reader(findParameterSet(data));
    skipToVui(reader);
    if (!reader.flag()) // vui_parameters_present_flag
        return std::nullopt;
    if (reader.flag() && reader.bits(8) == extendedAspect)
        reader.bits(32);
    if (reader.flag()) // overscan
        reader.flag();
    if (reader.flag()) { // video signal type
        reader.bits(4);
        if (reader.flag())
            reader.bits(24);
    }
    if (!reader.flag()) // chroma_loc_info_present_flag
        return std::nullopt;
    const unsigned location = reader.golomb();
    return reader.exhausted() || location > 5 ? std::nullopt : std::optional(location);
}

} // namespace odo
