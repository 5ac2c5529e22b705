// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/video/frame.h"

#include <Eigen/Core>

namespace odo {

/// A chroma pair in code values about neutral: u = Cb − 128, v = Cr − 128. Light scales it along the ray from
/// (0, 0).
using Chroma = Eigen::Vector2d;

/// The chroma that a perfect camera would code for an sRGB colour in this format (BT.601 or BT.709, full or
/// limited range). Formula: ITU-T H.273 §8.3.
Chroma chromaOf(RgbColour colour, const FrameFormat &format);

/// The way back: the sRGB colour nearest to what was coded so. Luma as coded, 0 to 255.
RgbColour colourOf(double luma, const Chroma &chroma, const FrameFormat &format);

/// A rectangle of chroma samples: right and bottom are outside.
struct ChromaRect
{
    int left = 0, top = 0, right = 0, bottom = 0;

    int width() const { return right - left; }
    int height() const { return bottom - top; }
    bool isEmpty() const { return right <= left || bottom <= top; }
    bool contains(int x, int y) const { return x >= left && x < right && y >= top && y < bottom; }
    ChromaRect grownBy(int samples) const;
    ChromaRect clippedTo(const ChromaRect &other) const;
};

/// The two chroma planes of a frame and where their samples lie among the luma pixels. Valid as long as the
/// frame.
struct ChromaGrid
{
    PlaneView u, v;
    Eigen::Vector2d scale{1, 1};  ///< luma pixels from one chroma sample to the next
    Eigen::Vector2d offset{0, 0}; ///< luma position of chroma sample (0, 0)

    explicit ChromaGrid(const Frame &frame);
    ChromaRect bounds() const { return {0, 0, u.width, u.height}; }
    Eigen::Vector2d toLuma(const Eigen::Vector2d &chroma) const
    {
        return chroma.cwiseProduct(scale) + offset;
    }
    Eigen::Vector2d fromLuma(const Eigen::Vector2d &luma) const
    {
        return (luma - offset).cwiseQuotient(scale);
    }
    Chroma at(int x, int y) const { return {u.at(x, y) - 128.0, v.at(x, y) - 128.0}; }
};

/// A robot's colour as one frame shows it.
struct PickedColour
{
    RgbColour colour; ///< the mean of all that has it, shaded sides and all
    double share = 0; ///< of the box that it covers, 0 to 1
};

/// The colour of what a person has drawn a box round, as distinct from its surroundings: of the chroma that
/// is commoner inside than in a frame about half as wide as the box, the hue that covers most. Good enough
/// for ColourTracker, which learns the robot's own look from there. The box is in luma pixels of a whole
/// frame. Pure; any thread, some milliseconds. Errors: InvalidInput where the box is too small or leaves
/// nothing around it; Undetermined if it contains no colour that differs from the floor around it, or only
/// grey does.
Result<PickedColour> pickColour(const Frame &frame, const PixelRect &box);

} // namespace odo
