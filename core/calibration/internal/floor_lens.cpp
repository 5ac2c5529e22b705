// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/floor_lens.h"

#include "core/calibration/floor_registration.h"
#include "core/calibration/internal/lens_spread.h"
#include "core/calibration/internal/marker_pairs.h"
#include "core/calibration/internal/pose_step.h"
#include "core/calibration/intrinsics_influence.h"
#include "core/geometry/least_squares.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// What is estimated of a lens, in this order: log of the mean focal length, log of fx/fy, cx, cy and the
/// distortion k1 k2 p1 p2 k3.
constexpr Eigen::Index lensValues = 9, poseValues = 6;
constexpr Eigen::Index focalAt = 0, aspectAt = 1, centreAt = 2, distortionAt = 4;

// Before any marker: means and one σ each.
constexpr double usualFocal = 0.8, focalSpread = 0.45; // of the longer side: 64° across; its log
constexpr double aspectSpread = 0.004;
constexpr double centreSpread = 0.015; // of the longer side
constexpr double k1Spread = 0.2;
constexpr double k2Spread = 0.12; // about k2ByK1 · k1
constexpr double tangentialSpread = 0.001;
constexpr double k3Spread = 0.05;

// A lens that follows the markers hides their errors, those of the tape too: they count as larger than where
// the residuals show them (usualMarkSigmaPx).
constexpr double believedPx = 0.5;
constexpr double settled = 1e-3; // of the σ of a marker
constexpr int mostRounds = 12;

struct LensState
{
    Intrinsics lens;
    RigidTransform worldFromCamera;
};

double longerSide(const Intrinsics &lens)
{
    return std::max(lens.widthPx, lens.heightPx);
}

/// What is known of the focal length beforehand: the log of its part of the longer side.
struct FocalPrior
{
    double mean = std::log(usualFocal), spread = focalSpread;
};

double logFocalOf(const Intrinsics &lens)
{
    return std::log(std::sqrt(lens.fxPx * lens.fyPx) / longerSide(lens));
}

/// The prior's residuals, each of σ 1, and their derivative by the lens's values.
VectorXd priorOf(const Intrinsics &lens, const FocalPrior &focal)
{
    const double side = longerSide(lens);
    const auto &k = lens.distortion;
    VectorXd off(lensValues);
    off << (logFocalOf(lens) - focal.mean) / focal.spread, std::log(lens.fxPx / lens.fyPx) / aspectSpread,
        (lens.cxPx - 0.5 * (lens.widthPx - 1)) / (centreSpread * side),
        (lens.cyPx - 0.5 * (lens.heightPx - 1)) / (centreSpread * side), k[0] / k1Spread,
        (k[1] - k2ByK1 * k[0]) / k2Spread, k[2] / tangentialSpread, k[3] / tangentialSpread, k[4] / k3Spread;
    return off;
}

MatrixXd priorByLens(const Intrinsics &lens, const FocalPrior &focal)
{
    const double side = longerSide(lens);
    VectorXd weights(lensValues);
    weights << 1 / focal.spread, 1 / aspectSpread, 1 / (centreSpread * side), 1 / (centreSpread * side),
        1 / k1Spread, 1 / k2Spread, 1 / tangentialSpread, 1 / tangentialSpread, 1 / k3Spread;
    MatrixXd slopes = weights.asDiagonal();
    slopes(distortionAt + 1, distortionAt) = -k2ByK1 / k2Spread;
    return slopes;
}

/// Derivative of (fx, fy, cx, cy, distortion...) by the values that are estimated.
MatrixXd intrinsicsByValues(const Intrinsics &lens)
{
    MatrixXd slopes = MatrixXd::Identity(lensValues, lensValues);
    slopes.topLeftCorner<2, 2>() << lens.fxPx, 0.5 * lens.fxPx, lens.fyPx, -0.5 * lens.fyPx;
    return slopes;
}

Intrinsics moved(Intrinsics lens, const VectorXd &step)
{
    const double focal = std::exp(std::clamp(step(focalAt), -1.0, 1.0));
    const double aspect = std::exp(0.5 * std::clamp(step(aspectAt), -0.1, 0.1));
    lens.fxPx *= focal * aspect;
    lens.fyPx *= focal / aspect;
    lens.cxPx += step(centreAt);
    lens.cyPx += step(centreAt + 1);
    for (std::size_t i = 0; i < lens.distortion.size(); ++i)
        lens.distortion[i] += step(distortionAt + Eigen::Index(i));
    return lens;
}

