// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/jpeg_file.h"

#include <bit>
#include <cstdio>
#include <jpeglib.h>

namespace odo {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint8_t startOfImage = 0xd8, startOfScan = 0xda, huffmanTables = 0xc4, arithmeticTables = 0xcc,
                       jpegExtension = 0xc8;

struct Segment
{
    std::uint8_t marker = 0;
    std::size_t begin = 0; ///< of its marker in the file
    Bytes content;         ///< without marker and length
};

/// The segments before the coded picture, the start of the scan being the last; nothing where they do not
/// lead there.
std::vector<Segment> segmentsOf(Bytes jpeg)
{
    std::vector<Segment> segments;
    if (jpeg.size() < 4 || jpeg[0] != 0xff || jpeg[1] != startOfImage)
        return {};
    for (std::size_t at = 2; at + 4 <= jpeg.size();) {
        if (jpeg[at] != 0xff)
            return {};
        if (jpeg[at + 1] == 0xff) { // a byte that fills
            ++at;
            continue;
        }
        const std::size_t length = static_cast<std::size_t>(jpeg[at + 2] << 8 | jpeg[at + 3]);
        if (length < 2 || at + 2 + length > jpeg.size())
            return {};
        segments.push_back({jpeg[at + 1], at, jpeg.subspan(at + 4, length - 2)});
        if (segments.back().marker == startOfScan)
            return segments;
        at += 2 + length;
    }
    return {};
}

bool isFrameHeader(std::uint8_t marker)
{
    return marker >= 0xc0 && marker <= 0xcf && marker != huffmanTables && marker != jpegExtension &&
           marker != arithmeticTables;
}

/// Of luma's samples to chroma's; nullopt unless it is a power of two.
std::optional<int> shiftBetween(int luma, int chroma)
{
    if (chroma == 0 || luma % chroma != 0 || !std::has_single_bit(static_cast<unsigned>(luma / chroma)))
        return std::nullopt;
    return std::countr_zero(static_cast<unsigned>(luma / chroma));
}

std::optional<FrameFormat> formatOf(Bytes header)
{
    if (header.size() < 15 || header[5] != 3 || header[10] != header[13])
        return std::nullopt;
    FrameFormat format;
    format.height = header[1] << 8 | header[2];
    format.width = header[3] << 8 | header[4];
    const auto shiftX = shiftBetween(header[7] >> 4, header[10] >> 4),
               shiftY = shiftBetween(header[7] & 15, header[10] & 15);
    if (format.width == 0 || format.height == 0 || !shiftX || !shiftY)
        return std::nullopt;
    format.chromaShiftX = *shiftX;
    format.chromaShiftY = *shiftY;
    format.siting = ChromaSiting::Center;
    format.fullRange = true;
    return format;
}

void append(std::vector<std::uint8_t> &segment, int place, const JHUFF_TBL &table)
{
    segment.push_back(static_cast<std::uint8_t>(place));
    std::size_t values = 0;
    for (std::size_t length = 1; length <= 16; ++length) {
        segment.push_back(table.bits[length]);
        values += table.bits[length];
    }
    segment.insert(segment.end(), table.huffval, table.huffval + values);
}

/// What libjpeg sets by itself for an encoder are the tables of Annex K.3.
std::vector<std::uint8_t> standardTables()
{
    jpeg_error_mgr errors{};
    jpeg_compress_struct encoder{};
    encoder.err = jpeg_std_error(&errors);
    jpeg_create_compress(&encoder);
    encoder.in_color_space = JCS_YCbCr;
    encoder.input_components = 3;
    jpeg_set_defaults(&encoder);
    std::vector<std::uint8_t> segment{0xff, huffmanTables, 0, 0};
    for (int i = 0; i < 2; ++i) {
        append(segment, i, *encoder.dc_huff_tbl_ptrs[i]);
        append(segment, 0x10 | i, *encoder.ac_huff_tbl_ptrs[i]);
    }
    jpeg_destroy_compress(&encoder);
    const std::size_t length = segment.size() - 2;
    segment[2] = static_cast<std::uint8_t>(length >> 8);
    segment[3] = static_cast<std::uint8_t>(length & 0xff);
    return segment;
}

} // namespace

std::optional<FrameFormat> jpegFormat(Bytes jpeg)
{
    for (const Segment &segment : segmentsOf(jpeg)) {
        if (isFrameHeader(segment.marker))
            return formatOf(segment.content);
    }
    return std::nullopt;
}

std::vector<std::uint8_t> withHuffmanTables(Bytes jpeg)
{
    const std::vector<Segment> segments = segmentsOf(jpeg);
    bool missing = !segments.empty();
    for (const Segment &segment : segments)
        missing = missing && segment.marker != huffmanTables;
    if (!missing)
        return {jpeg.begin(), jpeg.end()};
    static const std::vector<std::uint8_t> tables = standardTables();
    const auto scan = jpeg.begin() + static_cast<std::ptrdiff_t>(segments.back().begin);
    std::vector<std::uint8_t> whole;
    whole.reserve(jpeg.size() + tables.size());
    whole.insert(whole.end(), jpeg.begin(), scan);
    whole.insert(whole.end(), tables.begin(), tables.end());
    whole.insert(whole.end(), scan, jpeg.end());
    return whole;
}

} // namespace odo
