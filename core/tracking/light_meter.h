// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <array>
#include <optional>

namespace odo {

/// How light one picture of a view is.
struct LightLevel
{
    Nanoseconds time{0};
    double level = 1; ///< mean luma against that of the view's first picture
    /// of the picture: brighter than in the picture before, less what is darker; −1 to 1
    double changedShare = 0;
};

/// Follows the light of one view from frame to frame, on some thousand luma samples of each: a lamp switched
/// on or off changes the level at once, and most of the picture with it. Of frames that hold a part of their
/// picture the part that they have in common with the one before is compared, so that where that part lies
/// makes no difference. Costs some hundredths of a millisecond a frame. Keeps a share in the last frame. One
/// a view; one thread at a time.
class LightMeter
{
public:
    /// Every frame in order. A frame of another size, or without a part in common, is taken as light as the
    /// last.
    LightLevel measure(const Frame &frame);

private:
    std::optional<Frame> m_last;
    double m_level = 1;
};

/// By what factor one luma plane is lighter than another of the same place, as lamps and automatic exposure
/// make it: robust against what only one of them shows.
struct LightGain
{
    float factor = 1; ///< of luma above black
    int black = 0;    ///< code value

    /// How much lighter `plane` is than `reference`, both of one size.
    static LightGain between(const PlaneView &plane, const PlaneView &reference, bool fullRange);
    /// For each code value of the plane, what it would be in the reference's light.
    std::array<std::uint8_t, 256> toReference() const { return table(1 / factor); }
    /// For each code value of the reference, what it would be in the plane's light.
    std::array<std::uint8_t, 256> fromReference() const { return table(factor); }
    /// As toReference, of chroma, which lies about its neutral value.
    std::array<std::uint8_t, 256> chromaToReference() const
    {
        return LightGain{factor, neutralChroma}.toReference();
    }

    static constexpr int neutralChroma = 128;
    /// Luma from this code value on may be cut off by the sensor: what is darker in the reference may have
    /// been as light there.
    static constexpr int mostLuma = 235;

private:
    std::array<std::uint8_t, 256> table(float by) const;
};

} // namespace odo
