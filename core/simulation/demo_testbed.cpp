// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"

#include <algorithm>
#include <cassert>
#include <numbers>

namespace odo {

namespace {

SimulatedScene sceneWith(std::uint32_t seed, SimulatedRobot robot, double durationS)
{
    SimulatedScene scene = demoTestbed(seed);
    scene.durationS = durationS;
    scene.robots.push_back(std::move(robot));
    return scene;
}

DemoTrial straight()
{
    SimulatedScene scene = sceneWith(
        11, demoRobot("Red 2", {.colour = demoRed}, makeLineMotion({0.35, 0.55}, {2.65, 1.6}, 1.0, 3.6)),
        6.0);
    scene.cameras[1].startOffsetS = 0.011;
    return {"straight", "Falcon", "Red 2", "Straight line", std::move(scene)};
}

DemoTrial circle()
{
    SimulatedScene scene = sceneWith(
        12, demoRobot("Blue 1", {.colour = demoBlue}, makeCircleMotion({1.5, 1.1}, 0.75, 1.1, 1.5)), 8.0);
    scene.cameras[1].startOffsetS = 0.019;
    return {"circle", "Otter", "Blue 1", "Circle", std::move(scene)};
}

/// A little wide of the task's circle.
DemoTrial circleWithRover()
{
    SimulatedScene scene =
        sceneWith(16, demoRobot("Rover 4", {}, makeCircleMotion({1.5, 1.1}, 0.77, 0.95, 1.8)), 8.0);
    scene.cameras[1].startOffsetS = 0.016;
    return {"circle with rover", "Heron", "Rover 4", "Circle", std::move(scene)};
}

DemoTrial figureEight()
{
    SimulatedScene scene = sceneWith(
        13,
        demoRobot("Green 3", {.colour = demoGreen}, makeFigureEightMotion({1.5, 1.1}, 1.05, 0.6, 5.2, 1.2)),
        10.0);
    scene.cameras[1].startOffsetS = 0.007;
    return {"figure-eight", "Lynx", "Green 3", "Figure eight", std::move(scene)};
}

DemoTrial stopAndGo()
{
    SimulatedScene scene = sceneWith(
        14,
        demoRobot("Red 2", {.colour = demoRed},
                  makeStopAndGoMotion({{0.45, 0.5}, {2.5, 0.55}, {2.4, 1.7}, {0.6, 1.65}}, 1.9, 0.7)),
        9.0);
    // Someone pressed the second camera's button half a second late.
    scene.cameras[1].startOffsetS = 0.512;
    return {"stop-and-go", "Falcon", "Red 2", "Stop and go", std::move(scene)};
}

/// A reflection of the robot's colour beside where the robot is at a time, seen by one camera only.
Reflection besideRobot(const SimulatedScene &scene, double timeS, double durationS,
                       const Eigen::Vector2d &offset, double radiusM, int camera)
{
    const SimulatedRobot &robot = scene.robots.front();
    return {robot.colour, robot.motion->at(timeS + durationS / 2).position + offset,
            radiusM,      timeS,
            durationS,    camera};
}

DemoTrial spikes()
{
    SimulatedScene scene = sceneWith(
        15, demoRobot("Blue 1", {.colour = demoBlue}, makeFigureEightMotion({1.5, 1.1}, 0.95, 0.6, 6.0, 1.2)),
        10.0);
    scene.cameras[1].startOffsetS = 0.014;
    // The first and the third join the robot's outline in both frames, and no view is left to trust; the
    // second one is seen by one camera alone, and the last is where no robot is.
    scene.reflections = {besideRobot(scene, 3.25, 0.09, {0.05, 0.16}, 0.13, -1),
                         besideRobot(scene, 5.10, 0.12, {-0.24, -0.02}, 0.12, 1),
                         besideRobot(scene, 7.88, 0.08, {0.16, -0.10}, 0.15, -1),
                         {demoBlue, {2.75, 0.25}, 0.09, 6.4, 0.25, 1}};
    return {"figure-eight with reflections", "Otter", "Blue 1", "Figure eight", std::move(scene)};
}

} // namespace

FloorView simulatedView(const Eigen::Vector3d &cameraInWorld, const Eigen::Vector3d &lookAtInWorld,
                        int widthPx, int heightPx, double focalPx)
{
    const Eigen::Vector3d forward = (lookAtInWorld - cameraInWorld).normalized();
    assert(std::abs(forward.z()) < 0.999);
    const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
    Eigen::Matrix3d axes;
    axes << right, forward.cross(right), forward;

    Intrinsics intrinsics;
    intrinsics.widthPx = widthPx;
    intrinsics.heightPx = heightPx;
    intrinsics.fxPx = focalPx;
    intrinsics.fyPx = focalPx * 1.001;
    intrinsics.cxPx = widthPx * 0.5 - 0.5 + 0.006 * widthPx;
    intrinsics.cyPx = heightPx * 0.5 - 0.5 - 0.008 * heightPx;
    intrinsics.distortion = {-0.11, 0.035, 0.0004, -0.0003, 0.0};
    const Result<CameraModel> camera = CameraModel::create(intrinsics);
    assert(camera.has_value());
    return {*camera, {Eigen::Quaterniond(axes), cameraInWorld}, Eigen::Matrix<double, 6, 6>::Zero()};
}

SimulatedScene demoTestbed(std::uint32_t seed)
{
    SimulatedScene scene;
    scene.seed = seed;
    scene.floor.markers = {"Gym floor", {{"O", {0, 0}}, {"U", {3.0, 0}}, {"V", {0, 2.2}}, {"D", {3.0, 2.2}}}};
    SimulatedCamera a{"A", simulatedView({-0.9, -1.55, 2.0}, {1.4, 0.75, 0.0}, 1280, 720, 960), 30, 0, 0, {},
                      0};
    SimulatedCamera b{"B", simulatedView({3.9, -1.55, 2.0}, {1.6, 0.75, 0.0}, 1280, 720, 940), 30, 0, 0, {},
                      0};
    scene.cameras = {std::move(a), std::move(b)};
    return scene;
}

std::vector<DemoTrial> demoTrials()
{
    std::vector<DemoTrial> trials;
    trials.push_back(straight());
    trials.push_back(circle());
    trials.push_back(circleWithRover());
    trials.push_back(figureEight());
    trials.push_back(stopAndGo());
    trials.push_back(spikes());
    return trials;
}

namespace {

constexpr double smallestM = 0.03, largestM = 0.5;

double sizeOr(const std::optional<double> &given, double usualM)
{
    return std::clamp(given.value_or(usualM), smallestM, largestM);
}

SimulatedRobot box(const RobotAppearance &appearance)
{
    SimulatedRobot robot;
    robot.colour = *appearance.colour;
    robot.lengthM = sizeOr(appearance.lengthM, robot.lengthM);
    robot.widthM = sizeOr(appearance.widthM, robot.widthM);
    robot.heightM = sizeOr(appearance.heightM, robot.heightM);
    return robot;
}

SimulatedRobot rover(const RobotAppearance &appearance)
{
    constexpr RgbColour rubber{28, 28, 30}, darkGrey{74, 76, 80}, lightGrey{142, 143, 146},
        boardGreen{24, 84, 58}, steel{112, 114, 118};
    constexpr double mastM = 0.1, mastThickM = 0.014;
    const double length = sizeOr(appearance.lengthM, 0.22), width = sizeOr(appearance.widthM, 0.192),
                 height = sizeOr(appearance.heightM, 0.098);
    const double wheelRadius = std::min(0.34 * height, 0.15 * length), wheelWidth = 0.146 * width;
    // Levels above the floor: under the chassis, on it, on the deck.
    const double chassisM = 0.85 * wheelRadius, deckM = 0.715 * height, boardM = 0.92 * height;
    const auto upright = [](SimulatedShape shape, RgbColour colour, double xM, const Eigen::Vector2d &acrossM,
                            double fromM, double toM) {
        return RobotPart{shape, colour, {xM, 0, (fromM + toM) / 2}, {acrossM.x(), acrossM.y(), toM - fromM}};
    };
    return robotOfParts(
        {},
        onFourWheels({upright(SimulatedShape::Box, darkGrey, 0, {length, 0.68 * width}, chassisM, deckM),
                      upright(SimulatedShape::Box, lightGrey, -0.045 * length, {0.73 * length, 0.57 * width},
                              deckM, boardM),
                      upright(SimulatedShape::Box, boardGreen, 0.07 * length, {0.39 * length, 0.29 * width},
                              boardM, height),
                      upright(SimulatedShape::Cylinder, steel, -0.295 * length, {mastThickM, mastThickM},
                              boardM, boardM + mastM)},
                     rubber, 0.47 * length - wheelRadius, (width - wheelWidth) / 2, wheelRadius, wheelWidth),
        nullptr);
}

} // namespace

SimulatedRobot demoRobot(std::string name, const RobotAppearance &appearance,
                         std::shared_ptr<const Motion> motion)
{
    SimulatedRobot robot = appearance.colour ? box(appearance) : rover(appearance);
    robot.name = std::move(name);
    robot.motion = std::move(motion);
    return robot;
}

std::vector<SimulatedRobot> circlingRobots(const std::vector<RobotAppearance> &appearances)
{
    constexpr std::size_t onACircle = 4, most = 8;
    constexpr double outerM = 0.75, innerM = 0.4, periodS = 2 * std::numbers::pi * outerM / 1.1;
    const Eigen::Vector2d middle(1.5, 1.1);
    if (appearances.empty())
        return circlingRobots({{.colour = demoBlue}});
    std::vector<SimulatedRobot> robots;
    const std::size_t count = std::min(appearances.size(), most), outside = std::min(count, onACircle);
    for (std::size_t i = 0; i < count; ++i) {
        const bool isOutside = i < outside;
        const auto position = double(isOutside ? i : i - outside),
                   positions = double(isOutside ? outside : count - outside);
        const double radiusM = isOutside ? outerM : innerM;
        robots.push_back(demoRobot(std::to_string(i + 1), appearances[i],
                                   makeEllipseMotion(middle, radiusM, radiusM, periodS,
                                                     2 * std::numbers::pi * position / positions, 1.5)));
    }
    return robots;
}

RobotPart wheelOnFloor(RgbColour colour, double xM, double yM, double radiusM, double widthM)
{
    return {SimulatedShape::Wheel, colour, {xM, yM, radiusM}, {2 * radiusM, widthM, 2 * radiusM}};
}

std::vector<RobotPart> onFourWheels(std::vector<RobotPart> parts, RgbColour colour, double xM, double yM,
                                    double radiusM, double widthM)
{
    for (const double atX : {xM, -xM})
        for (const double atY : {yM, -yM})
            parts.push_back(wheelOnFloor(colour, atX, atY, radiusM, widthM));
    return parts;
}

SimulatedRobot robotOfParts(std::string name, std::vector<RobotPart> parts,
                            std::shared_ptr<const Motion> motion)
{
    SimulatedRobot robot;
    robot.name = std::move(name);
    robot.motion = std::move(motion);
    Eigen::Vector3d upper = Eigen::Vector3d::Zero();
    for (const RobotPart &part : parts)
        upper = upper.cwiseMax(part.upper());
    robot.lengthM = 2 * upper.x(); // the origin is the middle
    robot.widthM = 2 * upper.y();
    robot.heightM = upper.z();
    robot.parts = std::move(parts);
    return robot;
}

} // namespace odo
