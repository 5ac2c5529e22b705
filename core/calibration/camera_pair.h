// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/calibration/board_detection.h"
#include "core/geometry/camera_model.h"
#include "core/geometry/floor_view.h"

#include <string>
#include <vector>

namespace odo {

/// A board as two cameras saw it at one moment. The board of a view has no corners where it was not found.
struct BoardPair
{
    BoardView a, b;
};

struct RejectedPair
{
    std::string a, b; ///< file, or file@frame; empty where a camera has none
    Message reason;   ///< a clause
};

struct UsedPair
{
    std::string a, b;
    double rmsPx = 0; ///< over both images, sqrt(mean of squared distances)
    std::size_t cornersLeftOut = 0;
};

/// Neighbouring corners, triangulated from both images: how far apart they are. Metres.
struct TriangulatedSquares
{
    double meanM = 0, sdM = 0;
    std::size_t count = 0;
};

/// Where one camera is by another. Metres, radians.
struct CameraPair
{
    RigidTransform bFromA; ///< takes a point in camera A's axes to camera B's
    /// Of (rotation vector of a left-applied perturbation, translation), in camera B's axes: of corners,
    /// pairs and both lenses.
    Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
    double baselineM = 0, baselineSigmaM = 0;
    double rmsPx = 0; ///< over all corners that count, in both images: sqrt(mean of squared distances)
    /// What the corners leave when every image may have the board where it likes, with the same lenses.
    double freeRmsPx = 0;
    /// How much worse the pairs agree on one relation than the corners' noise explains: 1 or more, a ratio of
    /// variances. It is in the covariance.
    double overdispersion = 1;
    bool areIntrinsicsSigmasStated = true; ///< by the lens calibrations of both
    std::vector<UsedPair> used;
    std::vector<RejectedPair> rejected;
    TriangulatedSquares squares;
    Message verdict; ///< sentences

    std::size_t cornersLeftOut() const;
};

/// Estimates the relation of two cameras from a board that both saw at the same moments: one relation and a
/// pose of the board for each pair, fitted jointly to the corners in both images; both lenses are held. The
/// board's size of a square gives the scale, as if exact.
///
/// Misread corners do not count, found for each camera as a lens calibration does (misreadCorners). Pairs are
/// weighed by how well they agree with the others (Cauchy's weights of the excess of their squares over those
/// of both images alone, by six degrees of freedom) until it is clear which of them contradict; these are
/// left out with the reason, and the rest counts alike. A checkerboard may be numbered from either end in
/// each image: the numbering on which the pairs agree is taken.
///
/// Covariance: σ²·φ·N⁻¹ of the corners, with σ from each image alone and φ, at least 1, the mean excess of
/// the pairs (quasi-likelihood: McCullagh and Nelder 1989, 4.5). Where φ is clearly above 1 (boards that
/// moved between the two shutters), at least the scatter of the pairs along each direction (Liang and Zeger
/// 1986). And what both lenses' covariances leave, to first order. A lens without one (imported from
/// elsewhere) counts as known to 1 % of its focal length, 0.5 % of the image for its principal point and 0.02
/// for k1.
///
/// Errors: Undetermined where no pair has the board in both images, where more than half of the pairs
/// contradict, where the pairs agree on no relation, and where a checkerboard's numbering stays open;
/// InvalidInput where the images of each camera fit the other's lens; Cancelled. Any thread; long.
Result<CameraPair> relateCameras(const std::vector<BoardPair> &pairs, const CameraModel &a,
                                 const CameraModel &b, const JobControl &control);

} // namespace odo
