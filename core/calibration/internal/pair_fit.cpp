// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/pair_fit.h"

#include "core/calibration/internal/pose_step.h"

#include "core/geometry/cross_matrix.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace odo {

namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using PoseMatrix = Eigen::Matrix<double, 6, 6>;
using PoseVector = Eigen::Matrix<double, 6, 1>;

constexpr int mostPairSteps = 60;
constexpr double goodEnough = 1e-12; // of the cost

/// The share of one pair in the normal equations: of its pose, and of pose and common values (the relation,
/// then both lenses).
struct PairNormal
{
    PoseMatrix pose = PoseMatrix::Zero();
    MatrixXd poseCommon;
    PoseVector gradient = PoseVector::Zero(), byRelation = PoseVector::Zero();
};

struct PairsNormal
{
    std::vector<PairNormal> pairs;
    MatrixXd common;
    VectorXd gradient;
    double cost = 0;
};

/// How a point moves with a left-applied turn of it, and a shift.
Eigen::Matrix<double, 3, 6> byMotion(const Vector3d &turnedPoint)
{
    Eigen::Matrix<double, 3, 6> motion;
    motion << -crossMatrix(turnedPoint), Matrix3d::Identity();
    return motion;
}

class PairProblem
{
public:
    PairProblem(std::span<const PairedBoards> pairs, const CameraModel &a, const CameraModel &b,
                std::span<const double> weights)
        : m_pairs(pairs), m_a(a), m_b(b), m_weights(weights), m_valuesA(valuesOf(a)), m_valuesB(valuesOf(b))
    {
    }

    /// nullopt where a corner has no pixel.
    std::optional<double> cost(const PairFitStart &state) const
    {
        double sum = 0;
        const bool isSeen = forEachCorner(
            state,
            [&](std::size_t pair, bool, std::size_t, const Vector2d &off, const Vector3d &, const Vector3d &,
                const Eigen::Matrix<double, 2, 3> &) { sum += m_weights[pair] * off.squaredNorm(); });
        return isSeen ? std::optional(sum) : std::nullopt;
    }

    /// withLens: the lenses count as common values, too.
    std::optional<PairsNormal> linearised(const PairFitStart &state, bool withLens) const
    {
        const Eigen::Index size = 6 + (withLens ? m_valuesA + m_valuesB : 0);
        PairsNormal normal;
        normal.common = MatrixXd::Zero(size, size);
        normal.gradient = VectorXd::Zero(size);
        normal.pairs.resize(m_pairs.size());
        for (PairNormal &pair : normal.pairs)
            pair.poseCommon = MatrixXd::Zero(6, size);
        const Matrix3d relation = state.bFromA.rotation.toRotationMatrix();
        MatrixXd byCommon(2, size);
        const bool isSeen = forEachCorner(
            state, [&](std::size_t pair, bool isB, std::size_t, const Vector2d &off, const Vector3d &pointInA,
                       const Vector3d &pointInCamera, const Eigen::Matrix<double, 2, 3> &pixelByPoint) {
                const Vector3d arm = pointInA - state.aFromBoard[pair].translation;
                Eigen::Matrix<double, 2, 6> byPose = pixelByPoint * byMotion(arm);
                byCommon.setZero();
                if (isB) {
                    byPose = pixelByPoint * relation * byMotion(arm);
                    byCommon.leftCols<6>() =
                        pixelByPoint * byMotion(pointInCamera - state.bFromA.translation);
                }
                if (withLens && isB)
                    byCommon.rightCols(m_valuesB) = m_b.pixelByIntrinsics(pointInCamera);
                else if (withLens)
                    byCommon.middleCols(6, m_valuesA) = m_a.pixelByIntrinsics(pointInCamera);
                const double weight = m_weights[pair];
                PairNormal &own = normal.pairs[pair];
                own.pose += weight * byPose.transpose() * byPose;
                own.poseCommon += weight * byPose.transpose() * byCommon;
                own.gradient += weight * byPose.transpose() * off;
                own.byRelation += weight * byCommon.leftCols<6>().transpose() * off;
                normal.common += weight * byCommon.transpose() * byCommon;
                normal.gradient += weight * byCommon.transpose() * off;
                normal.cost += weight * off.squaredNorm();
            });
        return isSeen ? std::optional(std::move(normal)) : std::nullopt;
    }

