// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/pair_start.h"

#include "core/calibration/internal/lens_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double usualMisfitPx = 5; // of a relation from one pair's poses
constexpr std::size_t mostProposals = 40;

Vector2d quarterTurned(const Vector2d &point, int quarters)
{
    switch (quarters % 4) {
    case 1:
        return {-point.y(), point.x()};
    case 2:
        return -point;
    case 3:
        return {point.y(), -point.x()};
    default:
        return point;
    }
}

Eigen::AlignedBox2d boardBoxOf(const BoardView &view, int quarters)
{
    Eigen::AlignedBox2d box;
    for (const Vector2d &point : view.pointsOnBoard)
        box.extend(quarterTurned(point, quarters));
    return box;
}

/// RMS of the second image's corners under a relation, by one of the turns; infinite where one has no pixel.
double relationMisfitPx(const PosedPair &pair, const RigidTransform &bFromA, const BoardTurn &turn,
                        const CameraModel &b)
{
    const RigidTransform bFromBoard = bFromA * pair.aFromBoard;
    double squares = 0;
    for (std::size_t i = 0; i < pair.boards.b.pixels.size(); ++i) {
        const Vector2d onBoard = turn * pair.boards.b.pointsOnBoard[i];
        const auto pixel = b.project(bFromBoard * Vector3d(onBoard.x(), onBoard.y(), 0));
        if (!pixel)
            return std::numeric_limits<double>::infinity();
        squares += (*pixel - pair.boards.b.pixels[i]).squaredNorm();
    }
    return std::sqrt(squares / double(pair.boards.b.pixels.size()));
}

PairHypothesis hypothesisOf(const RigidTransform &bFromA, std::span<const PosedPair> pairs,
                            const std::vector<std::vector<BoardTurn>> &turns, const CameraModel &b)
{
    constexpr double hopelessPx = 1e6;
    PairHypothesis hypothesis{bFromA, {}, {}, {}, 0};
    for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
        std::size_t choice = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < turns[pair].size(); ++i) {
            const double misfit = relationMisfitPx(pairs[pair], bFromA, turns[pair][i], b);
            if (misfit < least) {
                least = misfit;
                choice = i;
            }
        }
        hypothesis.turns.push_back(turns[pair][choice]);
        hypothesis.choices.push_back(choice);
        hypothesis.misfitsPx.push_back(std::min(least, hopelessPx));
        hypothesis.badness += std::log1p(std::pow(hypothesis.misfitsPx.back() / usualMisfitPx, 2));
    }
    return hypothesis;
}

bool isOtherwise(const PairHypothesis &one, const PairHypothesis &other)
{
    std::size_t different = 0;
    for (std::size_t i = 0; i < one.choices.size(); ++i)
        different += one.choices[i] == other.choices[i] ? 0 : 1;
    return 2 * different >= one.choices.size();
}

} // namespace

Vector2d BoardTurn::operator*(const Vector2d &pointOnBoard) const
{
    return quarterTurned(pointOnBoard, quarters) + shiftM;
}

RigidTransform BoardTurn::transform() const
{
    return {Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * EIGEN_PI * quarters, Vector3d::UnitZ())),
            {shiftM.x(), shiftM.y(), 0}};
}

std::vector<BoardTurn> turnsBetween(const BoardView &a, const BoardView &b)
{
    std::vector<BoardTurn> turns{{}};
    if (a.pattern == BoardPattern::Charuco || b.pattern == BoardPattern::Charuco)
        return turns;
    const double squareM = std::min(squareSideM(a), squareSideM(b));
    const auto squaresOf = [squareM](double extentM) { return int(std::lround(extentM / squareM)); };
    const Eigen::AlignedBox2d boxA = boardBoxOf(a, 0);
    for (const int quarters : {0, 1, 2, 3}) {
        if (quarters % 2 == 1 && a.columns != a.rows)
            continue;
        const Eigen::AlignedBox2d boxB = boardBoxOf(b, quarters);
        const Eigen::Vector2i freeA(a.columns - 1 - squaresOf(boxA.sizes().x()),
                                    a.rows - 1 - squaresOf(boxA.sizes().y()));
        const Eigen::Vector2i freeB(b.columns - 1 - squaresOf(boxB.sizes().x()),
                                    b.rows - 1 - squaresOf(boxB.sizes().y()));
        for (int x = -std::max(0, freeA.x()); x <= std::max(0, freeB.x()); ++x) {
            for (int y = -std::max(0, freeA.y()); y <= std::max(0, freeB.y()); ++y) {
                const BoardTurn turn{quarters, boxA.min() - boxB.min() + squareM * Vector2d(x, y)};
                if (quarters != 0 || turn.shiftM.norm() > 0.1 * squareM)
                    turns.push_back(turn);
            }
        }
    }
    return turns;
}

PairHypotheses startRelation(std::span<const PosedPair> pairs, const CameraModel &b)
{
    std::vector<std::vector<BoardTurn>> turns;
    for (const PosedPair &pair : pairs)
        turns.push_back(turnsBetween(pair.boards.a, pair.boards.b));
    std::vector<PairHypothesis> all;
    const std::size_t step = std::max<std::size_t>(1, pairs.size() / mostProposals);
    for (std::size_t pair = 0; pair < pairs.size(); pair += step) {
        for (const BoardTurn &turn : turns[pair]) {
            const RigidTransform bFromA =
                pairs[pair].bFromBoard * turn.transform().inverse() * pairs[pair].aFromBoard.inverse();
            all.push_back(hypothesisOf(bFromA, pairs, turns, b));
        }
    }
    PairHypotheses answer;
    const auto best = std::ranges::min_element(all, {}, &PairHypothesis::badness);
    if (best == all.end())
        return answer;
    answer.best = *best;
    for (const PairHypothesis &each : all)
        if (isOtherwise(*answer.best, each) && (!answer.other || each.badness < answer.other->badness))
            answer.other = each;
    return answer;
}

} // namespace odo
