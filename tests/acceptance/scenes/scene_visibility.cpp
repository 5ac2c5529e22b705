// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/scene_visibility.h"

#include "tests/acceptance/scenes/drawn_testbed.h"

#include <cmath>

namespace odo::test {

namespace {

constexpr double nearM = 0.35;

bool isShown(double startS, double durationS, double timeS, double marginS)
{
    return timeS >= startS - marginS && timeS <= startS + durationS + marginS;
}

/// Points over the body: a grid at the foot, at half the height and on the top.
std::vector<Eigen::Vector3d> bodyPoints(const SimulatedRobot &robot, const MotionState &state)
{
    std::vector<Eigen::Vector3d> points;
    const Eigen::Rotation2Dd turn(state.headingRad);
    for (const double z : {0.05, 0.5, 1.0}) {
        for (int i = -2; i <= 2; ++i) {
            for (int j = -2; j <= 2; ++j) {
                const Eigen::Vector2d inRobot(i * robot.lengthM / 4, j * robot.widthM / 4);
                const Eigen::Vector2d inWorld = state.position + turn * inRobot;
                points.emplace_back(inWorld.x(), inWorld.y(), z * robot.heightM);
            }
        }
    }
    return points;
}

/// Whether the line from a point to a camera goes through an upright board.
bool boardHides(const Occluder &board, const Eigen::Vector3d &point, const Eigen::Vector3d &camera)
{
    const Eigen::Vector2d along = board.to - board.from;
    const Eigen::Vector2d normal(-along.y(), along.x());
    const double before = normal.dot(point.head<2>() - board.from),
                 after = normal.dot(camera.head<2>() - board.from);
    if (before * after >= 0)
        return false;
    const Eigen::Vector3d hit = point + before / (before - after) * (camera - point);
    const double share = along.dot(hit.head<2>() - board.from) / along.squaredNorm();
    return share >= 0 && share <= 1 && hit.z() <= board.heightM;
}

/// Whether the line from a point to a camera goes through a robot's body, by the slabs of its box.
bool robotHides(const SimulatedRobot &robot, const MotionState &state, const Eigen::Vector3d &point,
                const Eigen::Vector3d &camera)
{
    const Eigen::Rotation2Dd back(-state.headingRad);
    const auto inRobot = [&](const Eigen::Vector3d &world) {
        const Eigen::Vector2d flat = back * (world.head<2>() - state.position);
        return Eigen::Vector3d(flat.x(), flat.y(), world.z());
    };
    const Eigen::Vector3d from = inRobot(point), way = inRobot(camera) - from;
    const Eigen::Vector3d lower(-robot.lengthM / 2, -robot.widthM / 2, 0);
    const Eigen::Vector3d upper(robot.lengthM / 2, robot.widthM / 2, robot.heightM);
    double enters = 0, leaves = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (lower[axis] - from[axis]) / way[axis], b = (upper[axis] - from[axis]) / way[axis];
        enters = std::max(enters, std::min(a, b));
        leaves = std::min(leaves, std::max(a, b));
    }
    return enters < leaves;
}

} // namespace

double hiddenShare(const SimulatedScene &scene, int camera, std::size_t robot, double timeS)
{
    const FloorView &view = scene.cameras[static_cast<std::size_t>(camera)].view;
    const std::vector<Eigen::Vector3d> points =
        bodyPoints(scene.robots[robot], scene.robots[robot].motion->at(timeS));
    std::size_t hidden = 0;
    for (const Eigen::Vector3d &point : points) {
        bool isHidden = !isInImage(view, point, 0);
        for (const Occluder &board : scene.occluders)
            isHidden = isHidden || (isShown(board.startS, board.durationS, timeS, 0) &&
                                    boardHides(board, point, view.cameraInWorld()));
        for (std::size_t other = 0; other < scene.robots.size() && !isHidden; ++other)
            isHidden =
                other != robot && robotHides(scene.robots[other], scene.robots[other].motion->at(timeS),
                                             point, view.cameraInWorld());
        hidden += isHidden ? 1 : 0;
    }
    return static_cast<double>(hidden) / static_cast<double>(points.size());
}

bool isDisturbed(const SimulatedScene &scene, std::size_t robot, double timeS)
{
    const double frameS = 1.0 / scene.cameras.front().framesPerSecond;
    const Eigen::Vector2d position = scene.robots[robot].motion->at(timeS).position;
    for (const Reflection &reflection : scene.reflections) {
        if (isShown(reflection.startS, reflection.durationS, timeS, frameS) &&
            (reflection.position - position).norm() - reflection.radiusM < nearM)
            return true;
    }
    for (const double moment : {timeS - frameS, timeS, timeS + frameS}) {
        for (std::size_t camera = 0; camera < scene.cameras.size(); ++camera) {
            const bool something = !scene.occluders.empty() || scene.robots.size() > 1;
            if (something && hiddenShare(scene, static_cast<int>(camera), robot, moment) > 0)
                return true;
        }
    }
    return false;
}

} // namespace odo::test
