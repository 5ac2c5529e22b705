// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/course_motion.h"

#include "core/simulation/internal/smooth_ramp.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr double sharpestTurnRad = 20 * std::numbers::pi / 180;
constexpr double knotSpacingM = 0.1, samePointM = 1e-4;

/// The cubic spline through points whose distance along the line is the same; its curvature goes on to both
/// ends.
class LineSpline
{
public:
    LineSpline(std::vector<Vector2d> knots, double spacingM)
        : m_knots(std::move(knots)), m_spacingM(spacingM), m_seconds(m_knots.size(), Vector2d::Zero())
    {
        // M[i-1] + 4 M[i] + M[i+1] = 6 (p[i-1] - 2 p[i] + p[i+1]) / h², by elimination (Thomas), with
        // M[0] = M[1] and M[n-1] = M[n-2]
        const std::size_t n = m_knots.size();
        std::vector<double> ratio(n, 0.0);
        for (std::size_t i = 1; i + 1 < n; ++i) {
            const double pivot = 4 + (i == 1) + (i + 2 == n) - ratio[i - 1];
            ratio[i] = 1 / pivot;
            const Vector2d bend =
                6 / (m_spacingM * m_spacingM) * (m_knots[i - 1] - 2 * m_knots[i] + m_knots[i + 1]);
            m_seconds[i] = (bend - m_seconds[i - 1]) / pivot;
        }
        for (std::size_t i = n - 2; i-- > 1;)
            m_seconds[i] -= ratio[i] * m_seconds[i + 1];
        m_seconds.front() = m_seconds[1];
        m_seconds.back() = m_seconds[n - 2];
    }

    double lengthM() const { return m_spacingM * double(m_knots.size() - 1); }
    double largestCurvature() const
    {
        double largest = 0;
        for (const Vector2d &second : m_seconds)
            largest = std::max(largest, second.norm());
        return largest;
    }

    struct Point
    {
        Vector2d point, first, second; ///< and its derivatives by the distance
    };
    Point at(double distanceM) const
    {
        const double h = m_spacingM, s = std::clamp(distanceM, 0.0, lengthM());
        const auto i = std::min(static_cast<std::size_t>(s / h), m_knots.size() - 2);
        const double b = s / h - double(i), a = 1 - b;
        const Vector2d &m0 = m_seconds[i], &m1 = m_seconds[i + 1];
        return {a * m_knots[i] + b * m_knots[i + 1] +
                    h * h / 6 * ((a * a * a - a) * m0 + (b * b * b - b) * m1),
                (m_knots[i + 1] - m_knots[i]) / h + h / 6 * ((1 - 3 * a * a) * m0 + (3 * b * b - 1) * m1),
                a * m0 + b * m1};
    }

private:
    std::vector<Vector2d> m_knots;
    double m_spacingM;
    std::vector<Vector2d> m_seconds; ///< second derivatives at the knots
};

/// A line between two stops: speeds up, drives evenly, slows down.
struct CourseLeg
{
    LineSpline line;
    double startS = 0, speedMps = 0, rampS = 0;

    double endS() const { return startS + line.lengthM() / speedMps + rampS; }

    MotionState at(double timeS) const
    {
        const double t = std::clamp(timeS - startS, 0.0, endS() - startS), left = endS() - startS - t;
        const bool isSlowing = left < rampS;
        const double u = (isSlowing ? left : t) / rampS;
        const double driven =
            speedMps * (rampS * smoothRampIntegral(u) + std::max(0.0, (isSlowing ? left : t) - rampS));
        const RampValue ramp = smoothRamp(u);
        const double speed = speedMps * ramp.value,
                     change = (isSlowing ? -1 : 1) * speedMps * ramp.first / rampS;
        const LineSpline::Point on = line.at(isSlowing ? line.lengthM() - driven : driven);
        MotionState state;
        state.position = on.point;
        state.velocity = on.first * speed;
        state.acceleration = on.second * (speed * speed) + on.first * change;
        state.headingRad = std::atan2(on.first.y(), on.first.x());
        return state;
    }
};

class CourseMotion : public Motion
{
public:
    explicit CourseMotion(std::vector<CourseLeg> legs) : m_legs(std::move(legs)) {}

