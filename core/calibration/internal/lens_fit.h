// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/calibration/board_detection.h"
#include "core/calibration/internal/board_shape.h"
#include "core/geometry/camera_model.h"
#include "core/geometry/floor_view.h"
#include "core/geometry/homography.h"

#include <optional>
#include <vector>

namespace odo {

/// The corners of a view: on the board, and their pixels.
std::vector<PointPair> pairsOf(const BoardView &view);

/// The side of a board's squares: the smallest distance between two of its corners. Metres.
double squareSideM(const BoardView &view);

/// One lens and a pose for each image that together explain the corners seen.
struct LensFit
{
    Intrinsics intrinsics; ///< with covariance, from the residuals' σ
    BoardShape print;      ///< as started, or estimated
    std::vector<RigidTransform> cameraFromBoard;
    /// of each image, one a corner: seen minus predicted
    std::vector<std::vector<Eigen::Vector2d>> residualsPx;
    std::vector<double> imageSquares; ///< sum of squared distances of each image, px²
    double squares = 0;               ///< of all
    double unusualSquares = 0;        ///< px², of the residuals of UsualLens where it counts
    double sigmaPx = 0;               ///< of one coordinate, by the degrees of freedom
    /// Covariance of lens, and print where it is estimated, from the scatter of the images' pulls (Bell and
    /// McCaffrey 2002, CR2). It holds whatever the errors of an image's corners have in common, such as the
    /// blur of a move or a bend of the board in the hand. Empty where something was held.
    Eigen::MatrixXd clusterCovariance;
    /// One an image: the change of lens (and print) when it is left out, to first order.
    std::vector<Eigen::VectorXd> withoutImage;
    Eigen::MatrixXd printCovariance; ///< of BoardShape::values, where they are estimated

    double rmsPx() const; ///< sqrt(mean of squared distances)
    bool estimatesPrint() const { return printCovariance.size() > 0; }
};

/// Of k3 among the coefficients of a standard lens.
constexpr int sixthOrder = 4;

/// How the intrinsics are fitted.
struct LensFitOptions
{
    bool holdFocal = false; ///< both focal lengths stay
    /// Not 0: Cauchy's loss of this scale, which hardly heeds corners much farther off. The covariance then
    /// means nothing.
    double cauchyPx = 0;
    bool holdSixthOrder = false; ///< k3 of a standard lens stays
    bool holdLens = false;       ///< all of it stays: only the poses (and the print) adapt
    bool freePrint = false;      ///< the print's shape is estimated
    /// Not 0: what the images of a standard lens leave open is taken from the usual lens (see UsualLens),
    /// beside corners of this σ of one coordinate.
    double usualLensPx = 0;
};

/// A lens and poses to start from.
struct LensStart
{
    Intrinsics intrinsics;
    std::vector<RigidTransform> cameraFromBoard; ///< one a view
    BoardShape print = {};
};

/// Start for views of a board: of several focal lengths (Zhang's closed form among them) the one whose plane
/// poses fit best. Views without a pose are left out: their indices are filled in. nullopt when fewer than
/// three are left.
std::optional<LensStart> startLens(const std::vector<BoardView> &views, int widthPx, int heightPx,
                                   LensModel model, std::vector<std::size_t> &withoutPose);

/// Levenberg–Marquardt over lens and poses (Ceres, Schur complement over the poses). nullopt where it was
/// cancelled or led nowhere.
std::optional<LensFit> fitIntrinsics(const std::vector<BoardView> &views, const LensStart &start,
                                     const LensFitOptions &options, const JobControl &control);

/// The pose of one view under the lens and print of a fit, from a pose that is nearly right, or any where
/// that leads nowhere; nullopt where there is none.
std::optional<LensFit> fitPose(const BoardView &view, const LensFit &known,
                               const RigidTransform &cameraFromBoard);

} // namespace odo
