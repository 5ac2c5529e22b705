// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/body_outline.h"

#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/level_fit.h"

#include <algorithm>
#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double angleStepRad = 0.01; // of the numerical derivative
constexpr double longestStepRad = 0.05, leastInformation = 1;
constexpr int mostIterations = 3;
constexpr int aboutSteps = 8;
constexpr double aboutStepRad = 0.025;
constexpr double worstMisfit = 4; // σ of each of the three second moments: not this solid's silhouette
constexpr int positionIterations = 4;

} // namespace

RegionMoments outlineMoments(const Observation &observation)
{
    const Ellipse &ellipse = observation.ellipse;
    const Eigen::Vector2d major(std::cos(ellipse.angleRad), std::sin(ellipse.angleRad));
    const Eigen::Vector2d minor(-major.y(), major.x());
    RegionMoments moments;
    moments.areaPx2 = observation.areaPx;
    moments.centrePx = ellipse.centrePx;
    moments.covariancePx2 = ellipse.semiMajorPx * ellipse.semiMajorPx / 4 * major * major.transpose() +
                            ellipse.semiMinorPx * ellipse.semiMinorPx / 4 * minor * minor.transpose();
    return moments;
}

OutlineSigma sigmaOfOutline(const RegionMoments &outline)
{
    // A circle of radius r that is drawn too wide by e has its area r²π and its moments r²/4 too large by
    // 2e/r.
    const double radius = std::sqrt(std::max(outline.areaPx2, 1.0) / std::numbers::pi);
    const double share = 2 * outlineSigmaPx / radius;
    return {share, share * outline.covariancePx2.trace() / 2};
}

OutlineDifferences outlineDifferences(const RegionMoments &seen, const RegionMoments &model,
                                      const OutlineSigma &sigma, double centroidSigmaPx)
{
    const Eigen::Vector2d position = (seen.centrePx - model.centrePx) / centroidSigmaPx;
    const Eigen::Matrix2d spread = (seen.covariancePx2 - model.covariancePx2) / sigma.covariancePx2;
    OutlineDifferences differences;
    differences << position, std::log(seen.areaPx2 / model.areaPx2) / sigma.areaShare, spread(0, 0),
        spread(1, 1), spread(0, 1);
    return differences;
}

OutlineMisfit::OutlineMisfit(const FloorView &view, const SolidShape &shape, const RegionMoments &seen,
                             const Eigen::Vector2d &position)
    : m_view(&view), m_shape(&shape), m_seen(seen), m_position(position),
      m_sigmaPx2(sigmaOfOutline(seen).covariancePx2)
{
}

std::optional<OutlineMisfit> OutlineMisfit::create(const FloorView &view, const SolidShape &shape,
                                                   const RegionMoments &seen)
{
    const auto position = view.floorFromPixel(seen.centrePx, middleHeightM(shape));
    if (!position)
        return std::nullopt;
    return OutlineMisfit(view, shape, seen, *position);
}

std::optional<Eigen::Vector3d> OutlineMisfit::at(double angleRad) const
{
    const auto model = silhouetteMoments(*m_view, *m_shape, m_position, angleRad);
    if (!model)
        return std::nullopt;
    const Eigen::Matrix2d difference = m_seen.covariancePx2 - model->covariancePx2;
    return Eigen::Vector3d(difference(0, 0), difference(1, 1), difference(0, 1)) / m_sigmaPx2;
}

std::optional<BodyAxis> axisAbout(const OutlineMisfit &misfit, double angleRad)
{
    double weights = 0, mean = 0, squares = 0, leastCost = HUGE_VAL;
    for (int i = -aboutSteps; i <= aboutSteps; ++i) {
        const double turn = i * aboutStepRad;
        const auto residual = misfit.at(angleRad + turn);
        if (!residual)
            return std::nullopt;
        const double cost = residual->squaredNorm(), weight = std::exp(-cost / 2);
        leastCost = std::min(leastCost, cost);
        weights += weight;
        mean += weight * turn;
        squares += weight * turn * turn;
    }
    if (leastCost > 3 * worstMisfit * worstMisfit || !(weights > 0))
        return std::nullopt;
    mean /= weights;
    return BodyAxis{angleRad + mean,
                    std::sqrt(std::max(squares / weights - mean * mean, aboutStepRad * aboutStepRad / 4))};
}

