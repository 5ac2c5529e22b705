// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/image_reader.h"

#include "core/video/internal/header_number.h"
#include "core/video/internal/heif.h"
#include "core/video/internal/riff.h"
#include "core/video/internal/tiff.h"

#include <cctype>
#include <string_view>

namespace odo {

namespace {

/// Walks the segments up to the first start of frame (ITU-T T.81 §B.1). A stuffed zero (ff 00) is no marker:
/// a decoder would search for the next one among the bytes that it would cover as a segment.
StatedSize jpegSize(std::span<const std::uint8_t> file)
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
            return {numberAt(file, at + 7, 2, true), numberAt(file, at + 5, 2, true)};
        at += 2 + numberAt(file, at + 2, 2, true);
    }
    return {};
}

/// "P5 640 480 255", with comments from # to the end of a line. The magic and each number end with white
/// space (the Netpbm formats' own rule): where they do not, decoders disagree on what is a comment.
StatedSize pnmSize(std::span<const std::uint8_t> file)
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
    return isSpace() ? StatedSize{numbers[0], numbers[1]} : StatedSize{};
}

/// Rows from the top have a negative height.
StatedSize bmpSize(std::span<const std::uint8_t> file)
{
    const auto height = static_cast<std::int32_t>(numberAt(file, 22, 4, false));
    return {numberAt(file, 18, 4, false),
            static_cast<std::uint32_t>(height < 0 ? -std::int64_t(height) : height)};
}

std::optional<ImageFormat> formatAtStart(std::span<const std::uint8_t> file)
{
    using namespace std::string_view_literals;
    if (hasAt(file, 0, "\x89PNG\r\n\x1a\n"sv))
        return ImageFormat::Png;
    if (hasAt(file, 0, "\xff\xd8\xff"sv))
        return ImageFormat::Jpeg;
    if (hasAt(file, 0, "BM"sv))
        return ImageFormat::Bmp;
    if (hasAt(file, 0, "II*\0"sv) || hasAt(file, 0, "MM\0*"sv))
        return ImageFormat::Tiff;
    if (isWebp(file))
        return ImageFormat::Webp;
    if (isHeif(file))
        return ImageFormat::Heif;
    if (file.size() > 2 && file[0] == 'P' && file[1] >= '1' && file[1] <= '6') {
        constexpr ImageFormat formats[] = {ImageFormat::Pbm, ImageFormat::Pgm, ImageFormat::Ppm};
        return formats[(file[1] - '1') % 3];
    }
    return std::nullopt;
}

StatedSize statedSize(ImageFormat format, std::span<const std::uint8_t> file)
{
    switch (format) {
    case ImageFormat::Png:
        return {numberAt(file, 16, 4, true), numberAt(file, 20, 4, true)};
    case ImageFormat::Jpeg:
        return jpegSize(file);
    case ImageFormat::Bmp:
        return bmpSize(file);
    case ImageFormat::Tiff:
        return hasPlainPixels(file) ? tiffSize(file) : StatedSize{};
    case ImageFormat::Webp:
        return webpSize(file);
    case ImageFormat::Heif:
        return heifSize(file);
    case ImageFormat::Pbm:
    case ImageFormat::Pgm:
    case ImageFormat::Ppm:
        return pnmSize(file);
    }
    return {};
}

} // namespace

bool startsAsImage(std::span<const std::uint8_t> file)
{
    return formatAtStart(file).has_value();
}

std::optional<ImageHeader> imageHeader(std::span<const std::uint8_t> file)
{
    const auto format = formatAtStart(file);
    if (!format)
        return std::nullopt;
    const StatedSize size = statedSize(*format, file);
    if (size.width == 0 || size.height == 0)
        return std::nullopt;
    return ImageHeader{*format, size.width, size.height};
}

} // namespace odo
