// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/evaluation/internal/measured_course.h"
#include "core/analysis/evaluation/log_evaluation.h"

#include <vector>

namespace odo {

/// An offset of the log's clock at which the log moves as the robot was seen to move.
struct OffsetCandidate
{
    double offsetS = 0;
    double explained = 0; ///< part of the variance of speed and turning that both share, 0 to 1
    double scale = 1;     ///< metres of the measured run for one of the log
};

/// Looks for the offsets at which the profiles of speed and turning agree, the best one first; at most
/// mostCandidates. Both are taken from the chords over the same time, so that noise and smoothing
/// change them alike, and neither depends on the axes of the log. Of turning, two curves are taken: how the
/// path bends, as the speed across it, and how the headings turn, where both have one. An offset counts where
/// at least half of the shorter track has a part in common with the other. Empty: there is none. Pure.
std::vector<OffsetCandidate> findOffsets(const MeasuredCourse &course, const std::vector<LogPose> &log);
inline constexpr std::size_t mostCandidates = 6;

/// The usual time between two poses; 0 of a single one.
double usualLogStepS(const std::vector<LogPose> &log);

} // namespace odo
