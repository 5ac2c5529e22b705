// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/riff.h"

#include <algorithm>
#include <array>

namespace odo {

namespace {

constexpr std::size_t firstChunkAt = 12, chunkHeaderBytes = 8;

int chunksCalled(std::span<const std::uint8_t> file, std::string_view name)
{
    int count = 0;
    for (std::size_t at = firstChunkAt; at + chunkHeaderBytes <= file.size();) {
        count += hasAt(file, at, name) ? 1 : 0;
        const std::size_t length = numberAt(file, at + 4, 4, false);
        at += chunkHeaderBytes + length + length % 2;
    }
    return count;
}

} // namespace

bool isWebp(std::span<const std::uint8_t> file)
{
    return hasAt(file, 0, "RIFF") && hasAt(file, 8, "WEBP");
}

bool isCutWebp(std::span<const std::uint8_t> file)
{
    return file.size() < chunkHeaderBytes + std::size_t(numberAt(file, 4, 4, false));
}

std::span<const std::uint8_t> riffChunk(std::span<const std::uint8_t> file, std::string_view name)
{
    for (std::size_t at = firstChunkAt; at + chunkHeaderBytes <= file.size();) {
        const std::size_t length = numberAt(file, at + 4, 4, false);
        const bool isWhole = length <= file.size() - at - chunkHeaderBytes;
        if (hasAt(file, at, name))
            return isWhole ? file.subspan(at + chunkHeaderBytes, length) : std::span<const std::uint8_t>();
        at += chunkHeaderBytes + length + length % 2;
    }
    return {};
}

/// RFC 9649 §2.5 to 2.7 and 3.3; RFC 6386 §9.1.
StatedSize webpSize(std::span<const std::uint8_t> file)
{
    if (chunksCalled(file, "ANMF") > 0 || chunksCalled(file, "VP8 ") + chunksCalled(file, "VP8L") != 1)
        return {};
    StatedSize size;
    const auto lossy = riffChunk(file, "VP8 "), lossless = riffChunk(file, "VP8L");
    constexpr std::uint32_t fourteenBits = 0x3fff;
    if (hasAt(lossy, 3, "\x9d\x01\x2a")) {
        size = {numberAt(lossy, 6, 2, false) & fourteenBits, numberAt(lossy, 8, 2, false) & fourteenBits};
    } else if (hasAt(lossless, 0, "\x2f") && lossless.size() > 4) {
        const std::uint32_t bits = numberAt(lossless, 1, 4, false);
        size = {(bits & fourteenBits) + 1, (bits >> 14 & fourteenBits) + 1};
    }
    const auto canvas = riffChunk(file, "VP8X");
    const bool isOtherwise = canvas.size() >= 10 && (numberAt(canvas, 4, 3, false) + 1 != size.width ||
                                                     numberAt(canvas, 7, 3, false) + 1 != size.height);
    return isOtherwise ? StatedSize{} : size;
}

} // namespace odo
