// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/pair_fit.h"

#include <optional>
#include <span>
#include <vector>

namespace odo {

/// A way in which board coordinates of one image may count in those of another: turned by quarters about the
/// board's normal, then shifted.
struct BoardTurn
{
    int quarters = 0;
    Eigen::Vector2d shiftM = Eigen::Vector2d::Zero();

    Eigen::Vector2d operator*(const Eigen::Vector2d &pointOnBoard) const;
    RigidTransform transform() const; ///< of the board's plane
};

/// All of them between two images of one board: a ChArUco board names its corners; a checkerboard looks the
/// same when turned by half, a square one by a quarter, and one that the image's border cuts off may have
/// begun at another row or column. The plain one is always the first.
std::vector<BoardTurn> turnsBetween(const BoardView &a, const BoardView &b);

/// A pair with the board's pose by each camera alone.
struct PosedPair
{
    PairedBoards boards;
    RigidTransform aFromBoard, bFromBoard;
};

/// A relation, the board coordinates of each pair's second image as the relation wants them, and how the
/// corners then fit.
struct PairHypothesis
{
    RigidTransform bFromA;
    std::vector<BoardTurn> turns;
    std::vector<std::size_t> choices; ///< which of turnsBetween each is
    std::vector<double> misfitsPx;    ///< RMS of each pair's second image under it, at most 1e6
    double badness = 0;               ///< sum of log(1 + (rms / 5 px)²) over the pairs
};

/// The relation that most pairs agree on, and the best one that numbers the corners otherwise in at least
/// half of them; nullopt where there is no other. Each pair's two poses give one relation for each of its
/// turns, and all pairs are compared with it, each with the turn that suits it best. Empty without pairs.
struct PairHypotheses
{
    std::optional<PairHypothesis> best, other;
};
PairHypotheses startRelation(std::span<const PosedPair> pairs, const CameraModel &b);

} // namespace odo
