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
    const OutlineBias &bias;
    const BodyAxis &axis;

    template <class T>
    bool operator()(const T *pose, T *residual) const
    {
        LevelsOf<T> levels;
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const SolidLevel &level = shape.levels[i];
            levels[i] = {T(level.heightM), T(level.frontM), T(level.backM), T(level.leftM), T(level.rightM)};
        }
        std::array<T, supportDirections> reach;
        if (!reachOfLevels(view, levels, T(shape.roundShare), pose, reach))
            return false;
        reachDifferences(observation.supportPx, observation.ellipse.centrePx, T(bias.widerPx), T(bias.lowerPx), reach, residual);
        residual[supportDirections] = (pose[2] - axis.angleRad) / std::max(axis.sigmaRad, leastAxisSigmaRad);
        return true;
    }
};

} // namespace

std::optional<Eigen::Vector2d> placeBySupport(const FloorView &view, const SolidShape &shape, const Observation &observation, const OutlineBias &bias,
                                              const PlaceGuess &guess)
{
    if (observation.supportPx.size() != supportDirections)
        return std::nullopt;
    const SolidShape levels = asLevels(shape);
    const SupportDifference difference{view, levels, observation, bias, guess.axis};
    using Function = ceres::TinySolverAutoDiffFunction<SupportDifference, supportDirections + 1, 3>;
    const Function function(difference);
    ceres::TinySolver<Function> solver;
    solver.options.max_num_iterations = 20;
    Eigen::Vector3d pose(guess.place.x(), guess.place.y(), guess.axis.angleRad);
    const auto &summary = solver.Solve(function, &pose);
    if (!pose.allFinite() || !std::isfinite(summary.final_cost))
        return std::nullopt;
    return Eigen::Vector2d(pose.head<2>());
}

} // namespace odo
