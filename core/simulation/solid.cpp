// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/solid.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr int wheelSides = 48;

/// Of the regular polygon of the circle's area: with 96 sides its corners lie 0.04 % outside, the middles of its sides inside.
std::vector<Eigen::Vector2d> circle(double diameterM, int sides)
{
    const double step = 2 * std::numbers::pi / sides;
    const double radius = diameterM / 2 * std::sqrt(step / std::sin(step));
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < sides; ++i)
        points.emplace_back(radius * std::cos(i * step), radius * std::sin(i * step));
    return points;
}

std::vector<Eigen::Vector2d> rectangle(double length, double width)
{
    const double l = length / 2, w = width / 2;
    return {{l, w}, {-l, w}, {-l, -w}, {l, -w}};
}

SolidFace faceOf(std::vector<Eigen::Vector3d> corners)
{
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[1]).normalized();
    return {std::move(corners), normal};
}

/// Both ends and the sides of a prism. place: of a point of the outline at the lower (0) or upper (1) end.
template <class Place>
std::vector<SolidFace> prism(const std::vector<Eigen::Vector2d> &outline, const Place &place)
{
    std::vector<Eigen::Vector3d> lower, upper;
    for (const Eigen::Vector2d &point : outline) {
        lower.push_back(place(point, 0));
        upper.push_back(place(point, 1));
    }
    std::vector<SolidFace> faces{faceOf(upper), faceOf({lower.rbegin(), lower.rend()})};
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t next = (i + 1) % outline.size();
        faces.push_back(faceOf({lower[i], lower[next], upper[next], upper[i]}));
    }
    return faces;
}

/// What the camera sees of a sphere is bounded by the circle in which the cone of its tangents touches it.
SolidFace discOf(const RobotPart &sphere, const Eigen::Vector3d &cameraInRobot)
{
    const Eigen::Vector3d away = cameraInRobot - sphere.centreM;
    const double distance = away.norm(), radius = sphere.sizeM.x() / 2;
    const Eigen::Vector3d normal = away / distance;
    const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(normal).normalized(), up = normal.cross(right);
    const Eigen::Vector3d middle = sphere.centreM + normal * (radius * radius / distance);
    const double discRadius = radius * std::sqrt(1 - radius * radius / (distance * distance));
    SolidFace disc{{}, normal};
    for (const Eigen::Vector2d &point : circle(2 * discRadius, cylinderSides))
        disc.corners.emplace_back(middle + right * point.x() + up * point.y());
    return disc;
}

} // namespace

std::vector<SolidFace> facesOf(const RobotPart &part, const Eigen::Vector3d &cameraInRobot)
{
    if (part.shape == SimulatedShape::Sphere)
        return {discOf(part, cameraInRobot)};
    if (part.shape == SimulatedShape::Wheel) // its outline runs in the plane of x and z
        return prism(circle(part.sizeM.x(), wheelSides), [&part](const Eigen::Vector2d &point, int end) -> Eigen::Vector3d {
            return part.centreM + Eigen::Vector3d(point.x(), (0.5 - end) * part.sizeM.y(), point.y());
        });
    return prism(outlineFromAbove(part), [&part](const Eigen::Vector2d &point, int end) {
        return Eigen::Vector3d(point.x(), point.y(), end == 0 ? part.lower().z() : part.upper().z());
    });
}

std::vector<Eigen::Vector2d> outlineFromAbove(const RobotPart &part)
{
    const bool isRound = part.shape == SimulatedShape::Cylinder || part.shape == SimulatedShape::Sphere;
    std::vector<Eigen::Vector2d> outline = isRound ? circle(part.sizeM.x(), cylinderSides) : rectangle(part.sizeM.x(), part.sizeM.y());
    for (Eigen::Vector2d &point : outline)
        point += part.centreM.head<2>();
    return outline;
}

} // namespace odo
