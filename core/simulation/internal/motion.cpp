// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/internal/motion.h"

#include "core/simulation/internal/smooth_ramp.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

double headingOf(const Eigen::Vector2d &direction)
{
    return std::atan2(direction.y(), direction.x());
}

class LineMotion : public Motion
{
public:
    LineMotion(Eigen::Vector2d start, const Eigen::Vector2d &end, double startS, double durationS)
        : m_start(std::move(start)), m_way(end - m_start), m_startS(startS), m_durationS(durationS)
    {
        assert(durationS > 0);
    }

    MotionState at(double timeS) const override
    {
        const RampValue ramp = smoothRamp((timeS - m_startS) / m_durationS);
        MotionState state;
        state.position = m_start + ramp.value * m_way;
        state.velocity = (ramp.first / m_durationS) * m_way;
        state.acceleration = (ramp.second / (m_durationS * m_durationS)) * m_way;
        state.headingRad = headingOf(m_way);
        return state;
    }

private:
    const Eigen::Vector2d m_start, m_way;
    const double m_startS, m_durationS;
};

/// A point of a closed curve and its derivatives by the phase.
struct CurvePoint
{
    Eigen::Vector2d point, first, second;
};

/// Runs along a curve whose phase starts from rest: its rate is a smooth ramp of rampS up to the steady rate.
class CurveMotion : public Motion
{
public:
    CurveMotion(double rateRadPerS, double rampS, double firstPhaseRad = 0)
        : m_rate(rateRadPerS), m_rampS(rampS), m_firstPhaseRad(firstPhaseRad)
    {
        assert(rampS > 0);
    }

    MotionState at(double timeS) const override
    {
        const double u = timeS / m_rampS;
        const RampValue ramp = smoothRamp(u);
        const double phase =
            m_firstPhaseRad + m_rate * m_rampS * (smoothRampIntegral(u) + std::max(0.0, u - 1.0));
        const double phaseRate = m_rate * ramp.value;
        const CurvePoint curve = curveAt(phase);
        MotionState state;
        state.position = curve.point;
        state.velocity = curve.first * phaseRate;
        state.acceleration =
            curve.second * (phaseRate * phaseRate) + curve.first * (m_rate * ramp.first / m_rampS);
        state.headingRad = headingOf(curve.first);
        return state;
    }

protected:
    virtual CurvePoint curveAt(double phase) const = 0;

private:
    const double m_rate, m_rampS, m_firstPhaseRad;
};

class EllipseMotion : public CurveMotion
{
public:
    EllipseMotion(Eigen::Vector2d centre, double halfWidthM, double halfHeightM, double periodS,
                  double phaseRad, double rampS)
        : CurveMotion(2.0 * std::numbers::pi / periodS, rampS, phaseRad), m_centre(std::move(centre)),
          m_halfWidthM(halfWidthM), m_halfHeightM(halfHeightM)
    {
        assert(periodS > 0 && halfWidthM > 0 && halfHeightM > 0);
    }

protected:
    CurvePoint curveAt(double phase) const override
    {
        const Eigen::Vector2d arm(m_halfWidthM * std::cos(phase), m_halfHeightM * std::sin(phase));
        return {m_centre + arm, {-m_halfWidthM * std::sin(phase), m_halfHeightM * std::cos(phase)}, -arm};
    }

private:
    const Eigen::Vector2d m_centre;
    const double m_halfWidthM, m_halfHeightM;
};

class CircleMotion : public CurveMotion
{
public:
    CircleMotion(Eigen::Vector2d centre, double radiusM, double speedMps, double rampS)
        : CurveMotion(speedMps / radiusM, rampS), m_centre(std::move(centre)), m_radiusM(radiusM)
    {
        assert(radiusM > 0);
    }

protected:
    CurvePoint curveAt(double phase) const override
    {
        const Eigen::Vector2d arm = m_radiusM * Eigen::Vector2d(std::cos(phase), std::sin(phase));
        return {m_centre + arm, {-arm.y(), arm.x()}, -arm};
    }

private:
    const Eigen::Vector2d m_centre;
    const double m_radiusM;
};

class FigureEightMotion : public CurveMotion
{
public:
    FigureEightMotion(Eigen::Vector2d centre, double halfWidthM, double halfHeightM, double periodS,
                      double rampS)
        : CurveMotion(2.0 * std::numbers::pi / periodS, rampS), m_centre(std::move(centre)),
          m_halfWidthM(halfWidthM), m_halfHeightM(halfHeightM)
    {
        assert(periodS > 0);
    }

protected:
    CurvePoint curveAt(double phase) const override
    {
        const double a = m_halfWidthM, b = m_halfHeightM;
        return {m_centre + Eigen::Vector2d(a * std::sin(phase), b * std::sin(2 * phase)),
                {a * std::cos(phase), 2 * b * std::cos(2 * phase)},
                {-a * std::sin(phase), -4 * b * std::sin(2 * phase)}};
    }

private:
    const Eigen::Vector2d m_centre;
    const double m_halfWidthM, m_halfHeightM;
};