    /// What a fit says at its end.
    std::optional<PairFit> outcome(const PairFitStart &state) const
    {
        const auto normal = linearised(state, true);
        if (!normal)
            return std::nullopt;
        MatrixXd reduced = normal->common;
        PairFit fit;
        for (const PairNormal &pair : normal->pairs) {
            const Eigen::LDLT<PoseMatrix> pose(pair.pose);
            reduced -= pair.poseCommon.transpose() * pose.solve(pair.poseCommon);
            fit.scores.emplace_back(pair.byRelation -
                                    pair.poseCommon.leftCols<6>().transpose() * pose.solve(pair.gradient));
        }
        const PoseMatrix relation = reduced.topLeftCorner<6, 6>();
        const Eigen::FullPivLU<PoseMatrix> inverse(relation);
        if (!inverse.isInvertible())
            return std::nullopt;
        fit.bFromA = state.bFromA;
        fit.aFromBoard = state.aFromBoard;
        fit.inverseNormal = inverse.inverse();
        fit.byIntrinsicsA = -fit.inverseNormal * reduced.block(0, 6, 6, m_valuesA);
        fit.byIntrinsicsB = -fit.inverseNormal * reduced.block(0, 6 + m_valuesA, 6, m_valuesB);
        fit.residualsA.resize(m_pairs.size());
        fit.residualsB.resize(m_pairs.size());
        fit.squares.resize(m_pairs.size());
        forEachCorner(state, [&](std::size_t pair, bool isB, std::size_t, const Vector2d &off,
                                 const Vector3d &, const Vector3d &, const Eigen::Matrix<double, 2, 3> &) {
            (isB ? fit.residualsB : fit.residualsA)[pair].emplace_back(-off);
            fit.squares[pair] += off.squaredNorm();
        });
        return fit;
    }

private:
    static Eigen::Index valuesOf(const CameraModel &camera)
    {
        return static_cast<Eigen::Index>(4 + camera.intrinsics().distortion.size());
    }

    /// visit(pair, isB, corner, predicted − seen, point in A, point in the camera, pixel by that point).
    template <class Visit>
    bool forEachCorner(const PairFitStart &state, const Visit &visit) const
    {
        for (std::size_t pair = 0; pair < m_pairs.size(); ++pair) {
            for (const bool isB : {false, true}) {
                const BoardView &view = isB ? m_pairs[pair].b : m_pairs[pair].a;
                for (std::size_t i = 0; i < view.pixels.size(); ++i) {
                    const Vector2d &onBoard = view.pointsOnBoard[i];
                    const Vector3d pointInA = state.aFromBoard[pair] * Vector3d(onBoard.x(), onBoard.y(), 0);
                    const Vector3d point = isB ? state.bFromA * pointInA : pointInA;
                    Eigen::Matrix<double, 2, 3> pixelByPoint;
                    const auto pixel = (isB ? m_b : m_a).project(point, pixelByPoint);
                    if (!pixel)
                        return false;
                    visit(pair, isB, i, *pixel - view.pixels[i], pointInA, point, pixelByPoint);
                }
            }
        }
        return true;
    }

    std::span<const PairedBoards> m_pairs;
    const CameraModel &m_a, &m_b;
    std::span<const double> m_weights;
    Eigen::Index m_valuesA, m_valuesB;
};

/// The state after a damped step.
PairFitStart afterStep(const PairFitStart &state, const PairsNormal &normal, double damping)
{
    const auto damped = [damping](MatrixXd matrix) {
        matrix.diagonal() *= 1 + damping;
        return matrix;
    };
    MatrixXd common = damped(normal.common);
    VectorXd gradient = normal.gradient;
    std::vector<Eigen::LDLT<PoseMatrix>> poses;
    for (const PairNormal &pair : normal.pairs) {
        poses.emplace_back(PoseMatrix(damped(pair.pose)));
        common -= pair.poseCommon.transpose() * poses.back().solve(pair.poseCommon);
        gradient -= pair.poseCommon.transpose() * poses.back().solve(pair.gradient);
    }
    const VectorXd step = -common.ldlt().solve(gradient);
    PairFitStart moved;
    moved.bFromA = stepped(state.bFromA, step);
    for (std::size_t pair = 0; pair < normal.pairs.size(); ++pair)
        moved.aFromBoard.push_back(
            stepped(state.aFromBoard[pair],
                    -poses[pair].solve(normal.pairs[pair].gradient + normal.pairs[pair].poseCommon * step)));
    return moved;
}

} // namespace

double PairFit::sumOfSquares() const
{
    return std::accumulate(squares.begin(), squares.end(), 0.0);
}

std::size_t PairFit::corners() const
{
    std::size_t count = 0;
    for (const auto *residuals : {&residualsA, &residualsB})
        for (const auto &ofPair : *residuals)
            count += ofPair.size();
    return count;
}

std::optional<PairFit> fitPair(std::span<const PairedBoards> pairs, const CameraModel &a,
                               const CameraModel &b, const PairFitStart &start,
                               std::span<const double> weights, const JobControl &control)
{
    const PairProblem problem(pairs, a, b, weights);
    PairFitStart state = start;
    auto normal = problem.linearised(state, false);
    double damping = 1e-4, growth = 2;
    for (int step = 0; normal && step < mostPairSteps && damping < 1e12; ++step) {
        if (control.isCancelled())
            return std::nullopt;
        const PairFitStart moved = afterStep(state, *normal, damping);
        const auto cost = problem.cost(moved);
        const double lower = cost ? normal->cost - *cost : -1;
        if (!(lower >= 0)) {
            damping *= growth;
            growth *= 2;
            continue;
        }
        state = moved;
        if (lower <= goodEnough * normal->cost)
            break;
        normal = problem.linearised(state, false);
        damping = std::max(damping / 3, 1e-12);
        growth = 2;
    }
    return normal ? problem.outcome(state) : std::nullopt;
}

} // namespace odo
