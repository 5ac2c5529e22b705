// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"

#include <vector>

namespace odo {

/// A sample that two views or more placed. World frame, SI.
struct Disagreement
{
    Nanoseconds time{0};
    Eigen::Vector2d position = Eigen::Vector2d::Zero(); ///< as fused
    double apartM = 0;    ///< largest distance between two views' positions (Sample::viewDisagreementM)
    double expectedM = 0; ///< root mean square of it by the stated σ
};

/// Where and by how much the views of a run put a robot at different places.
struct ViewDisagreement
{
    std::vector<Disagreement> places;           ///< in order of time
    double rmsM = 0, medianM = 0, largestM = 0; ///< of apartM; 0 without places
    double expectedRmsM = 0;                    ///< root mean square of expectedM
    /// How much larger than the stated σ let expect; 0 without places.
    double ratio() const { return expectedRmsM > 0 ? rmsM / expectedRmsM : 0; }
};

/// From the observations of the views and what the analysis made of them; rejected samples are left out (a
/// false sighting tells nothing of the cameras). What is expected of two views that place a robot with the
/// covariances A and B, E|a − b|² = tr A + tr B, plus (v·σₛ)² of a robot of speed v for views in step to σₛ:
/// the pixels' part and the calibrations', taken as independent; an error of the robot's height is not in it,
/// nor what outlines share. Of several pairs of views the one with the most counts, which expects somewhat
/// too much. stepSigmaS: of the views' step, seconds; 0: not known. Pure, any thread.
ViewDisagreement disagreementOf(const Profile &profile, const std::vector<ViewTrack> &views,
                                double stepSigmaS);

} // namespace odo
