// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/stream_format.h"
#include "core/video/jpeg.h"
#include "core/video/video_input.h"

/// A picture as a camera sends it: format, Huffman tables, whole and in part; and the packets of other codecs
/// that we look into ourselves.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t count)
{
    using namespace odo;
    const std::span bytes(data, count);
    static_cast<void>(ffv1ChecksumsHold(bytes));
    static_cast<void>(h264ChromaLocation(bytes));
    const auto format = jpegFormat(bytes);
    static_cast<void>(withHuffmanTables(bytes));
    constexpr int mostPixels = 1 << 18; // larger ones are only slower
    if (!format || format->width > mostPixels / format->height)
        return 0;
    JpegDecoder decoder(*format);
    Frame whole, part;
    static_cast<void>(decoder.decode(bytes, std::nullopt, whole));
    static_cast<void>(decoder.decode(
        bytes,
        PixelRect{format->width / 4, format->height / 4, format->width / 4 + 1, format->height / 4 + 1},
        part));
    return 0;
}