std::optional<BodyAxis> axisNear(const OutlineMisfit &misfit, double angleRad)
{
    double information = 0, cost = 0;
    for (int iteration = 0; iteration < mostIterations; ++iteration) {
        const auto here = misfit.at(angleRad), before = misfit.at(angleRad - angleStepRad),
                   behind = misfit.at(angleRad + angleStepRad);
        if (!here || !before || !behind)
            return std::nullopt;
        const Eigen::Vector3d slope = (*behind - *before) / (2 * angleStepRad);
        information = slope.squaredNorm();
        cost = here->squaredNorm();
        if (information < leastInformation)
            break;
        const double step = -slope.dot(*here) / information;
        angleRad += std::clamp(step, -longestStepRad, longestStepRad);
        if (std::abs(step) < 1e-3)
            break;
    }
    if (cost > 3 * worstMisfit * worstMisfit)
        return std::nullopt;
    return BodyAxis{angleRad, 1 / std::sqrt(std::max(information, leastInformation))};
}

std::optional<Eigen::Vector2d> pixelOfBodyMiddle(const FloorView &view, const SolidShape &shape,
                                                 const Eigen::Vector2d &centroidPx, double angleRad)
{
    const double middleM = middleHeightM(shape);
    Eigen::Vector2d pixel = centroidPx;
    for (int iteration = 0; iteration < positionIterations; ++iteration) {
        const auto position = view.floorFromPixel(pixel, middleM);
        if (!position)
            return std::nullopt;
        const auto model = silhouetteMoments(view, shape, *position, angleRad);
        const auto middle = view.pixelFromWorld({position->x(), position->y(), middleM});
        if (!model || !middle)
            return std::nullopt;
        const Eigen::Vector2d next = centroidPx - (model->centrePx - *middle);
        const bool settled = (next - pixel).squaredNorm() < 1e-8;
        pixel = next;
        if (settled)
            break;
    }
    return pixel;
}

namespace {

constexpr std::size_t leastTimes = 5;
constexpr Nanoseconds longestStep = std::chrono::milliseconds(120);

bool isClear(const Observation &observation)
{
    const Ellipse &ellipse = observation.ellipse;
    return observation.found && !observation.duplicateFrame && !observation.touchesBorder &&
           observation.score >= leastOutlineScore && ellipse.centrePx.allFinite() &&
           std::isfinite(ellipse.angleRad) && ellipse.semiMinorPx > 0 && std::isfinite(ellipse.semiMajorPx) &&
           observation.areaPx > 0 && std::isfinite(observation.areaPx);
}

/// A blend of two outlines.
CommonOutlines::Outline between(const FloorView *view, const Observation &before, const Observation &behind,
                                double fraction)
{
    const RegionMoments a = outlineMoments(before), b = outlineMoments(behind);
    CommonOutlines::Outline outline{view,
                                    {(1 - fraction) * a.areaPx2 + fraction * b.areaPx2,
                                     (1 - fraction) * a.centrePx + fraction * b.centrePx,
                                     (1 - fraction) * a.covariancePx2 + fraction * b.covariancePx2},
                                    {}};
    const std::vector<float> &from = before.supportPx, &to = behind.supportPx;
    for (std::size_t k = 0; k < from.size() && from.size() == to.size(); ++k)
        outline.supportPx.push_back(float((1 - fraction) * from[k] + fraction * to[k]));
    return outline;
}

std::optional<CommonOutlines::Outline> outlineAt(const ViewTrack &view, Nanoseconds time)
{
    const auto after = std::lower_bound(
        view.observations.begin(), view.observations.end(), time,
        [&view](const Observation &observation, Nanoseconds t) { return timeOf(view, observation) < t; });
    if (after == view.observations.end() || !isClear(*after))
        return std::nullopt;
    const Nanoseconds behind = timeOf(view, *after);
    if (behind == time)
        return CommonOutlines::Outline{&*view.floorView, outlineMoments(*after), after->supportPx};
    if (after == view.observations.begin() || !isClear(*(after - 1)))
        return std::nullopt;
    const Nanoseconds before = timeOf(view, *(after - 1));
    if (behind - before > longestStep)
        return std::nullopt;
    const double fraction = toSeconds(time - before) / toSeconds(behind - before);
    return between(&*view.floorView, *(after - 1), *after, fraction);
}

CommonOutlines outlinesAt(const std::vector<ViewTrack> &views, Nanoseconds time)
{
    CommonOutlines common;
    common.time = time;
    for (const ViewTrack &view : views) {
        if (!view.floorView)
            continue;
        if (auto outline = outlineAt(view, time))
            common.outlines.push_back(std::move(*outline));
    }
    return common;
}

std::vector<CommonOutlines> spread(const std::vector<ViewTrack> &views, const std::vector<Nanoseconds> &times,
                                   std::size_t most)
{
    std::vector<CommonOutlines> chosen;
    const std::size_t count = std::min(times.size(), most);
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(outlinesAt(views, times[count > 1 ? i * (times.size() - 1) / (count - 1) : 0]));
    return chosen;
}

} // namespace

