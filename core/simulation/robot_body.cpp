// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/robot_body.h"

#include <cmath>
#include <numbers>

namespace odo {
namespace {

/// Outline in the robot's own axes, anticlockwise seen from above.
std::vector<Eigen::Vector2d> baseOutline(const SimulatedRobot &robot)
{
    std::vector<Eigen::Vector2d> outline;
    if (robot.shape == SimulatedShape::Box) {
        const double l = robot.lengthM / 2, w = robot.widthM / 2;
        return {{l, w}, {-l, w}, {-l, -w}, {l, -w}};
    }
    // The regular polygon has the circle's area: its corners lie 0.04 % outside, the middles of its sides
    // inside.
    const double step = 2 * std::numbers::pi / cylinderSides;
    const double radius = robot.lengthM / 2 * std::sqrt(step / std::sin(step));
    for (int i = 0; i < cylinderSides; ++i)
        outline.emplace_back(radius * std::cos(i * step), radius * std::sin(i * step));
    return outline;
}

std::vector<Eigen::Vector2d> grown(const std::vector<Eigen::Vector2d> &outline, double marginM)
{
    constexpr int arcSteps = 4;
    std::vector<Eigen::Vector2d> result;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Eigen::Vector2d &corner = outline[i];
        const Eigen::Vector2d in = corner - outline[(i + outline.size() - 1) % outline.size()];
        const Eigen::Vector2d out = outline[(i + 1) % outline.size()] - corner;
        const double from = std::atan2(-in.x(), in.y()),
                     turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
        const int steps = outline.size() > 8 ? 0 : arcSteps;
        for (int k = 0; k <= steps; ++k) {
            const double angle = from + (steps > 0 ? turn * k / steps : turn / 2);
            result.emplace_back(corner + marginM * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
        }
    }
    return result;
}

std::vector<Eigen::Vector3d> placed(const std::vector<Eigen::Vector2d> &outline, const MotionState &state,
                                    double heightM)
{
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(state.headingRad).toRotationMatrix();
    std::vector<Eigen::Vector3d> result;
    result.reserve(outline.size());
    for (const Eigen::Vector2d &point : outline) {
        const Eigen::Vector2d inWorld = turn * point + state.position;
        result.emplace_back(inWorld.x(), inWorld.y(), heightM);
    }
    return result;
}

/// Daylight from one side of the room, and a good deal from everywhere.
float sideShade(const Eigen::Vector2d &normal)
{
    const Eigen::Vector2d light = Eigen::Vector2d(-0.5, -0.85).normalized();
    return static_cast<float>(0.66 + 0.12 * normal.dot(light));
}

} // namespace

std::vector<BodyFace> visibleFaces(const SimulatedRobot &robot, const MotionState &state,
                                   const Eigen::Vector3d &cameraInWorld)
{
    const std::vector<Eigen::Vector2d> outline = baseOutline(robot);
    const std::vector<Eigen::Vector3d> bottom = placed(outline, state, 0.0);
    const std::vector<Eigen::Vector3d> top = placed(outline, state, robot.heightM);
    const Rgb colour = toRgb(robot.colour);
    std::vector<BodyFace> faces;
    if (cameraInWorld.z() > robot.heightM)
        faces.push_back({top, colour});
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = (i + 1) % outline.size();
        const Eigen::Vector2d along = (bottom[j] - bottom[i]).head<2>();
        const Eigen::Vector2d normal = Eigen::Vector2d(along.y(), -along.x()).normalized();
        if (normal.dot((cameraInWorld - bottom[i]).head<2>()) > 0)
            faces.push_back({{bottom[i], bottom[j], top[j], top[i]}, colour * sideShade(normal)});
    }
    return faces;
}

std::vector<Eigen::Vector3d> footprint(const SimulatedRobot &robot, const MotionState &state, double marginM)
{
    return placed(grown(baseOutline(robot), marginM), state, 0.0);
}

} // namespace odo
