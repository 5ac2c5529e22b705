// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/floor_view.h"
#include "core/tracking/background.h"
#include "core/tracking/chroma.h"
#include "core/tracking/colour_tracker.h"
#include "core/tracking/observation.h"
#include "core/tracking/searched_area.h"
#include "core/video/frame.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace odo {

/// What shows which silhouette is a robot's own.
struct SilhouetteCue
{
    const Observation *coloured = nullptr; ///< where its colour is seen in the frame; null: it is of any look
    Chroma colour = Chroma::Zero();        ///< as given, by which it is found before that
};

/// Follows robots of any look in the frames of one view, by their silhouettes before a known background: the
/// largest ones at first, and then those that are where the robots must be and of their size. Feed every
/// frame in order. Not thread-safe; one tracker a view.
class SilhouetteTracker
{
public:
    /// floor: of a registered view, before which what is too large for a robot is none. others: how many
    /// things besides are followed alike, for one of them may be the robot. area: where they are searched.
    SilhouetteTracker(Background background, std::size_t robots, std::optional<FloorView> floor = {},
                      std::size_t others = 0, SearchedArea area = {});
    ~SilhouetteTracker();
    SilhouetteTracker(const SilhouetteTracker &) = delete;
    SilhouetteTracker &operator=(const SilhouetteTracker &) = delete;

    /// A newer background of the same scene; following continues.
    void setBackground(Background background);
    /// One observation a robot, and then one of each other thing. The rest of a frame that was decoded in
    /// part is decoded. A frame that repeats the one before it gives the same observations again, marked as
    /// such. elsewhere: where robots that are not followed here are seen in this frame, whose silhouettes are
    /// left to them. cues: of each robot; none at all: all are of any look. A seed where there is no
    /// silhouette has no effect.
    std::vector<Observation> track(const Frame &frame, std::span<const Observation> elsewhere = {},
                                   std::span<const SilhouetteCue> cues = {},
                                   std::span<const RobotSeed> seeds = {});

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// The least size of something on the floor that fills a box of the frame, in metres.
struct SizeOnFloor
{
    double widthM = 0;
    /// The lesser of its depth, were it flat on the floor, and of its height, were it as thin as a wall: a
    /// body of height H and depth L that is seen e below the horizontal has L + H/tan e and H + L·tan e.
    double reachM = 0;
};

/// nullopt: its lower edge lies beyond the horizon. Pure.
std::optional<SizeOnFloor> sizeOnFloor(const FloorView &view, const PixelRect &box);

/// Whether it is too large for a robot: people are, while they stand or walk.
bool isTooLargeForRobot(const FloorView &view, const PixelRect &box);

} // namespace odo
