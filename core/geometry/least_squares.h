// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <functional>

namespace odo {

/// A small dense least-squares problem over any kind of state.
template <class State>
struct LeastSquaresProblem
{
    /// Fills the residuals and, unless null, their derivative by a step away from the state. False: the state
    /// is not allowed (a point behind the camera), and the step is undone.
    std::function<bool(const State &, Eigen::VectorXd &residuals, Eigen::MatrixXd *byStep)> evaluate;
    /// The state moved by a step; where states are no vectors (rotations) it says what a step means.
    std::function<State(const State &, const Eigen::VectorXd &step)> move;
};

/// Levenberg–Marquardt with Marquardt's scaling (Marquardt 1963; Nielsen's damping, 1999). Returns the best
/// state; the start itself when it is not allowed. Ends when a step lowers the cost by less than 1e-14 of
/// itself.
template <class State>
State minimise(const LeastSquaresProblem<State> &problem, State state, int iterations = 100)
{
    Eigen::VectorXd residuals, trial;
    Eigen::MatrixXd byStep;
    if (!problem.evaluate(state, residuals, &byStep))
        return state;
    double cost = residuals.squaredNorm(), damping = 1e-4, growth = 2;
    for (int i = 0; i < iterations && damping < 1e12; ++i) {
        const Eigen::MatrixXd normal = byStep.transpose() * byStep;
        Eigen::MatrixXd damped = normal;
        damped.diagonal() += damping * normal.diagonal();
        const Eigen::VectorXd step = -damped.ldlt().solve(byStep.transpose() * residuals);
        const State candidate = problem.move(state, step);
        const bool allowed = step.allFinite() && problem.evaluate(candidate, trial, nullptr);
        const double lower = allowed ? cost - trial.squaredNorm() : -1;
        if (!(lower >= 0)) {
            damping *= growth;
            growth *= 2;
            continue;
        }
        state = candidate;
        if (lower <= 1e-14 * cost)
            return state;
        problem.evaluate(state, residuals, &byStep);
        cost = residuals.squaredNorm();
        damping = std::max(damping / 3, 1e-12);
        growth = 2;
    }
    return state;
}

} // namespace odo
