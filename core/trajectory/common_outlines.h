// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/silhouette.h"
#include "core/trajectory/analyser.h"

#include <vector>

namespace odo {

/// Of an outline that shows the whole robot.
constexpr double leastOutlineScore = 0.5;

/// The outlines that the views saw at one time: of each registered view, where it saw the whole robot
/// clearly.
struct CommonOutlines
{
    struct Outline
    {
        const FloorView *view = nullptr; ///< owned by the tracks given
        RegionMoments moments;
        std::vector<float> supportPx; ///< as of Observation
    };
    std::vector<Outline> outlines; ///< at least one
    Nanoseconds time{0};           ///< of the first view's clock
};

/// Outlines at up to `most` times spread evenly over the run, of as many views each as saw it: those of other
/// views interpolated linearly between their two frames around. Clear means: found with a score of at least
/// 0.5, not cut by the picture's edge, in no repeated picture. Times with several views are preferred: one
/// view's are taken only where there are fewer than five of the former.
std::vector<CommonOutlines> commonOutlines(const std::vector<ViewTrack> &views, std::size_t most);

} // namespace odo
