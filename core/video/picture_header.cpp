// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/picture_header.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>

namespace odo {

namespace {

using Bytes = std::span<const std::uint8_t>;

struct Size
{
    std::uint32_t width = 0, height = 0;
};

/// A number of `count` bytes at `at`; 0 where the file ends before it, which no size can be.
std::uint32_t number(Bytes file, std::size_t at, std::size_t count, bool bigEndian)
{
    if (at > file.size() || count > file.size() - at)
        return 0;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
        value = value << 8 | file[bigEndian ? at + i : at + count - 1 - i];
    return value;
}

bool startsWith(Bytes file, std::string_view magic)
{
    return std::string_view(reinterpret_cast<const char *>(file.data()), file.size()).starts_with(magic);
}

/// Walks the segments up to the first start of frame (ITU-T T.81 §B.1). A stuffed zero (ff 00) is no marker:
/// a decoder would look for the next one among the bytes that it would cover as a segment.
Size jpegSize(Bytes file)
{
    std::size_t at = 2;
    while (at + 9 < file.size()) {
        const std::uint8_t marker = file[at + 1];
        if (file[at] != 0xff || marker == 0x00)
            return {};
        if (marker == 0xff || marker == 0x01 ||
            (marker >= 0xd0 && marker <= 0xd7)) { // fill byte or bare marker
            at += marker == 0xff ? 1 : 2;
            continue;
        }
        const bool startOfFrame =
            marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (startOfFrame)
            return {number(file, at + 7, 2, true), number(file, at + 5, 2, true)};
        at += 2 + number(file, at + 2, 2, true);
    }
    return {};
}

/// The first image file directory (TIFF 6.0 §2): ImageWidth 256, ImageLength 257, TileWidth 322, TileLength
/// 323, each of them once and SHORT or LONG. What is stated otherwise is refused: which size a decoder takes
/// then is its choice.
Size tiffSize(Bytes file, bool bigEndian)
{
    constexpr std::uint32_t tags[] = {256, 257, 322, 323}, shortNumber = 3, longNumber = 4;
    const std::size_t directory = number(file, 4, 4, bigEndian);
    const std::uint32_t entries = number(file, directory, 2, bigEndian);
    std::uint32_t values[std::size(tags)] = {};
    for (std::uint32_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + std::size_t(12) * i;
        const auto tag = std::ranges::find(tags, number(file, entry, 2, bigEndian));
        if (tag == std::end(tags))
            continue;
        const std::uint32_t type = number(file, entry + 2, 2, bigEndian);
        std::uint32_t &value = values[tag - std::begin(tags)];
        if ((type != shortNumber && type != longNumber) || value != 0)
            return {};
        value = number(file, entry + 8, type == shortNumber ? 2 : 4, bigEndian);
    }
    if (values[0] == 0 || values[1] == 0)
        return {};
    return {std::max(values[0], values[2]), std::max(values[1], values[3])}; // tiles are decoded whole
}

/// "P5 640 480 255", with comments from # to the end of a line. The magic and each number end with white
/// space (the Netpbm formats' own rule): where they do not, decoders disagree on what is a comment.
Size pnmSize(Bytes file)
{
    std::uint32_t numbers[2] = {};
    std::size_t at = 2;
    const auto isSpace = [&] { return at < file.size() && std::isspace(file[at]) != 0; };
    for (std::uint32_t &value : numbers) {
        if (!isSpace())
            return {};
        while (isSpace() || (at < file.size() && file[at] == '#'))
            if (file[at++] == '#')
                while (at < file.size() && file[at] != '\n' && file[at] != '\r')
                    ++at;
        for (int digits = 0; at < file.size() && std::isdigit(file[at]) != 0 && digits < 9; ++at, ++digits)
            value = value * 10 + (file[at] - '0');
    }
    return isSpace() ? Size{numbers[0], numbers[1]} : Size{};
}

/// Rows from the top have a negative height.
Size bmpSize(Bytes file)
{
    const auto height = static_cast<std::int32_t>(number(file, 22, 4, false));
    return {number(file, 18, 4, false),
            static_cast<std::uint32_t>(height < 0 ? -std::int64_t(height) : height)};
}

PictureHeader header(PictureFormat format, Size size)
{
    return {format, size.width, size.height};
}

PictureHeader statedHeader(Bytes file)
{
    using namespace std::string_view_literals;
    if (startsWith(file, "\x89PNG\r\n\x1a\n"sv))
        return header(PictureFormat::Png, {number(file, 16, 4, true), number(file, 20, 4, true)});
    if (startsWith(file, "\xff\xd8\xff"sv))
        return header(PictureFormat::Jpeg, jpegSize(file));
    if (startsWith(file, "BM"sv))
        return header(PictureFormat::Bmp, bmpSize(file));
    if (startsWith(file, "II*\0"sv) || startsWith(file, "MM\0*"sv))
        return header(PictureFormat::Tiff, tiffSize(file, file[0] == 'M'));
    if (file.size() > 2 && file[0] == 'P' && file[1] >= '1' && file[1] <= '6') {
        constexpr PictureFormat formats[] = {PictureFormat::Pbm, PictureFormat::Pgm, PictureFormat::Ppm};
        return header(formats[(file[1] - '1') % 3], pnmSize(file));
    }
    return {};
}

} // namespace

std::optional<PictureHeader> pictureHeader(Bytes file)
{
    const PictureHeader stated = statedHeader(file);
    return stated.width > 0 && stated.height > 0 ? std::optional(stated) : std::nullopt;
}

} // namespace odo
