// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/analysis/quantity_curve.h"

#include <optional>
#include <vector>

namespace odo {

/// What a low-pass filter of some cut-off takes away of the measured positions.
struct CutoffResidual
{
    double cutoffHz = 0;
    double residualM = 0, sigmaM = 0; ///< root mean square of a coordinate
};

/// How the smoothing of a run compares with that of a Butterworth filter, by which a cut-off can be defended
/// (residual analysis: Winter 2009, § 3.4.4.3). SI.
struct CutoffAnalysis
{
    std::vector<CutoffResidual> residuals; ///< from 0.5 Hz to 0.9 of half the frame rate; ascending
    double framesPerSecond = 0;
    /// The noise of a coordinate, by the residuals of the upper half of the cut-offs and the share of white
    /// noise that those filters take away; and the cut-off at which the residual is that noise, the choice of
    /// the residual analysis. nullopt: there is none.
    std::optional<CurveValue> noiseM, chosenHz;
    /// The cut-off of the smoother that made the curve (−3 dB), by the σ that it states: 0.863 ω₀/2π of
    /// errorRate, median and scatter over the run; nullopt where it states none. What it took away.
    std::optional<CurveValue> automaticHz;
    std::optional<CurveValue> automaticResidualM;
    /// root mean square of the stated σ of a measured coordinate, frame to frame
    double statedNoiseM = 0;
};

/// Each stretch of used samples without a gap of more than three frames, the missing ones filled by a line,
/// is filtered by a Butterworth filter of the second order forwards and backwards, reflected at its ends; the
/// cut-off is that of both passes together (−3 dB). Frames count as evenly spaced. Stretches of less than a
/// second are left out. Empty residuals: there is none, or the profile holds no samples. Pure.
CutoffAnalysis cutoffAnalysis(const Profile &profile);

/// A series of even steps, filtered so.
std::vector<double> butterworth(const std::vector<double> &values, double framesPerSecond, double cutoffHz);

} // namespace odo
