// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/tiff.h"

#include <algorithm>
#include <iterator>

namespace odo {

namespace {

constexpr std::size_t entryBytes = 12;

bool isBigEndian(std::span<const std::uint8_t> file)
{
    return !file.empty() && file[0] == 'M';
}

/// TIFF 6.0's, and those of its compressions, that say what the pixels are and where they lie.
constexpr std::uint32_t pixelTags[] = {256, 257, 258, 259, 262, 266, 273, 277, 278, 279, 284,
                                       292, 293, 317, 320, 322, 323, 324, 325, 530, 532};

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

void keepPixelTags(std::span<std::uint8_t> file)
{
    const bool bigEndian = isBigEndian(file);
    const std::size_t directory = numberAt(file, 4, 4, bigEndian);
    const std::uint32_t entries = numberAt(file, directory, 2, bigEndian);
    if (entries == 0 || directory + 2 + entryBytes * entries > file.size())
        return; // cut short, which the decoder says
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < entries; ++i) {
        const auto entry = file.begin() + std::ptrdiff_t(directory + 2 + entryBytes * i);
        if (std::ranges::find(pixelTags, numberAt(file, directory + 2 + entryBytes * i, 2, bigEndian)) ==
            std::end(pixelTags))
            continue;
        std::copy(entry, entry + entryBytes,
                  file.begin() + std::ptrdiff_t(directory + 2 + entryBytes * kept));
        ++kept;
    }
    file[directory + (bigEndian ? 0 : 1)] = std::uint8_t(kept >> 8);
    file[directory + (bigEndian ? 1 : 0)] = std::uint8_t(kept & 0xff);
    // no further directory, which would be read where an entry was
    const std::size_t next = directory + 2 + entryBytes * kept;
    std::fill_n(file.begin() + std::ptrdiff_t(next), std::min<std::size_t>(4, file.size() - next), 0);
}

} // namespace odo
