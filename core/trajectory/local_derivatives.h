// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/kalman_smoother.h"

#include <cstddef>
#include <optional>
#include <span>

namespace odo {

/// Derivatives from a few neighbours; a weighted sum each, so their covariance follows from the measurements'
/// (independent from frame to frame; the error of the formula on a curved path is not in it).
/// track: one segment; index: the node wanted; scale: factor on the stated covariances.
/// nullopt where a neighbour that the formula needs is missing.
std::optional<MotionEstimate> savitzkyGolay(std::span<const TrackNode> track, std::size_t index,
                                            double scale);
std::optional<MotionEstimate> trackerDifferences(std::span<const TrackNode> track, std::size_t index,
                                                 double scale);
std::optional<MotionEstimate> rawDifferences(std::span<const TrackNode> track, std::size_t index,
                                             double scale);

} // namespace odo
