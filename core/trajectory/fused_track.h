// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/fusion.h"
#include "core/trajectory/kalman_smoother.h"
#include "core/trajectory/profile.h"

#include <vector>

namespace odo {

/// What a sample was made of, for decisions and for words.
struct SampleEvidence
{
    std::vector<ViewPosition>
        contenders;       ///< positions of views that contradict each other; empty when decided
    double bestScore = 0; ///< of the views that found the robot
    bool cut = false;     ///< every view that found it has it at the picture's edge
    bool partlySeen = false; ///< in no view is its outline what it usually is: something hides a part of it, or touches it in the picture
    bool isContradicted = false; ///< the views contradict one another here as they do near by, and their covariances hold it (core/trajectory/contradiction.h)
};

/// The samples of one robot before spikes are looked for; samples and evidence have equal length.
struct FusedTrack
{
    std::vector<Sample> samples;
    std::vector<SampleEvidence> evidence;
};

struct FusionSettings
{
    double planeSigmaM = 0;  ///< uncertainty of the height of the plane used; goes into the common part
    double leastScore = 0.2; ///< views below are left out, or the sample is flagged where there is no better
    MeasurementNoise measurement = {}; ///< for the decisions by motion
};

/// Joins the views at each time. Flags set: Lost, DuplicateFrame, LowScore, ViewsDisagree, and Jump with it
/// where no group of views has a majority (chooseByMotion may decide these).
FusedTrack fuseViews(const std::vector<Nanoseconds> &times, const std::vector<std::int64_t> &frames,
                     const std::vector<std::vector<Sighting>> &views, const FusionSettings &settings);

/// Where views contradict each other without a majority, takes the one view that fits the motion before and
/// after: its squared Mahalanobis distance from the smoothed track without the sample is inside χ²(2) 99.9 %
/// and every other one's outside. From the edges of such a stretch inwards. Decided samples keep
/// ViewsDisagree and lose Jump.
void chooseByMotion(FusedTrack &track, const FusionSettings &settings, Nanoseconds longestGap);

} // namespace odo
