// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/orientation.h"

#include "core/video/internal/header_number.h"
#include "core/video/internal/riff.h"

#include <algorithm>
#include <string_view>

namespace odo {

namespace {

using ExifBytes = std::span<const std::uint8_t>;

/// Of a TIFF file, and of EXIF, which is one.
int orientationOfTiff(ExifBytes file)
{
    using namespace std::string_view_literals;
    const bool bigEndian = hasAt(file, 0, "MM\0*"sv);
    if (!bigEndian && !hasAt(file, 0, "II*\0"sv))
        return 1;
    constexpr std::uint32_t orientationTag = 274, shortNumber = 3;
    const std::size_t directory = numberAt(file, 4, 4, bigEndian);
    const std::uint32_t entries = numberAt(file, directory, 2, bigEndian);
    for (std::uint32_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + std::size_t(12) * i;
        if (numberAt(file, entry, 2, bigEndian) != orientationTag)
            continue;
        const std::uint32_t value = numberAt(file, entry + 8, 2, bigEndian);
        const bool isKnown =
            numberAt(file, entry + 2, 2, bigEndian) == shortNumber && value >= 1 && value <= 8;
        return isKnown ? int(value) : 1;
    }
    return 1;
}

constexpr std::string_view exifMark("Exif\0\0", 6);

int orientationOfJpeg(ExifBytes file)
{
    std::size_t at = 2;
    while (at + 4 <= file.size() && file[at] == 0xff) {
        const std::uint8_t marker = file[at + 1];
        if (marker == 0xff) { // fill byte
            ++at;
            continue;
        }
        if (marker == 0xda || marker == 0xd9)
            return 1;
        const std::size_t length = numberAt(file, at + 2, 2, true), end = at + 2 + length;
        if (length < 2 || end > file.size())
            return 1;
        const std::size_t content = at + 4 + exifMark.size();
        if (marker == 0xe1 && content <= end && hasAt(file, at + 4, exifMark))
            return orientationOfTiff(file.subspan(content, end - content));
        at = end;
    }
    return 1;
}

int orientationOfPng(ExifBytes file)
{
    std::size_t at = 8;
    while (at + 12 <= file.size()) {
        const std::size_t length = numberAt(file, at, 4, true);
        if (length > file.size() - at - 12)
            return 1;
        if (hasAt(file, at + 4, "eXIf"))
            return orientationOfTiff(file.subspan(at + 8, length));
        at += 12 + length;
    }
    return 1;
}

int orientationOfWebp(ExifBytes file)
{
    const auto exif = riffChunk(file, "EXIF");
    return orientationOfTiff(exif.subspan(hasAt(exif, 0, exifMark) ? exifMark.size() : 0));
}

} // namespace

int statedOrientation(ImageFormat format, std::span<const std::uint8_t> file)
{
    switch (format) {
    case ImageFormat::Jpeg:
        return orientationOfJpeg(file);
    case ImageFormat::Png:
        return orientationOfPng(file);
    case ImageFormat::Tiff:
        return orientationOfTiff(file);
    case ImageFormat::Webp:
        return orientationOfWebp(file);
    default:
        return 1;
    }
}

int orientationOfMatrix(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d)
{
    const auto size = [](std::int64_t value) { return value < 0 ? -value : value; };
    const bool mirrors = a * d - b * c < 0;
    if (size(a) + size(d) >= size(b) + size(c)) {
        if (a == 0 && d == 0)
            return 1;
        if (mirrors)
            return a < d ? 2 : 4;
        return a + d > 0 ? 1 : 3;
    }
    if (mirrors)
        return b + c > 0 ? 5 : 7;
    return b > c ? 6 : 8;
}

} // namespace odo