/// Residuals over (rotation, position, lens): the markers' by sigmaPx, then the prior's.
LeastSquaresProblem<LensState> problemOf(std::span<const PointPair> pairs, double sigmaPx,
                                         const FocalPrior &focal = {})
{
    const std::vector<Vector2d> positions = positionsOf(pairs);
    LeastSquaresProblem<LensState> problem;
    problem.evaluate = [pairs, positions, sigmaPx, focal](const LensState &state, VectorXd &residuals,
                                                          MatrixXd *byStep) {
        const auto rows = Eigen::Index(2 * pairs.size());
        const auto camera = CameraModel::create(state.lens);
        if (!camera)
            return false;
        residuals.resize(rows + lensValues);
        const FloorView view(*camera, state.worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const auto pixel = view.pixelFromWorld({pairs[i].source.x(), pairs[i].source.y(), 0});
            if (!pixel)
                return false;
            residuals.segment<2>(Eigen::Index(2 * i)) = (*pixel - pairs[i].target) / sigmaPx;
        }
        residuals.tail(lensValues) = priorOf(state.lens, focal);
        if (!byStep)
            return true;
        const auto slopes = markerDerivatives(*camera, state.worldFromCamera, positions);
        if (!slopes)
            return false;
        byStep->setZero(residuals.size(), poseValues + lensValues);
        byStep->topLeftCorner(rows, poseValues) = slopes->byPose / sigmaPx;
        byStep->topRightCorner(rows, lensValues) =
            slopes->byIntrinsics * intrinsicsByValues(state.lens) / sigmaPx;
        byStep->bottomRightCorner(lensValues, lensValues) = priorByLens(state.lens, focal);
        return true;
    };
    problem.move = [](const LensState &state, const VectorXd &step) {
        return LensState{moved(state.lens, step.tail(lensValues)),
                         stepped(state.worldFromCamera, step.head<6>())};
    };
    return problem;
}

/// The lens that a fit may start from: with the values that are estimated, and no others.
Intrinsics startOf(Intrinsics lens)
{
    lens.model = LensModel::Standard;
    lens.distortion.assign(std::size_t(lensValues - distortionAt), 0);
    lens.covariance.resize(0, 0);
    return lens;
}

/// As FloorLens says; of residuals of σ 1, their derivatives and the covariance of what was estimated.
double heldOutOf(const VectorXd &residuals, const MatrixXd &markers, const MatrixXd &covariance)
{
    const MatrixXd spread = markers * covariance;
    double squares = 0;
    for (Index i = 0; i < markers.rows(); i += 2) {
        const Eigen::Matrix2d leverage = spread.middleRows<2>(i) * markers.middleRows<2>(i).transpose();
        squares +=
            ((Eigen::Matrix2d::Identity() - leverage).inverse() * residuals.segment<2>(i)).squaredNorm();
    }
    return std::sqrt(2 * squares / double(markers.rows()));
}

struct Answer
{
    FloorLens lens;
    /// Residuals that are free: twice the markers, less the pose and what of the lens the markers decide.
    double freedom = 0;
};

/// The fit's answer from its derivatives at the best state. nullopt where they determine nothing.
std::optional<Answer> answerOf(const LensState &state, const VectorXd &residuals, const MatrixXd &byStep,
                               double sigmaPx)
{
    const Eigen::Index rows = residuals.size() - lensValues;
    const MatrixXd markers = byStep.topRows(rows);
    const MatrixXd covariance = (byStep.transpose() * byStep).inverse();
    const Eigen::Matrix<double, 6, 6> inverseNormal =
        (markers.leftCols(poseValues).transpose() * markers.leftCols(poseValues)).inverse() /
        (sigmaPx * sigmaPx);
    if (!covariance.allFinite() || !inverseNormal.allFinite())
        return std::nullopt;
    Intrinsics lens = state.lens;
    const MatrixXd slopes = intrinsicsByValues(lens);
    const MatrixXd ofLens = covariance.bottomRightCorner(lensValues, lensValues);
    lens.covariance = slopes * ofLens * slopes.transpose();
    auto camera = CameraModel::create(std::move(lens));
    if (!camera)
        return std::nullopt;
    const double squaresPx2 = residuals.head(rows).squaredNorm() * sigmaPx * sigmaPx;
    const double spent = (markers * covariance).cwiseProduct(markers).sum();
    const double focalSigmaPx = std::sqrt(ofLens(focalAt, focalAt)) * camera->intrinsics().fxPx;
    return Answer{{{std::move(*camera), state.worldFromCamera, inverseNormal,
                    std::sqrt(2 * squaresPx2 / double(rows)), sigmaPx, focalSigmaPx},
                   sigmaPx * heldOutOf(residuals.head(rows), markers, covariance)},
                  double(rows) - spent};
}

constexpr double sureFocal = 0.02; // so sure that the floor follows it in a straight line
constexpr double focalSteps[] = {0.75, 1.5, 2.25, 3};
constexpr double heldFocal = 1e-3; // of its σ
constexpr int pixelsAcross = 8, pixelsDown = 5;
constexpr double reach = 2; // of the markers' extent, from their middle: beyond it nobody measures

/// σ of the focal length, relative to itself.
double focalSigmaOf(const PlanePose &pose)
{
    return pose.focalSigmaPx.value_or(0) / pose.camera.intrinsics().fxPx;
}

