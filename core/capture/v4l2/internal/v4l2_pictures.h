// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/jpeg.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

struct v4l2_pix_format;

namespace odo {

/// Which of the formats that can be read is to be preferred: 0 first; −1 for one that cannot be read.
int v4l2FormatRank(std::uint32_t fourcc);

/// A picture as it lay in a camera's buffer.
struct V4l2Picture
{
    Frame frame; ///< without index and time
    std::shared_ptr<const std::vector<std::uint8_t>>
        jpeg; ///< of a camera that codes: its file, with its tables
};

/// Reads the buffers of a stream of one format. One thread.
class V4l2Pictures
{
public:
    /// A format with a rank.
    explicit V4l2Pictures(const v4l2_pix_format &format);
    /// nullopt where the picture is damaged or not whole.
    std::optional<V4l2Picture> read(std::span<const std::uint8_t> buffer);

private:
    std::optional<V4l2Picture> readJpeg(std::span<const std::uint8_t> buffer);

    const int m_width, m_height;
    const std::size_t m_leastBytes;
    std::function<Frame(std::span<const std::uint8_t>)> m_raw; ///< unless the camera codes
    FrameFormat m_jpegFormat;
    std::unique_ptr<JpegDecoder> m_decoder; ///< for pictures of m_jpegFormat
};

} // namespace odo
