// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <array>
#include <optional>
#include <vector>

namespace odo {

/// What a fixed camera sees when no robot is there: of each sample of the three planes its value and how much
/// it varies. Code values, as in the frames that it was learned from.
struct Background
{
    struct Plane
    {
        int width = 0, height = 0;
        std::vector<std::uint8_t> values;
        std::vector<std::uint8_t> sigmas; ///< in units of sigmaUnit, at least leastSigma

        const std::uint8_t *row(int y) const { return values.data() + std::ptrdiff_t(y) * width; }
        const std::uint8_t *sigmaRow(int y) const { return sigmas.data() + std::ptrdiff_t(y) * width; }
    };
    static constexpr float sigmaUnit = 0.125F, leastSigma = 1; ///< code values

    /// What a shadow may leave of the floor. Lamps, sun, windows and walls decide it; one view of the empty
    /// floor does not show it.
    struct Shadow
    {
        float darkest = 0.40F; ///< the least share of its luma above black
        /// by how much its chroma is off for each code value of luma that the shadow takes, at most: the
        /// light that is left may be of another colour, as that of a window beside a lamp
        float tint = 0;
        /// whether all that one shadow connects is one body: sides of a robot may look like floor in shadow
        bool connects = false;
    };

    FrameFormat format;
    Plane y, u, v;
    Shadow shadow = {};
    static constexpr float strongTint = 0.15F; ///< as far as lamps and windows of a room differ
};

/// Learns a background from the frames of one view, given in any number and in order: it keeps a few of them,
/// spread over what moves rather than over time, so a robot that stands still for most of a recording does
/// not become background, and takes the median of each sample. Holds at most some 64 MB of frames. One thread
/// at a time.
class BackgroundLearner
{
public:
    /// Whole frames of one format; one of another format restarts the learning.
    void add(const Frame &frame);
    /// Nothing before the first frame. Changes of the light as a whole are compensated before the median.
    std::optional<Background> learned() const;
    /// Frames in which something moved, of those that were given.
    std::int64_t movingFrames() const { return m_moving; }

private:
    void keep(const Frame &frame);

    std::vector<Frame> m_kept; ///< in order
    std::optional<Frame> m_last;
    std::size_t m_most = 0;   ///< frames to keep
    std::int64_t m_every = 1; ///< so many moving frames from one kept to the next
    std::int64_t m_moving = 0;
};

/// The background of a camera that is running: relearned after every further half of the motion before. One
/// thread at a time.
class LiveBackground
{
public:
    /// Every frame in order. A background where a newer one was learned.
    std::optional<Background> add(const Frame &frame);

private:
    BackgroundLearner m_learner;
    /// moving frames at which it is learned: after fewer the robot's first position is part of it
    std::int64_t m_next = 20;
    Nanoseconds m_lastLook{Nanoseconds::min()};
};

/// How light one frame of a view is.
struct LightLevel
{
    Nanoseconds time{0};
    double level = 1; ///< mean luma against that of the view's first frame
    /// share of the frame that is brighter than before, minus the share that is darker; −1 to 1
    double changedShare = 0;
};

/// Follows the light of one view from frame to frame, on some thousand luma samples of each: a lamp switched
/// on or off changes the level at once, and with it most of the frame. Of frames that were decoded in part,
/// the part in common with the frame before is compared, so its position makes no difference. Costs some
/// hundredths of a millisecond a frame. Keeps a share in the last frame. One a view; one thread at a time.
class LightMeter
{
public:
    /// Every frame in order. A frame of another size, or without a part in common, is assumed as light as the
    /// last.
    LightLevel measure(const Frame &frame);

private:
    std::optional<Frame> m_last;
    double m_level = 1;
};

/// By what factor one luma plane is lighter than another of the same scene, as lamps and automatic exposure
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