/// Each leg is a line motion after a pause; in the pause the robot turns on the spot towards the next leg.
class StopAndGoMotion : public Motion
{
public:
    StopAndGoMotion(const std::vector<Eigen::Vector2d> &points, double legS, double pauseS)
        : m_legS(legS), m_pauseS(pauseS)
    {
        assert(points.size() >= 2 && legS > 0 && pauseS >= 0);
        for (std::size_t i = 1; i < points.size(); ++i)
            m_legs.emplace_back(points[i - 1], points[i], legStart(i - 1), legS);
    }

    MotionState at(double timeS) const override
    {
        // The current leg, or the next one while it pauses.
        const double last = static_cast<double>(m_legs.size() - 1);
        const double cycle = m_legS + m_pauseS;
        const auto leg = static_cast<std::size_t>(std::clamp(std::floor(timeS / cycle), 0.0, last));
        MotionState state = m_legs[leg].at(timeS);
        if (leg > 0 && timeS < legStart(leg)) {
            const double before = m_legs[leg - 1].at(timeS).headingRad;
            const double turn = std::remainder(state.headingRad - before, 2 * std::numbers::pi);
            const double u = 1.0 - (legStart(leg) - timeS) / m_pauseS;
            state.headingRad = before + turn * smoothRamp(u).value;
        }
        return state;
    }

private:
    double legStart(std::size_t leg) const
    {
        return m_pauseS + static_cast<double>(leg) * (m_legS + m_pauseS);
    }

    const double m_legS, m_pauseS;
    std::vector<LineMotion> m_legs;
};

/// The ramps' integrals, added up.
class VelocityMotion : public Motion
{
public:
    VelocityMotion(Eigen::Vector2d start, double headingRad, std::vector<VelocityChange> changes)
        : m_start(std::move(start)), m_headingRad(headingRad), m_changes(std::move(changes))
    {
        for ([[maybe_unused]] const VelocityChange &change : m_changes)
            assert(change.durationS > 0);
    }

    MotionState at(double timeS) const override
    {
        MotionState state;
        state.position = m_start;
        state.headingRad = m_headingRad;
        for (const VelocityChange &change : m_changes) {
            const double u = (timeS - change.startS) / change.durationS;
            const RampValue ramp = smoothRamp(u);
            const double way = smoothRampIntegral(u) + std::max(0.0, u - 1.0);
            state.position += change.durationS * way * change.deltaMps;
            state.velocity += ramp.value * change.deltaMps;
            state.acceleration += ramp.first / change.durationS * change.deltaMps;
        }
        return state;
    }

private:
    const Eigen::Vector2d m_start;
    const double m_headingRad;
    const std::vector<VelocityChange> m_changes;
};

} // namespace

std::shared_ptr<const Motion> makeLineMotion(Eigen::Vector2d start, const Eigen::Vector2d &end, double startS,
                                             double durationS)
{
    return std::make_shared<LineMotion>(std::move(start), end, startS, durationS);
}

std::shared_ptr<const Motion> makeCircleMotion(Eigen::Vector2d centre, double radiusM, double speedMps,
                                               double rampS)
{
    return std::make_shared<CircleMotion>(std::move(centre), radiusM, speedMps, rampS);
}

std::shared_ptr<const Motion> makeFigureEightMotion(Eigen::Vector2d centre, double halfWidthM,
                                                    double halfHeightM, double periodS, double rampS)
{
    return std::make_shared<FigureEightMotion>(std::move(centre), halfWidthM, halfHeightM, periodS, rampS);
}

std::shared_ptr<const Motion> makeEllipseMotion(Eigen::Vector2d centre, double halfWidthM, double halfHeightM,
                                                double periodS, double phaseRad, double rampS)
{
    return std::make_shared<EllipseMotion>(std::move(centre), halfWidthM, halfHeightM, periodS, phaseRad,
                                           rampS);
}

std::shared_ptr<const Motion> makeVelocityMotion(Eigen::Vector2d start, double headingRad,
                                                 std::vector<VelocityChange> changes)
{
    return std::make_shared<VelocityMotion>(std::move(start), headingRad, std::move(changes));
}

std::shared_ptr<const Motion> makeStopAndGoMotion(const std::vector<Eigen::Vector2d> &points, double legS,
                                                  double pauseS)
{
    return std::make_shared<StopAndGoMotion>(points, legS, pauseS);
}

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
        // Where it stands still the direction is that of the first or last instant of the path.
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
