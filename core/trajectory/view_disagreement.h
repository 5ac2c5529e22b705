// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/tracking/observation.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/floor_positions.h"
#include "core/trajectory/internal/fused_track.h"
#include "core/trajectory/internal/kalman_smoother.h"

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

/// Where and by how much the views' floor positions of a robot differ in a run.
struct ViewDisagreement
{
    std::vector<Disagreement> positions;        ///< in order of time
    double rmsM = 0, medianM = 0, largestM = 0; ///< of apartM; 0 without positions
    double expectedRmsM = 0;                    ///< root mean square of expectedM
    /// How much larger than expected from the stated σ; 0 without positions.
    double ratio() const { return expectedRmsM > 0 ? rmsM / expectedRmsM : 0; }
};

/// From the observations of the views and what the analysis made of them; rejected samples are left out (a
/// false sighting says nothing about the cameras). What is expected of two views that see a robot with the
/// covariances A and B, E|a − b|² = tr A + tr B, plus (v·σₛ)² of a robot of speed v for views synchronised to
/// σₛ: the pixels' part and the calibrations', assumed independent; an error of the robot's height is not
/// included, nor what outlines share. Of several pairs of views the one with the most counts, which expects
/// somewhat too much. stepSigmaS: of the views' time offset, seconds; 0: not known. Pure, any thread.
ViewDisagreement disagreementOf(const Profile &profile, const std::vector<ViewTrack> &views,
                                double stepSigmaS);

/// Finds where the views' floor positions differ for longer than a false sighting lasts, by more than their
/// covariances allow for: a camera has moved since it was registered, the views are not synchronised, or a
/// given height is wrong. A view that contradicts two others that agree is left out. Otherwise the
/// covariances of the views that contradict one another are widened until they agree, by their calibrations'
/// part: to half the median over two seconds of χ²(2) times what they were (Birge 1932: the ratio by which
/// errors that were stated too small are widened), and by Student's factor besides, for what lasts is known
/// of one draw. Views that are farther apart than farApartM see different things, and stay as they are.
/// views: sightings of each view at the same times, on the plane used. Gives of each time how far the views
/// are apart, metres; 0 where they don't contradict one another. Pure.
std::vector<double> settleContradictions(std::vector<std::vector<Sighting>> &views);
/// Sets ViewsDisagree where they contradict one another, and how far they are apart.
void flagContradictions(FusedTrack &track, const std::vector<double> &apartM);
/// What the views contradict one another by in the samples that several of them saw.
struct ViewsApart
{
    std::size_t seen = 0, used = 0; ///< samples that several views saw, and those of them that are used
    std::vector<double> apartM;     ///< of those that are flagged ViewsDisagree
};
ViewsApart viewsApart(const std::vector<Sample> &samples);
/// An Error where hardly a sample is used because the views contradict one another.
Result<void> checkAgreement(const std::vector<Sample> &samples);

inline constexpr double farApartM = 0.2; ///< beyond it no camera was moved: the views see different things

/// How large the errors of the outlines are, and how they are correlated, from the disagreement of the views,
/// in which the robot's motion cancels: half the mean squared change of the whitened disagreement over a
/// distance s is σ²w + σ²s (1 − exp(−s/ℓ)) (the variogram of an Ornstein–Uhlenbeck process beside white
/// noise: Matheron 1963), fitted over distances up to 0.4 m; longer ones show the calibration's change over
/// the floor. views: sightings at the same times. With too few that two views share, or too short a path, the
/// usual values.
MeasurementNoise estimateOutlineNoise(const std::vector<std::vector<Sighting>> &views);

/// Distrusts the whole outlines of a robot whose thin parts (a cable, a mast) were left out of many others:
/// there they are before or behind its body and cannot be distinguished from it. Such outlines are not used
/// to learn its form, and give its position only roughly. views: what each view saw of one robot, as tracked.
/// Pure.
void uncertaintyUntrimmed(const std::vector<std::vector<Observation> *> &views);

} // namespace odo
