// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/v4l2/internal/v4l2_device.h"

#include <cstdint>
#include <optional>

namespace odo {

/// One way in which a camera can deliver pictures.
struct V4l2Mode
{
    std::uint32_t format = 0; ///< its fourcc; one that V4l2Pictures reads
    int widthPx = 0, heightPx = 0;
    std::uint32_t periodNumerator = 1,
                  periodDenominator = 30; ///< of the seconds from one picture to the next

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

} // namespace odo
