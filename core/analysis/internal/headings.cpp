// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/motion_stretches.h"
#include "core/analysis/quantity_curve.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

namespace odo {

namespace {

constexpr double sigmasForCourse = 3;
constexpr double pi = std::numbers::pi;
constexpr double longestReversalS = 1; // a robot that stands for longer may have turned on the spot
constexpr double leastReversalRad = 3 * pi / 4;
constexpr double nearS = 0.5, clearShare = 0.2; // it moves clearly: not slower than its fastest near by
constexpr double muchLonger = 2;

double unwrapped(double angle, double last)
{
    return last + std::remainder(angle - last, 2 * pi);
}

/// A point that moves clearly.
struct ClearCourse
{
    std::size_t point = 0;
    double timeS = 0, courseRad = 0, lengthM = 0; ///< length: from the one before
    bool isBackwards = false;
};

/// The largest speed within nearS of each of the instants.
std::vector<double> fastestNearby(const std::vector<RunInstant> &instants)
{
    std::vector<double> fastest(instants.size());
    std::deque<std::size_t> falling; // of those within reach: each one faster than all behind it
    std::size_t next = 0;
    for (std::size_t i = 0; i < instants.size(); ++i) {
        for (; next < instants.size() && instants[next].timeS <= instants[i].timeS + nearS; ++next) {
            while (!falling.empty() &&
                   instants[falling.back()].point->speedMps <= instants[next].point->speedMps)
                falling.pop_back();
            falling.push_back(next);
        }
        while (instants[falling.front()].timeS < instants[i].timeS - nearS)
            falling.pop_front();
        fastest[i] = instants[falling.front()].point->speedMps;
    }
    return fastest;
}

/// Whether a stretch is driven the other way round than it was assumed at first.
bool isOtherWayRound(std::span<const ClearCourse> stretch, const std::vector<ProfilePoint> &points)
{
    double agreement = 0, forwardsM = 0, backwardsM = 0;
    for (const ClearCourse &one : stretch) {
        const auto &body = points[one.point].body;
        if (body && body->isFrontKnown())
            agreement += (one.isBackwards ? -1 : 1) * std::cos(body->radians - one.courseRad);
        (one.isBackwards ? backwardsM : forwardsM) += one.lengthM;
    }
    return agreement != 0 ? agreement < 0 : backwardsM > muchLonger * forwardsM;
}

/// The clear courses of a run, each marked where the robot moves backwards.
std::vector<ClearCourse> clearCourses(const std::vector<RunInstant> &instants,
                                      const std::vector<ProfilePoint> &points)
{
    std::vector<ClearCourse> clear;
    const std::vector<double> fastest = fastestNearby(instants);
    std::size_t first = 0; // of the stretch without a long stop
    const auto endStretch = [&] {
        const auto stretch = std::span(clear).subspan(first);
        if (isOtherWayRound(stretch, points))
            for (ClearCourse &one : stretch)
                one.isBackwards = !one.isBackwards;
        first = clear.size();
    };
    for (std::size_t i = 0; i < instants.size(); ++i) {
        if (!instants[i].joined)
            endStretch();
        const ProfilePoint &point = *instants[i].point;
        const auto course = courseOf(point);
        if (!course || point.speedMps < clearShare * fastest[i])
            continue;
        ClearCourse one{static_cast<std::size_t>(instants[i].point - points.data()), instants[i].timeS,
                        course->headingRad};
        if (clear.size() > first && one.timeS - clear.back().timeS > longestReversalS)
            endStretch();
        if (clear.size() > first) {
            const ClearCourse &before = clear.back();
            const bool reverses =
                std::abs(std::remainder(one.courseRad - before.courseRad, 2 * pi)) > leastReversalRad;
            one.isBackwards = before.isBackwards != reverses;
            one.lengthM = point.speedMps * (one.timeS - before.timeS);
        }
        clear.push_back(one);
    }
    endStretch();
    return clear;
}

/// The direction of motion of each point that has a course, turned round where the robot moves backwards.
class ForwardCourses
{
public:
    explicit ForwardCourses(const Profile &profile)
        : m_points(profile.points),
          m_clear(clearCourses(validInstants(profile.samples, profile.points), profile.points))
    {
    }

