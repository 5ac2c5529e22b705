// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/kalman_smoother.h"
#include "core/trajectory/profile.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace odo {

/// A stretch of samples without a long gap, from one that is used to another that is used.
struct TrackSegment
{
    std::size_t first = 0;        ///< index of the first sample
    std::vector<TrackNode> nodes; ///< one for each sample
    std::size_t measured = 0;     ///< nodes that carry a measurement
};

/// Cuts the samples where nothing is used for longer than longestGap. A sample is used when it has a position
/// and `isUsed` says so (by default: when its flags do not reject it). Used samples whose time does not come
/// after the last used one's are left out.
std::vector<TrackSegment> cutIntoSegments(const std::vector<Sample> &samples, Nanoseconds longestGap,
                                          const std::function<bool(const Sample &)> &isUsed = {});

/// Marks the nodes that were struck: one value for each of the samples that were cut, or none at all. In a gap
/// before such a node the blow may have come anywhere.
void markBlows(std::vector<TrackSegment> &segments, const std::vector<bool> &struck);

/// The segments' nodes, as estimateMotionNoise wants them.
std::vector<std::span<const TrackNode>> nodesOf(const std::vector<TrackSegment> &segments);

} // namespace odo
