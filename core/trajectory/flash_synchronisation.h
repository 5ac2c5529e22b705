// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/clip_synchronisation.h"
#include "core/trajectory/light_edges.h"

#include <vector>

namespace odo {

/// The jumps of light in one view, and how long it was recorded.
struct LightCourse
{
    std::vector<LightEdge> edges;
    double durationS = 0;
    double frameS = 0; ///< typical interval
};

LightCourse lightCourseOf(const std::vector<LightLevel> &levels);

/// Finds the offset between two views from the light of the room that both saw jump: every pairing of two edges of one
/// direction proposes an offset, under which the edges that pair up speak for it and those that the other view should
/// have seen and did not speak against it. Weighed as a likelihood: a pair that falls together by chance is one in
/// three hundred, one edge in ten is missed. Taken where no other offset comes within a factor of 150. The offset is
/// the pairs' weighted mean; σ follows from theirs, their scatter, and a tenth of a frame interval for each view,
/// because a rolling shutter sees the robot's rows at another moment than the middle of the picture. With three pairs
/// over 20 s the rate of the clocks is fitted too, and taken beyond 3σ. score: share of the edges that paired up.
/// Undetermined: no jump in one view; several offsets that fit alike; none that fits.
Result<ClipOffset> estimateFlashOffset(const LightCourse &first, const LightCourse &second);

} // namespace odo