    /// Points in their order.
    std::optional<Heading> at(std::size_t point)
    {
        const auto course = courseOf(m_points[point]);
        if (!course)
            return std::nullopt;
        while (m_next < m_clear.size() && m_clear[m_next].point < point)
            ++m_next;
        if (m_next < m_clear.size() && m_clear[m_next].point == point)
            return Heading{forwardRad(m_clear[m_next]), course->sigmaHeadingRad, false};
        // Slower than near by: the way round that is nearer to that of the next clear one.
        const bool isNext = m_next < m_clear.size() && (m_next == 0 || m_clear[m_next].point - point <
                                                                           point - m_clear[m_next - 1].point);
        double radians = course->headingRad;
        if (!m_clear.empty()) {
            const double near = forwardRad(m_clear[isNext ? m_next : m_next - 1]);
            if (std::cos(radians - near) < 0)
                radians += pi;
        }
        return Heading{radians, course->sigmaHeadingRad, false};
    }

private:
    static double forwardRad(const ClearCourse &course)
    {
        return course.courseRad + (course.isBackwards ? pi : 0);
    }
    const std::vector<ProfilePoint> &m_points;
    std::vector<ClearCourse> m_clear;
    std::size_t m_next = 0; ///< the first clear one that is not before the point
};

} // namespace

std::optional<MotionCourse> courseOf(const ProfilePoint &point)
{
    const Eigen::Vector2d &v = point.velocity, &a = point.acceleration;
    const double speed = v.norm();
    if (!point.valid || !v.allFinite() || !(speed > sigmasForCourse * point.sigmaSpeedMps))
        return std::nullopt;
    MotionCourse course;
    course.headingRad = std::atan2(v.y(), v.x());
    course.sigmaHeadingRad = point.sigmaSpeedMps / speed;
    course.turnRateRadps = (v.x() * a.y() - v.y() * a.x()) / (speed * speed);
    course.sigmaTurnRateRadps =
        std::hypot(point.sigmaAccelMps2 / speed, a.norm() * point.sigmaSpeedMps / (speed * speed));
    return course;
}

std::optional<CurveValue> turnRateOf(const ProfilePoint &point)
{
    if (point.valid && point.body)
        return CurveValue{point.body->turnRateRadps, point.body->sigmaTurnRateRadps};
    const auto course = courseOf(point);
    return course ? std::optional(CurveValue{course->turnRateRadps, course->sigmaTurnRateRadps})
                  : std::nullopt;
}

std::string_view headingSource(const Heading &heading)
{
    return heading.isOfBody ? "body" : "motion";
}

std::vector<std::optional<Heading>> headingsOf(const Profile &profile)
{
    const std::vector<ProfilePoint> &points = profile.points;
    std::vector<std::optional<Heading>> headings(points.size());
    ForwardCourses courses(profile);
    std::optional<double> last;
    std::size_t first = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].valid)
            continue;
        const auto &body = points[i].body;
        auto known = body && body->isFrontKnown()
                         ? std::optional(Heading{body->radians, body->sigmaRad, true})
                         : courses.at(i);
        if (known) {
            known->radians = last ? unwrapped(known->radians, *last) : known->radians;
            first = last ? first : i;
            last = known->radians;
        } else if (last) {
            known = Heading{*last, {}, false};
        }
        headings[i] = known;
    }
    for (std::size_t i = 0; last && i < first; ++i)
        if (points[i].valid)
            headings[i] = Heading{headings[first]->radians, {}, headings[first]->isOfBody};
    return headings;
}

} // namespace odo
