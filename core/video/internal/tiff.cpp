// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/tiff.h"

#include "core/video/internal/rgb_rows.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <tiffio.h>
#include <vector>

namespace odo {

namespace {

constexpr std::size_t entryBytes = 12;

bool isBigEndian(std::span<const std::uint8_t> file)
{
    return !file.empty() && file[0] == 'M';
}

} // namespace

StatedSize tiffSize(std::span<const std::uint8_t> file)
{
    const bool bigEndian = isBigEndian(file);
    constexpr std::uint32_t tags[] = {256, 257, 322, 323}, shortNumber = 3, longNumber = 4;
    const std::size_t directory = numberAt(file, 4, 4, bigEndian);
    const std::uint32_t entries = numberAt(file, directory, 2, bigEndian);
    std::uint32_t values[std::size(tags)] = {};
    for (std::uint32_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + std::size_t(12) * i;
        const auto tag = std::ranges::find(tags, numberAt(file, entry, 2, bigEndian));
        if (tag == std::end(tags))
            continue;
        const std::uint32_t type = numberAt(file, entry + 2, 2, bigEndian);
        std::uint32_t &value = values[tag - std::begin(tags)];
        if ((type != shortNumber && type != longNumber) || value != 0)
            return {};
        value = numberAt(file, entry + 8, type == shortNumber ? 2 : 4, bigEndian);
    }
    if (values[0] == 0 || values[1] == 0)
        return {};
    return {std::max(values[0], values[2]), std::max(values[1], values[3])}; // tiles are decoded whole
}

bool hasPlainPixels(std::span<const std::uint8_t> file)
{
    const bool bigEndian = isBigEndian(file);
    constexpr std::uint32_t subfileType = 254, subDirectories = 330, sampleFormat = 339, withoutSign = 1;
    const std::size_t directory = numberAt(file, 4, 4, bigEndian);
    const std::uint32_t entries = numberAt(file, directory, 2, bigEndian);
    for (std::uint32_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + entryBytes * i;
        const std::uint32_t tag = numberAt(file, entry, 2, bigEndian);
        const bool isPreview = tag == subfileType && (numberAt(file, entry + 8, 4, bigEndian) & 1) != 0;
        if (isPreview || tag == subDirectories)
            return false;
        if (tag != sampleFormat)
            continue;
        // more than two values are elsewhere in the file
        const bool isHere = numberAt(file, entry + 4, 4, bigEndian) <= 2;
        const std::size_t at = isHere ? entry + 8 : numberAt(file, entry + 8, 4, bigEndian);
        if (numberAt(file, at, 2, bigEndian) != withoutSign)
            return false;
    }
    return true;
}

namespace {

/// The file as libtiff wants to be given it.
struct TiffBytes
{
    std::span<const std::uint8_t> file;
    std::size_t at = 0;
};

tmsize_t readBytes(thandle_t handle, void *to, tmsize_t count)
{
    auto *bytes = static_cast<TiffBytes *>(handle);
    const std::size_t left = bytes->file.size() - bytes->at;
    const std::size_t given = std::min(left, static_cast<std::size_t>(std::max<tmsize_t>(count, 0)));
    std::copy_n(bytes->file.data() + bytes->at, given, static_cast<std::uint8_t *>(to));
    bytes->at += given;
    return static_cast<tmsize_t>(given);
}

tmsize_t writeNothing(thandle_t, void *, tmsize_t)
{
    return -1;
}

toff_t seekTo(thandle_t handle, toff_t offset, int from)
{
    auto *bytes = static_cast<TiffBytes *>(handle);
    const toff_t start = from == SEEK_SET ? 0 : from == SEEK_CUR ? bytes->at : bytes->file.size();
    bytes->at = static_cast<std::size_t>(std::min<toff_t>(start + offset, bytes->file.size()));
    return bytes->at;
}

int keepOpen(thandle_t)
{
    return 0;
}

toff_t sizeOf(thandle_t handle)
{
    return static_cast<TiffBytes *>(handle)->file.size();
}

int saySilently(TIFF *, void *, const char *, const char *, va_list)
{
    return 1;
}

struct FreeTiff
{
    void operator()(TIFF *tiff) const { TIFFClose(tiff); }
    void operator()(TIFFOpenOptions *options) const { TIFFOpenOptionsFree(options); }
};

std::unique_ptr<TIFF, FreeTiff> openTiff(TiffBytes &bytes)
{
    constexpr tmsize_t mostAtOnce = 250'000'000; // of one strip or tile
    const std::unique_ptr<TIFFOpenOptions, FreeTiff> options(TIFFOpenOptionsAlloc());
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), mostAtOnce);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), saySilently, nullptr);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), saySilently, nullptr);
    return std::unique_ptr<TIFF, FreeTiff>(TIFFClientOpenExt("image", "rm", &bytes, readBytes, writeNothing,
                                                             seekTo, keepOpen, sizeOf, nullptr, nullptr,
                                                             options.get()));
}

} // namespace

std::optional<Frame> decodeTiff(std::span<const std::uint8_t> file)
{
    TiffBytes bytes{file};
    const auto tiff = openTiff(bytes);
    const StatedSize size = tiffSize(file);
    std::uint32_t width = 0, height = 0;
    if (!tiff || TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width) != 1 ||
        TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height) != 1 || width > size.width ||
        height > size.height)
        return std::nullopt;
    TIFFSetField(tiff.get(), TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT); // the rows as they are
    std::vector<std::uint32_t> pixels(std::size_t(width) * height);
    if (TIFFReadRGBAImageOriented(tiff.get(), width, height, pixels.data(), ORIENTATION_TOPLEFT, 1) != 1)
        return std::nullopt;
    const FrameFormat format = rgbFormat(int(width), int(height));
    auto buffer = std::make_shared<FrameBuffer>(format);
    std::vector<std::uint8_t> rgb(3 * std::size_t(width));
    for (int y = 0; y < format.height; ++y) {
        const std::uint32_t *row = pixels.data() + std::size_t(y) * width;
        for (std::size_t x = 0; x < width; ++x) {
            rgb[3 * x] = static_cast<std::uint8_t>(TIFFGetR(row[x]));
            rgb[3 * x + 1] = static_cast<std::uint8_t>(TIFFGetG(row[x]));
            rgb[3 * x + 2] = static_cast<std::uint8_t>(TIFFGetB(row[x]));
        }
        convertRgbRow(rgb.data(), format.width, buffer->yRow(y), buffer->uRow(y), buffer->vRow(y));
    }
    return FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
}

} // namespace odo
