// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/v4l2/internal/v4l2_device.h"
#include "core/video/jpeg.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

struct v4l2_pix_format;

namespace odo {

/// One way in which a camera can deliver frames.
struct V4l2Mode
{
    std::uint32_t format = 0; ///< its fourcc; one that V4l2Pictures reads
    int widthPx = 0, heightPx = 0;
    std::uint32_t periodNumerator = 1,
                  periodDenominator = 30; ///< of the seconds from one frame to the next

    double framesPerSecond() const { return static_cast<double>(periodDenominator) / periodNumerator; }
};

/// What is asked for; the rest is chosen.
struct V4l2Request
{
    std::optional<std::uint32_t> format = {};
    std::optional<int> widthPx = {}, heightPx = {}; ///< both or none
    std::optional<double> framesPerSecond = {};
};

/// "MJPG"; blanks at the end are left out.
std::string fourccWords(std::uint32_t fourcc);
/// "MJPG 1280×720 at 30 frames/s"
Message modeWords(const V4l2Mode &mode);

/// All modes of the camera that can be read; where it offers ranges, the usual sizes and rates within them.
std::vector<V4l2Mode> v4l2Modes(const V4l2Device &device);

/// What chooseMode prefers comes first.
void sortByMerit(std::vector<V4l2Mode> &modes);

/// Of the modes that fit the request (the rate to 2 %): one with 30 frames/s or more if there is any, then
/// nearest to 1280×720 in its number of pixels, then the fastest, then MJPEG before raw formats. NotFound
/// when none fits.
Result<V4l2Mode> chooseMode(const std::vector<V4l2Mode> &modes, const V4l2Request &request,
                            const std::string &uri);

/// Which of the formats that can be read is to be preferred: 0 first; −1 for one that cannot be read.
int v4l2FormatRank(std::uint32_t fourcc);

/// A frame as it is in a camera's buffer.
struct V4l2Frame
{
    Frame frame; ///< without index and time
    std::shared_ptr<const std::vector<std::uint8_t>>
        jpeg; ///< of a camera that codes: its file, with its tables
};

/// Reads the buffers of a stream of one format. One thread.
class V4l2Frames
{
public:
    /// A format with a rank.
    explicit V4l2Frames(const v4l2_pix_format &format);
    /// nullopt where the frame is damaged or not whole.
    std::optional<V4l2Frame> read(std::span<const std::uint8_t> buffer);

private:
    std::optional<V4l2Frame> readJpeg(std::span<const std::uint8_t> buffer);

    const int m_width, m_height;
    const std::size_t m_leastBytes;
    std::function<Frame(std::span<const std::uint8_t>)> m_raw; ///< unless the camera codes
    FrameFormat m_jpegFormat;
    std::unique_ptr<JpegDecoder> m_decoder; ///< for frames of m_jpegFormat
};

} // namespace odo