std::vector<CommonOutlines> commonOutlines(const std::vector<ViewTrack> &views, std::size_t most)
{
    std::vector<Nanoseconds> several, single;
    for (const ViewTrack &view : views) {
        if (!view.floorView)
            continue;
        for (const Observation &observation : view.observations) {
            if (!isClear(observation))
                continue;
            const Nanoseconds time = timeOf(view, observation);
            const std::size_t seeing = outlinesAt(views, time).outlines.size();
            if (seeing > 0)
                (seeing > 1 ? several : single).push_back(time);
        }
        // The other views' times add little to those of the first that saw it together with others.
        if (several.size() >= leastTimes)
            return spread(views, several, most);
    }
    return spread(views, single, most);
}

namespace {

// beyond the ends it is as at them
constexpr double lowestRad = -(ReachCorrection::elevations - 1) / 2.0 * ReachCorrection::stepRad;

} // namespace

ReachCorrection::Weights ReachCorrection::weightsAt(const Eigen::Vector3d &direction)
{
    const double up = std::atan2(direction.z(), direction.head<2>().norm());
    const double row = std::clamp((up - lowestRad) / stepRad, 0.0, double(elevations - 1));
    const double turn = std::atan2(direction.y(), direction.x()) / stepRad;
    const double column = turn < 0 ? turn + azimuths : turn;
    const int below = std::min(int(row), elevations - 2), before = int(column) % azimuths,
              behind = (before + 1) % azimuths;
    const double v = row - below, u = column - std::floor(column);
    return {{below * azimuths + before, below * azimuths + behind, (below + 1) * azimuths + before,
             (below + 1) * azimuths + behind},
            {(1 - v) * (1 - u), (1 - v) * u, v * (1 - u), v * u}};
}

Eigen::Vector3d ReachCorrection::directionOf(int node)
{
    const double up = lowestRad + node / azimuths * stepRad, turn = node % azimuths * stepRad;
    return {std::cos(up) * std::cos(turn), std::cos(up) * std::sin(turn), std::sin(up)};
}

double ReachCorrection::at(const Eigen::Vector3d &direction) const
{
    if (m_valuesM.size() == 0)
        return 0;
    const Weights weights = weightsAt(direction);
    double sum = 0;
    for (std::size_t i = 0; i < weights.node.size(); ++i)
        sum += weights.weight[i] * m_valuesM[weights.node[i]];
    return sum;
}

namespace {

constexpr double leastAxisSigmaRad = 0.01;

/// Of x, y and heading: the support against that seen, and the heading against the axis.
struct SupportDifference
{
    const FloorView &view;
    const SolidShape &shape;
    const Observation &observation;
    const OutlineDifference &known;
    const BodyAxis &axis;

    template <class T>
    bool operator()(const T *pose, T *residual) const
    {
        const Eigen::AngleAxisd toRobot(-valueOf(pose[2]), Eigen::Vector3d::UnitZ());
        const auto more = [&](std::size_t, const Eigen::Vector3d &slope) {
            return slope.norm() * known.reach.at(toRobot * slope);
        };
        std::array<T, supportDirections> reach;
        if (!reachOfLevels(view, levelsOfShape<T>(shape), T(shape.roundShare), pose, reach, more))
            return false;
        reachDifferences(observation.supportPx, observation.ellipse.centrePx, T(known.widerPx), reach,
                         residual);
        residual[supportDirections] = (pose[2] - axis.angleRad) / std::max(axis.sigmaRad, leastAxisSigmaRad);
        return true;
    }
};

} // namespace

std::optional<SupportPosition> positionBySupport(const FloorView &view, const SolidShape &shape,
                                                 const Observation &observation,
                                                 const OutlineDifference &known, const PositionGuess &guess)
{
    if (observation.supportPx.size() != supportDirections)
        return std::nullopt;
    const SolidShape levels = asLevels(shape);
    const SupportDifference difference{view, levels, observation, known, guess.axis};
    using Function = ceres::TinySolverAutoDiffFunction<SupportDifference, supportDirections + 1, 3>;
    const Function function(difference);
    ceres::TinySolver<Function> solver;
    solver.options.max_num_iterations = 20;
    Eigen::Vector3d pose(guess.position.x(), guess.position.y(), guess.axis.angleRad);
    const auto &summary = solver.Solve(function, &pose);
    Eigen::Matrix<double, supportDirections + 1, 1> residuals;
    Eigen::Matrix<double, supportDirections + 1, 3> slopes;
    if (!pose.allFinite() || !std::isfinite(summary.final_cost) ||
        !function(pose.data(), residuals.data(), slopes.data()))
        return std::nullopt;
    const Eigen::Matrix3d covariance = (slopes.transpose() * slopes).inverse();
    return SupportPosition{pose.head<2>(), {pose.z(), std::sqrt(std::max(0.0, covariance(2, 2)))}};
}

} // namespace odo
