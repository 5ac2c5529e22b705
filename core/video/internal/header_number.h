// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace odo {

/// Of an image, by its header; 0: not stated, or in two ways.
struct StatedSize
{
    std::uint32_t width = 0, height = 0;
};

/// Whether the file has this text at `at`.
inline bool hasAt(std::span<const std::uint8_t> file, std::size_t at, std::string_view text)
{
    return at <= file.size() && text.size() <= file.size() - at &&
           std::equal(text.begin(), text.end(), file.begin() + std::ptrdiff_t(at),
                      [](char a, std::uint8_t b) { return std::uint8_t(a) == b; });
}

/// A number of `count` bytes at `at`; 0 where the file ends before it, which no size can be.
inline std::uint32_t numberAt(std::span<const std::uint8_t> file, std::size_t at, std::size_t count,
                              bool bigEndian)
{
    if (at > file.size() || count > file.size() - at)
        return 0;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
        value = value << 8 | file[bigEndian ? at + i : at + count - 1 - i];
    return value;
}

} // namespace odo
