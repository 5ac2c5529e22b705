// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/quantity_curve.h"
#include "core/project/records.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// How well one view is synchronised with the first, and what that is worth in this run. SI.
struct ViewPassport
{
    std::string camera, method; ///< as RecordingRecord has them
    double offsetS = 0;
    double clockRate = 0; ///< by how much its clock runs faster
    /// nullopt: nothing measured it (entered by hand, or assumed)
    std::optional<double> sigmaOffsetS, sigmaClockRate;
    /// How far its frames are from the nearest of the first view, where both were filming: mean and maximum.
    /// Positions are interpolated to common times, so this is no error.
    double meanApartS = 0, mostApartS = 0;
    /// σ of the time anywhere in the recording: of the offset, and of the clock rate over its length.
    std::optional<double> sigmaTimeS;
    std::optional<CurveValue> costM; ///< that σ times the run's top speed, with the σ of that speed
};

/// What the synchronisation of a trial is worth. Plain value.
struct SyncPassport
{
    std::vector<ViewPassport> views;       ///< all but the first
    std::optional<CurveValue> topSpeedMps; ///< of the fastest robot
    /// The time error that would explain how the views' disagreement grows with the robot's speed: d² = d₀² +
    /// τ²v², least squares over means of half a second. Errors of height and registration depend on the
    /// position and do not grow so; blur does, so it is at most this. nullopt: too few, or too even a speed.
    std::optional<CurveValue> residualS;
    bool isResidualSignificant = false; ///< its square is more than twice its σ from zero
};

/// recordings: of the trial's views, in order, with their frame times. profiles: of its robots. Of a trial
/// with fewer than two recordings it has no views. Pure.
SyncPassport syncPassport(const TrialRecord &trial, const std::vector<const RecordingRecord *> &recordings,
                          const std::vector<const Profile *> &profiles);

/// In whole sentences, one or more a view; none without views.
std::vector<Message> passportSentences(const SyncPassport &passport);

} // namespace odo
