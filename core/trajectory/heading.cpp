// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/heading.h"

#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double sigmasForCourse = 3;

double unwrapped(double angle, double last)
{
    return last + std::remainder(angle - last, 2 * std::numbers::pi);
}

} // namespace

std::optional<Course> courseOf(const ProfilePoint &point)
{
    const Eigen::Vector2d &v = point.velocity, &a = point.acceleration;
    const double speed = v.norm();
    if (!point.valid || !v.allFinite() || !(speed > sigmasForCourse * point.sigmaSpeedMps))
        return std::nullopt;
    Course course;
    course.headingRad = std::atan2(v.y(), v.x());
    course.sigmaHeadingRad = point.sigmaSpeedMps / speed;
    course.turnRateRadps = (v.x() * a.y() - v.y() * a.x()) / (speed * speed);
    course.sigmaTurnRateRadps =
        std::hypot(point.sigmaAccelMps2 / speed, a.norm() * point.sigmaSpeedMps / (speed * speed));
    return course;
}

std::vector<std::optional<Heading>> headingsOf(const std::vector<ProfilePoint> &points)
{
    std::vector<std::optional<Heading>> headings(points.size());
    std::optional<double> last;
    for (const ProfilePoint &point : points) {
        if (const auto course = courseOf(point)) {
            last = course->headingRad;
            break;
        }
    }
    if (!last)
        return headings;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].valid)
            continue;
        const auto course = courseOf(points[i]);
        if (course)
            last = unwrapped(course->headingRad, *last);
        headings[i] = Heading{*last, course ? std::optional(course->sigmaHeadingRad) : std::nullopt};
    }
    return headings;
}

} // namespace odo