    MotionState at(double timeS) const override
    {
        std::size_t leg = 0;
        while (leg + 1 < m_legs.size() && timeS > m_legs[leg].endS())
            ++leg;
        MotionState state = m_legs[leg].at(timeS);
        if (leg == 0 || timeS >= m_legs[leg].startS)
            return state;
        // Between two legs it turns on the spot towards the next.
        const CourseLeg &before = m_legs[leg - 1];
        const double from = before.at(before.endS()).headingRad;
        const double turn = std::remainder(state.headingRad - from, 2 * std::numbers::pi);
        const double pauseS = m_legs[leg].startS - before.endS();
        state.headingRad = from + turn * smoothRamp((timeS - before.endS()) / pauseS).value;
        return state;
    }

private:
    std::vector<CourseLeg> m_legs;
};

double turnAt(const Vector2d &before, const Vector2d &at, const Vector2d &after)
{
    const Vector2d in = at - before, out = after - at;
    return std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out)));
}

/// Without points that repeat the one before, and no longer than so much.
std::vector<Vector2d> distinct(const std::vector<Vector2d> &points, double longestM)
{
    std::vector<Vector2d> kept;
    double left = longestM;
    for (const Vector2d &point : points) {
        if (kept.empty()) {
            kept.push_back(point);
            continue;
        }
        const double step = (point - kept.back()).norm();
        if (step < samePointM)
            continue;
        kept.push_back(kept.back() + std::min(1.0, left / step) * (point - kept.back()));
        left -= step;
        if (left <= 0)
            break;
    }
    return kept;
}

std::vector<std::vector<Vector2d>> linesBetweenCorners(const std::vector<Vector2d> &points)
{
    std::vector<std::vector<Vector2d>> lines(1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        lines.back().push_back(points[i]);
        if (i > 0 && i + 1 < points.size() &&
            turnAt(points[i - 1], points[i], points[i + 1]) > sharpestTurnRad)
            lines.push_back({points[i]});
    }
    return lines;
}

/// Through points of the line at equal distances along it.
LineSpline splineAlong(const std::vector<Vector2d> &line)
{
    std::vector<double> at(1, 0.0);
    for (std::size_t i = 1; i < line.size(); ++i)
        at.push_back(at.back() + (line[i] - line[i - 1]).norm());
    const auto steps = std::max<std::size_t>(2, std::size_t(std::ceil(at.back() / knotSpacingM)));
    const double spacing = at.back() / double(steps);
    std::vector<Vector2d> knots;
    std::size_t piece = 1;
    for (std::size_t k = 0; k <= steps; ++k) {
        const double s = spacing * double(k);
        while (piece + 1 < line.size() && at[piece] < s)
            ++piece;
        const double u = std::clamp((s - at[piece - 1]) / (at[piece] - at[piece - 1]), 0.0, 1.0);
        knots.push_back(line[piece - 1] + u * (line[piece] - line[piece - 1]));
    }
    return {std::move(knots), spacing};
}

} // namespace

CourseRun driveCourse(const std::vector<Vector2d> &points, const CourseDriving &driving)
{
    assert(driving.speedMps > 0 && driving.rampS > 0 && driving.pauseS > 0 && driving.longestM > 0);
    const std::vector<Vector2d> course = distinct(points, driving.longestM);
    assert(course.size() >= 2);
    CourseRun run;
    run.corners.push_back(course.front());
    std::vector<CourseLeg> legs;
    double timeS = driving.pauseS;
    for (const std::vector<Vector2d> &line : linesBetweenCorners(course)) {
        CourseLeg leg{splineAlong(line), timeS, driving.speedMps, driving.rampS};
        if (const double curvature = leg.line.largestCurvature(); curvature > 0)
            leg.speedMps = std::min(leg.speedMps, std::sqrt(driving.accelMps2 / curvature));
        leg.speedMps = std::min(leg.speedMps, leg.line.lengthM() / driving.rampS); // of a short one
        timeS = leg.endS() + driving.pauseS;
        run.lengthM += leg.line.lengthM();
        run.topSpeedMps = std::max(run.topSpeedMps, leg.speedMps);
        run.corners.push_back(line.back());
        legs.push_back(std::move(leg));
    }
    run.durationS = timeS;
    run.motion = std::make_shared<CourseMotion>(std::move(legs));
    return run;
}

} // namespace odo