/// How much wider the floor spreads over all focal lengths that the markers allow than the covariance at the
/// best one says, as a factor of σ; 1 and more. Where the focal length is hardly determined, the floor does
/// not follow it in a straight line.
class Nonlinearity
{
public:
    Nonlinearity(std::span<const PointPair> pairs, const PlanePose &pose)
        : m_pairs(pairs), m_pose(pose),
          m_problem(problemOf(pairs, pose.sigmaPx)), m_best{pose.camera.intrinsics(), pose.worldFromCamera}
    {
        const double variance = pose.sigmaPx * pose.sigmaPx;
        const std::vector<Vector2d> positions = positionsOf(pairs);
        const FloorView view(pose.camera, pose.worldFromCamera, variance * pose.inverseNormal,
                             poseByIntrinsics(pose.camera, pose.worldFromCamera, positions));
        keepPixels(view, positions);
    }

    double factor()
    {
        for (const double side : {-1.0, 1.0}) {
            LensState state = m_best;
            for (const double step : focalSteps)
                addAt(side * step * focalSigmaOf(m_pose), state);
        }
        double widest = 1;
        for (const Point &point : m_points)
            widest = std::max(widest, std::sqrt(point.squares / m_weights) / point.sigmaM);
        return widest;
    }

private:
    struct Point
    {
        Vector2d pixel, positionM;
        double sigmaM, squares = 0;
    };

    void keepPixels(const FloorView &view, const std::vector<Vector2d> &positions)
    {
        Vector2d middle = Vector2d::Zero();
        for (const Vector2d &position : positions)
            middle += position / double(positions.size());
        const double farthestM = reach * extentOf(positions);
        const Intrinsics &lens = view.camera().intrinsics();
        for (int row = 0; row < pixelsDown; ++row) {
            for (int column = 0; column < pixelsAcross; ++column) {
                const Vector2d pixel((column + 0.5) * lens.widthPx / pixelsAcross,
                                     (row + 0.5) * lens.heightPx / pixelsDown);
                const auto seen = view.locate(pixel, Eigen::Matrix2d::Zero(), 0);
                if (seen && (seen->pointInWorld - middle).norm() < farthestM)
                    m_points.push_back(
                        {pixel, seen->pointInWorld, std::sqrt(seen->calibrationCovariance.trace())});
            }
        }
    }

    std::optional<double> costOf(const LensState &state) const
    {
        VectorXd residuals;
        return m_problem.evaluate(state, residuals, nullptr) ? std::optional(residuals.squaredNorm())
                                                             : std::nullopt;
    }

    void addAt(double offset, LensState &state)
    {
        const FocalPrior held{logFocalOf(m_best.lens) + offset, heldFocal * focalSigmaOf(m_pose)};
        state = minimise(problemOf(m_pairs, m_pose.sigmaPx, held), state);
        const auto camera = CameraModel::create(state.lens);
        const auto cost = costOf(state);
        if (!camera || !cost || !m_leastCost)
            return;
        const double weight = std::exp(0.5 * (*m_leastCost - *cost));
        const FloorView view(*camera, state.worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
        for (Point &point : m_points) {
            if (const auto seen = view.floorFromPixel(point.pixel, 0))
                point.squares += weight * (*seen - point.positionM).squaredNorm();
        }
        m_weights += weight;
    }

    std::span<const PointPair> m_pairs;
    const PlanePose &m_pose;
    const LeastSquaresProblem<LensState> m_problem;
    const LensState m_best;
    const std::optional<double> m_leastCost = costOf(m_best);
    std::vector<Point> m_points;
    double m_weights = 1; // of the best one
};

} // namespace

std::optional<FloorLens> fitFloorLens(std::span<const PointPair> pairs, const PlanePose &start)
{
    LensState state{startOf(start.camera.intrinsics()), start.worldFromCamera};
    double sigmaPx = std::max(believedPx, start.sigmaPx);
    std::optional<Answer> answer;
    for (int round = 0; round < mostRounds; ++round) {
        const auto problem = problemOf(pairs, sigmaPx);
        state = minimise(problem, state);
        VectorXd residuals;
        MatrixXd byStep;
        if (!problem.evaluate(state, residuals, &byStep))
            return std::nullopt;
        answer = answerOf(state, residuals, byStep, sigmaPx);
        if (!answer)
            return std::nullopt;
        const double rmsPx = answer->lens.pose.rmsPx;
        const double squaresPx2 = rmsPx * rmsPx * double(pairs.size());
        const double nextPx = markSigmaPx(squaresPx2, answer->freedom, believedPx);
        answer->lens.studentFactor = markStudentFactor(squaresPx2, answer->freedom, believedPx);
        if (std::abs(nextPx - sigmaPx) < settled * sigmaPx)
            break;
        sigmaPx = nextPx;
    }
    FloorLens lens = std::move(answer->lens);
    if (focalSigmaOf(lens.pose) < sureFocal)
        return lens;
    const double factor = Nonlinearity(pairs, lens.pose).factor();
    Intrinsics intrinsics = lens.pose.camera.intrinsics();
    intrinsics.covariance *= factor * factor;
    lens.pose.camera = *CameraModel::create(std::move(intrinsics));
    return lens;
}

} // namespace odo
