// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace odo {

/// Decodes the images of an MJPEG stream to planes with libjpeg-turbo, faster than libavcodec by a quarter,
/// and only a part of an image for a third of the cost. Samples differ from libavcodec's by one code value
/// at most (another inverse cosine transform); those of a part are exactly those of the whole. Images
/// without Huffman tables, as USB cameras send them, get the standard ones (ITU-T T.81, Annex K.3). Any
/// thread, one at a time.
class JpegDecoder
{
public:
    enum class Outcome {
        Decoded,
        Damaged,
        NotSuitable ///< coded in a way that is left to libavcodec: progressive, two fields, of another
                    ///< format, ...
    };

    /// For images of this format; all others are not suitable.
    explicit JpegDecoder(const FrameFormat &format);
    ~JpegDecoder();

    /// Fills in the frame's format and planes; with a region only what lies in the blocks that the region
    /// touches, which is then the frame's valid region (none when it is most of the image, which costs less
    /// as a whole). Damage below the region is not seen.
    Outcome decode(std::span<const std::uint8_t> coded, const std::optional<PixelRect> &region, Frame &frame);

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Encodes frames as JPEG images for a recording of a camera that gives raw ones, from their planes and
/// with their chroma as it is. JPEG is full range by definition: samples of a limited range are stretched.
/// Keeps its memory; any thread, one at a time.
class JpegEncoder
{
public:
    /// quality: 1 to 100. At 92 tracking loses nothing that can be measured.
    explicit JpegEncoder(int quality = 92);
    ~JpegEncoder();
    JpegEncoder(const JpegEncoder &) = delete;
    JpegEncoder &operator=(const JpegEncoder &) = delete;

    /// InvalidInput for a layout of chroma that JPEG does not have.
    Result<std::vector<std::uint8_t>> encode(const Frame &frame);

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// How the image of a JPEG file (ITU-T T.81) lies in planes, by its header alone: full range, chroma
/// centred (JFIF). nullopt where the header is damaged or the image has not luma and two planes of equal
/// chroma. Any thread.
std::optional<FrameFormat> jpegFormat(std::span<const std::uint8_t> jpeg);

/// The same file with the standard Huffman tables (ITU-T T.81, Annex K.3) put in where it has none, as USB
/// cameras leave them out. A file that has its tables, or whose header is damaged, comes back as it is. Any
/// thread.
std::vector<std::uint8_t> withHuffmanTables(std::span<const std::uint8_t> jpeg);

} // namespace odo
