// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/fused_track.h"
#include "core/trajectory/internal/kalman_smoother.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace odo {

/// Samples → spikes → profile → metrics: what becomes of a track wherever its positions come from, our own
/// views or a file. Height and disagreement of the views are left at 0. measurement: of the samples'
/// covariances. Pure and thread-safe. Undetermined where fewer than three positions can be used.
Result<Profile> profileOfTrack(FusedTrack track, const AnalysisOptions &options,
                               const MeasurementNoise &measurement);

/// How the errors of analysing begin: "the robot's path cannot be measured".
Message cannotMeasurePath();

/// That so few of the frames give a position.
tl::unexpected<Error> notEnoughData(std::size_t frames, std::size_t used, Message advice);

/// Standard deviation of a vector's length: √((vᵀPv + tr(P)²/2) / (|v|² + tr(P)/2)). It is that of first
/// order for a length far above its noise, and the root mean square of the whole noise for a length near
/// zero, where first order would promise too little.
double sigmaOfLength(const Eigen::Vector2d &vector, const Eigen::Matrix2d &covariance);

/// A valid point from an estimate, with the calibration's part added to the position's σ.
ProfilePoint makePoint(const MotionEstimate &estimate, const Eigen::Matrix2d &commonCovariance);

/// The curves of all samples by the wanted method; points where it does not reach are not valid. Interpolated
/// is set on samples that are bridged, cleared elsewhere. Pure but for that. changes: how the motion changed,
/// as flagSpikes returns it, or empty. Rts: needs three measurements in a segment; parts the motion
/// at blows. SavGol: least squares of a cubic through the eleven nearest used samples at their true times
/// (Savitzky and Golay 1964 for equal steps); towards the ends and with fewer than eleven, what there is;
/// needs four. Tracker: v = (x₊₁ − x₋₁)/2Δt, a = (2x₊₂ − x₊₁ − 2x − x₋₁ + 2x₋₂)/7Δt² (Tracker's
/// FirstDerivative and SecondDerivative) with the neighbours' mean Δt; none at gaps. None: differences to the
/// sample before (Park 2018, eq. 6 to 8); none at gaps.
std::vector<ProfilePoint> makePoints(std::vector<Sample> &samples, const std::vector<MotionChange> &changes,
                                     const AnalysisOptions &options, MotionNoise noise);

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
