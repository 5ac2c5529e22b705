// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/camera_model.h"
#include "core/geometry/floor_view.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

struct MarkerError
{
    std::string label;
    double errorM = 0;  ///< on the floor
    double errorPx = 0; ///< in the image
};

/// What the markers' residuals follow beyond chance.
enum class ResidualPattern {
    None,
    Intrinsics, ///< other ones than those used
    Layout,     ///< its measures, or one marker
};

/// One camera to the floor.
struct FloorRegistration
{
    RigidTransform worldFromCamera;
    Eigen::Matrix<double, 6, 6>
        poseCovariance; ///< as FloorView says: what it would be if the intrinsics were exact
    double rmsPx = 0, rmsM = 0;
    /// The largest σ of the floor at any marker, from the pose and, where its covariance is known, the lens.
    double floorSigmaM = 0;
    std::vector<MarkerError> markers;
    Message verdict; ///< sentences; they say where the lens was estimated or assumed
    /// The lens that worldFromCamera belongs to: the one given, or the one that was estimated.
    Intrinsics intrinsics;
    /// Of the fit just made; a stored registration has it in its verdict only.
    ResidualPattern residualPattern = ResidualPattern::None;
};

/// Where a registration's intrinsics come from.
enum class IntrinsicsSource {
    Calibration,
    Floor,   ///< estimated from the markers, its focal length to 10 % or better
    Assumed, ///< the markers hardly determine them
};

/// intrinsics: the registration's. isCalibrated: as it was made.
IntrinsicsSource intrinsicsSourceOf(const Intrinsics &intrinsics, bool isCalibrated);

/// Another camera of the testbed, whose markers may have been taken for this one's.
struct OtherCamera
{
    std::string name;
    CameraModel camera;
    std::optional<FloorView> view; ///< where it is registered to the same layout
};

/// What is known of the markers' pixels besides; it names mistakes, and changes no position.
struct RegistrationContext
{
    /// They were found or clicked in an image of this camera, at its size: not taken over from elsewhere.
    bool isSeenInImage = false;
    std::vector<OtherCamera> others;
};

/// Homography by normalised DLT from undistorted pixels, decomposed to a pose (Zhang 2000), refined with the
/// lens model on pixel distance (Levenberg–Marquardt); covariance from the Jacobian with the residuals' σ,
/// steadied by a prior of 0.3 px that weighs as four residuals. Refuses by name: fewer than four markers
/// common to both lists, doubled labels or points, collinear markers, mirrored or swapped order, non-finite
/// values, pixels outside the image, a camera below the floor, markers beyond the horizon, markers that fit
/// no plane, markers that fit five times better without a usual mistake where that is no chance (a pixel), a
/// floor known worse than 3 % of the layout's extent, and a camera lower than 5 cm or higher than 100 m (a
/// wrong unit). The advice names the usual mistakes that explain the misfit (internal/registration_causes.h).
/// The verdict is "Uncertain" where the floor may be mirrored.
///
/// With intrinsicsKnown = false the lens is estimated along with the pose, as far as the markers determine
/// it; for the rest it is as unsure as ordinary lenses differ (internal/floor_lens.h). Use the registration's
/// intrinsics, which have a covariance, with its pose.
///
/// Residuals that follow a pattern (internal/residual_pattern.h) are named, and the verdict is then never
/// "Good". Such errors do not average out over the markers: the pose's covariance is that of four of them.
Result<FloorRegistration> registerFloor(const MarkerLayout &layout, const std::vector<MarkerPixel> &pixels,
                                        const CameraModel &camera, bool intrinsicsKnown,
                                        const RegistrationContext &context = {});

/// σ of one coordinate of a marker's pixel, as it is believed of before any residual is seen.
inline constexpr double usualMarkSigmaPx = 0.3;

/// σ of one coordinate of a marker's pixel, in pixels, from the residuals of a fit: the sum of their squares
/// and how many of them are free. What is believed of it beforehand counts along with the weight of four
/// residuals: four markers leave two, which alone would often call the noise nearly nothing. The mean of both
/// variances by what each weighs is the posterior mean of the variance under a scaled inverse χ² prior
/// (Gelman et al., Bayesian Data Analysis, 2.6) of that mean and six degrees of freedom. Residuals that
/// the belief lets happen once in a thousand cases (χ²) refute it: they count alone, with Student's factor
/// for so few of them (JCGM 100:2008, G.3.2; that of two residuals at the most). It holds for tags as well:
/// the program finds them better, but the layout was measured too. Any thread. believedPx: another belief.
double markSigmaPx(double squaresPx2, double freedom, double believedPx = usualMarkSigmaPx);

/// Student's factor in it; 1 where the belief holds.
double markStudentFactor(double squaresPx2, double freedom, double believedPx = usualMarkSigmaPx);

} // namespace odo
