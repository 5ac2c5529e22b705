// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/support_placing.h"

#include "core/trajectory/level_reach.h"

#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

#include <algorithm>

namespace odo {

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
        const auto more = [&](std::size_t, const Eigen::Vector3d &slope) { return slope.norm() * known.reach.at(toRobot * slope); };
        std::array<T, supportDirections> reach;
        if (!reachOfLevels(view, levelsOfShape<T>(shape), T(shape.roundShare), pose, reach, more))
            return false;
        reachDifferences(observation.supportPx, observation.ellipse.centrePx, T(known.widerPx), reach, residual);
        residual[supportDirections] = (pose[2] - axis.angleRad) / std::max(axis.sigmaRad, leastAxisSigmaRad);
        return true;
    }
};

} // namespace

std::optional<SupportPlace> placeBySupport(const FloorView &view, const SolidShape &shape, const Observation &observation, const OutlineDifference &known,
                                              const PlaceGuess &guess)
{
    if (observation.supportPx.size() != supportDirections)
        return std::nullopt;
    const SolidShape levels = asLevels(shape);
    const SupportDifference difference{view, levels, observation, known, guess.axis};
    using Function = ceres::TinySolverAutoDiffFunction<SupportDifference, supportDirections + 1, 3>;
    const Function function(difference);
    ceres::TinySolver<Function> solver;
    solver.options.max_num_iterations = 20;
    Eigen::Vector3d pose(guess.place.x(), guess.place.y(), guess.axis.angleRad);
    const auto &summary = solver.Solve(function, &pose);
    Eigen::Matrix<double, supportDirections + 1, 1> residuals;
    Eigen::Matrix<double, supportDirections + 1, 3> slopes;
    if (!pose.allFinite() || !std::isfinite(summary.final_cost) || !function(pose.data(), residuals.data(), slopes.data()))
        return std::nullopt;
    const Eigen::Matrix3d covariance = (slopes.transpose() * slopes).inverse();
    return SupportPlace{pose.head<2>(), {pose.z(), std::sqrt(std::max(0.0, covariance(2, 2)))}};
}

} // namespace odo
