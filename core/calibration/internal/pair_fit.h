// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/calibration/board_detection.h"
#include "core/geometry/camera_model.h"
#include "core/geometry/floor_view.h"

#include <optional>
#include <span>
#include <vector>

namespace odo {

/// A board as two cameras saw it at one moment, with the same board coordinates in both.
struct PairedBoards
{
    BoardView a, b;
};

/// A relation of two cameras and the board's pose in each pair, to start from.
struct PairFitStart
{
    RigidTransform bFromA;
    std::vector<RigidTransform> aFromBoard; ///< one a pair
};

/// The same after a fit, with what follows from it.
struct PairFit
{
    RigidTransform bFromA;
    std::vector<RigidTransform> aFromBoard;
    /// of each pair, one a corner: seen minus predicted
    std::vector<std::vector<Eigen::Vector2d>> residualsA, residualsB;
    std::vector<double> squares; ///< of each pair, over both images, px²
    /// of each pair: the derivative of half its squares by the relation; they sum to nothing
    std::vector<Eigen::Matrix<double, 6, 1>> scores;
    /// Inverse of the normal matrix of the relation at unit pixel noise, the poses eliminated: of (rotation
    /// vector of a left-applied perturbation, translation), in camera B's axes.
    Eigen::Matrix<double, 6, 6> inverseNormal;
    /// Derivative of that relation by the lenses that were held (6 × number of values).
    Eigen::MatrixXd byIntrinsicsA, byIntrinsicsB;

    double sumOfSquares() const;
    std::size_t corners() const; ///< of all pairs and both images
};

/// Levenberg–Marquardt over one relation and a pose for each pair, both lenses held; the poses are eliminated
/// in each step (Schur complement). weights: one a pair, by which its squares count. nullopt where it was
/// cancelled, a corner has no pixel at the start, or the pairs determine no relation.
std::optional<PairFit> fitPair(std::span<const PairedBoards> pairs, const CameraModel &a,
                               const CameraModel &b, const PairFitStart &start,
                               std::span<const double> weights, const JobControl &control);

} // namespace odo
