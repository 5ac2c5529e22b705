// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/background.h"
#include "core/tracking/light_gain.h"

#include <opencv2/core.hpp>

namespace odo {

/// A part of a picture beside its background in the picture's light. Luma above black, chroma about neutral, at the luma's resolution.
struct ComparedWindow
{
    PixelRect rect;
    cv::Mat1f luma, u, v;
    cv::Mat1f lumaBehind, uBehind, vBehind;
    cv::Mat1f lumaNoise2, chromaNoise2; ///< variances
    cv::Mat1b differs;                  ///< 1 where luma or chroma differ by more than the place varies
    cv::Mat1b plain;                    ///< 1 where they differ by so much that even a few pixels of it are no noise
    cv::Mat1b shade;                    ///< 1 where it may be floor in shadow
    cv::Mat1b byHue;                    ///< 1 where only the mean hue of the pixels around tells it from a shadow: known to some pixels

    /// Compares a part that lies in the frame, whose format is the background's.
    void compare(const Frame &frame, const Background &background, const LightGain &gain, const PixelRect &part);

private:
    void read(const Frame &frame, const Background &background, const LightGain &gain);
    void findDifferences(float cutOff);
    void findShade();
};

/// Sum of squares in units of the noise beyond which something differs.
inline constexpr float differsInSigmas2 = 20;
/// And the least step of it, code values.
inline constexpr float leastLumaStep = 6, leastChromaStep = 3.5F;

inline float squared(float value)
{
    return value * value;
}

} // namespace odo
