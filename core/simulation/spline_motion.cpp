// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace odo {
namespace {

/// The velocities at the knots of the cubic spline that is at rest at both ends: the tridiagonal system
/// v[i-1] + 4 v[i] + v[i+1] = 3 (p[i+1] - p[i-1]) / h, solved by elimination (Thomas).
std::vector<Eigen::Vector2d> clampedVelocities(const std::vector<Eigen::Vector2d> &p, double stepS)
{
    const std::size_t n = p.size();
    std::vector<Eigen::Vector2d> v(n, Eigen::Vector2d::Zero());
    std::vector<double> ratio(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double pivot = 4.0 - ratio[i - 1];
        ratio[i] = 1.0 / pivot;
        v[i] = (3.0 / stepS * (p[i + 1] - p[i - 1]) - v[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 1;)
        v[i] -= ratio[i] * v[i + 1];
    return v;
}

/// Quintics between the knots that share position, velocity and acceleration with the clamped cubic spline
/// there, but with no acceleration at both ends: so that standing, running and standing again join without a
/// jump.
class SplineMotion : public Motion
{
public:
    SplineMotion(std::vector<Eigen::Vector2d> points, double stepS)
        : m_points(std::move(points)), m_stepS(stepS), m_velocities(clampedVelocities(m_points, stepS)),
          m_accelerations(m_points.size(), Eigen::Vector2d::Zero())
    {
        for (std::size_t i = 1; i + 1 < m_points.size(); ++i)
            m_accelerations[i] = 6 / (stepS * stepS) * (m_points[i + 1] - m_points[i]) -
                                 2 / stepS * (2 * m_velocities[i] + m_velocities[i + 1]);
    }

    MotionState at(double timeS) const override
    {
        // Where it stands the direction is that of the first or last instant of the way.
        const double endS = m_stepS * static_cast<double>(m_points.size() - 1);
        const double inside = std::clamp(timeS, 1e-3 * m_stepS, endS - 1e-3 * m_stepS);
        MotionState state = evaluate(std::clamp(timeS, 0.0, endS));
        const Eigen::Vector2d direction = evaluate(inside).velocity;
        state.headingRad = std::atan2(direction.y(), direction.x());
        return state;
    }

private:
    MotionState evaluate(double timeS) const
    {
        const double h = m_stepS;
        const auto i = std::min(static_cast<std::size_t>(timeS / h), m_points.size() - 2);
        const double u = timeS / h - static_cast<double>(i);
        const Eigen::Vector2d v0 = h * m_velocities[i], v1 = h * m_velocities[i + 1];
        const Eigen::Vector2d a0 = h * h * m_accelerations[i], a1 = h * h * m_accelerations[i + 1];
        // What the last three coefficients have to make up for at u = 1.
        const Eigen::Vector2d dp = m_points[i + 1] - m_points[i] - v0 - 0.5 * a0;
        const Eigen::Vector2d dv = v1 - v0 - a0;
        const Eigen::Vector2d da = a1 - a0;
        const Eigen::Vector2d c3 = 10 * dp - 4 * dv + 0.5 * da;
        const Eigen::Vector2d c4 = -15 * dp + 7 * dv - da;
        const Eigen::Vector2d c5 = 6 * dp - 3 * dv + 0.5 * da;
        MotionState state;
        state.position = m_points[i] + u * (v0 + u * (0.5 * a0 + u * (c3 + u * (c4 + u * c5))));
        state.velocity = (v0 + u * (a0 + u * (3 * c3 + u * (4 * c4 + u * 5 * c5)))) / h;
        state.acceleration = (a0 + u * (6 * c3 + u * (12 * c4 + u * 20 * c5))) / (h * h);
        return state;
    }

    const std::vector<Eigen::Vector2d> m_points;
    const double m_stepS;
    const std::vector<Eigen::Vector2d> m_velocities;
    std::vector<Eigen::Vector2d> m_accelerations;
};

} // namespace

std::shared_ptr<const Motion> makeSplineMotion(std::vector<Eigen::Vector2d> points, double stepS)
{
    assert(points.size() >= 2 && stepS > 0);
    return std::make_shared<SplineMotion>(std::move(points), stepS);
}

} // namespace odo
