// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/certificate/internal/known_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

using Eigen::Vector2d;

/// Whether a camera sees the whole robot at a position, whichever direction it points in.
bool seesRobot(const FloorView &view, const Vector2d &position, const SimulatedRobot &robot)
{
    constexpr double marginPx = 6;
    constexpr int corners = 8;
    const double radius = std::hypot(robot.lengthM, robot.widthM) / 2;
    const Intrinsics &image = view.camera().intrinsics();
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        for (const double height : {0.0, robot.heightM}) {
            const auto pixel = view.pixelFromWorld(
                {position.x() + radius * std::cos(angle), position.y() + radius * std::sin(angle), height});
            if (!pixel || pixel->x() < marginPx || pixel->y() < marginPx ||
                pixel->x() > image.widthPx - 1 - marginPx || pixel->y() > image.heightPx - 1 - marginPx)
                return false;
        }
    }
    return true;
}

std::size_t camerasThatSee(const CertificateSetUp &setUp, const Vector2d &position,
                           const SimulatedRobot &robot)
{
    return std::size_t(std::ranges::count_if(setUp.cameras, [&](const CertificateCamera &camera) {
        return seesRobot(camera.view, position, robot);
    }));
}

/// The floor in cells, each with the number of cameras that see a robot there.
struct SeenFloor
{
    static constexpr std::size_t side = 60; ///< cells along each axis
    Eigen::AlignedBox2d box;
    std::array<std::array<std::size_t, side>, side> cameras{}; ///< [row][column]

    Vector2d at(double column, double row) const
    {
        return box.min() + Vector2d(column, row).cwiseProduct(box.sizes()) / double(side);
    }
};

SeenFloor seenFloor(const CertificateSetUp &setUp, const SimulatedRobot &robot)
{
    SeenFloor floor{floorOf(setUp)};
    for (std::size_t row = 0; row < SeenFloor::side; ++row)
        for (std::size_t column = 0; column < SeenFloor::side; ++column)
            floor.cameras[row][column] =
                camerasThatSee(setUp, floor.at(double(column) + 0.5, double(row) + 0.5), robot);
    return floor;
}

/// The largest rectangle along the axes within which at least so many cameras see the robot. Each row counts
/// how many cells up from it are seen; the widest run of so high columns is tried for each height.
Eigen::AlignedBox2d largestSeen(const SeenFloor &floor, std::size_t cameras)
{
    constexpr std::size_t side = SeenFloor::side;
    std::array<std::size_t, side> high{};
    std::size_t largest = 0;
    Eigen::AlignedBox2d best;
    for (std::size_t row = 0; row < side; ++row) {
        for (std::size_t column = 0; column < side; ++column)
            high[column] = floor.cameras[row][column] >= cameras ? high[column] + 1 : 0;
        for (std::size_t from = 0; from < side; ++from) {
            std::size_t lowest = high[from];
            for (std::size_t to = from; to < side && lowest > 0; ++to) {
                lowest = std::min(lowest, high[to]);
                if (lowest * (to - from + 1) <= largest)
                    continue;
                largest = lowest * (to - from + 1);
                best = {floor.at(double(from), double(row + 1 - lowest)),
                        floor.at(double(to + 1), double(row + 1))};
            }
        }
    }
    return best;
}

/// Straight ahead, round an ellipse, and home in legs with stops, in a unit square.
std::vector<Vector2d> courseInSquare()
{
    constexpr double degree = std::numbers::pi / 180, fromDeg = -40, toDeg = 220, stepDeg = 4;
    std::vector<Vector2d> course = {{0.03, 0.05}};
    for (double angle = fromDeg; angle <= toDeg; angle += stepDeg)
        course.emplace_back(0.5 + 0.47 * std::cos(angle * degree), 0.55 + 0.43 * std::sin(angle * degree));
    course.insert(course.end(), {{0.45, 0.5}, {0.9, 0.55}});
    return course;
}

double speedFor(const Vector2d &extent)
{
    constexpr double slowestMps = 0.1, fastestMps = 1.2, diagonalsPerS = 0.45;
    return std::clamp(diagonalsPerS * extent.norm(), slowestMps, fastestMps);
}

Result<CourseRun> runOverFloor(const CertificateSetUp &setUp, const SimulatedRobot &robot)
{
    constexpr double leastRobots = 2, leastSquareRobots = 6; // sides and area, in lengths of the robot
    const double robotM = std::max(robot.lengthM, robot.widthM);
    const SeenFloor floor = seenFloor(setUp, robot);
    const std::size_t all = setUp.cameras.size(), least = std::min<std::size_t>(all, 2);
    for (std::size_t cameras = all; cameras >= least; --cameras) {
        const Eigen::AlignedBox2d area = largestSeen(floor, cameras);
        if (area.isEmpty() || area.sizes().minCoeff() < leastRobots * robotM ||
            area.volume() < leastSquareRobots * robotM * robotM)
            continue;
        std::vector<Vector2d> course;
        for (const Vector2d &point : courseInSquare())
            course.push_back(area.min() + point.cwiseProduct(area.sizes()));
        return driveCourse(course, {.speedMps = speedFor(area.sizes()), .pauseS = 0.45});
    }
    return fail(ErrorCode::Undetermined, certificateSubject(),
                all == 1 ? ODO_TEXT("workflow.camera_sees_too_little",
                                    "the camera sees too little of the floor between the markers for a run")
                         : ODO_TEXT("workflow.cameras_share_too_little",
                                    "no two cameras share enough of the floor between the markers for a run"),
                ODO_TEXT("workflow.turn_cameras_to_floor",
                         "turn the cameras to the same floor, and register them again"));
}

/// The line to drive along.
std::vector<Vector2d> courseOf(const Task &task)
{
    constexpr double beyondM = 0.4; // a single gate, and the first and last ones
    std::vector<Vector2d> course = task.path.points;
    if (course.size() >= 2) {
        if (task.path.closed)
            course.push_back(course.front());
        return course;
    }
    course.clear();
    const auto centreOf = [](const Gate &gate) { return Vector2d((gate.from + gate.to) / 2); };
    // from its left side to its right, as seen from `from` to `to`
    const auto ahead = [](const Gate &gate) {
        const Vector2d along = (gate.to - gate.from).normalized();
        return Vector2d(along.y(), -along.x());
    };
    course.push_back(centreOf(task.gates.front()) - beyondM * ahead(task.gates.front()));
    for (const Gate &gate : task.gates)
        course.push_back(centreOf(gate));
    course.push_back(centreOf(task.gates.back()) + beyondM * ahead(task.gates.back()));
    return course;
}

Result<CourseRun> runAlongTask(const CertificateSetUp &setUp, const SimulatedRobot &robot,
                               std::vector<Message> &remarks)
{
    constexpr double longestS = 18, limitShare = 0.8, stepS = 0.1, leastSeen = 0.5;
    const Task &task = setUp.task->task;
    const std::vector<Vector2d> course = courseOf(task);
    Eigen::AlignedBox2d extent;
    for (const Vector2d &point : course)
        extent.extend(point);
    CourseDriving driving{.speedMps = speedFor(extent.sizes())};
    if (task.limits.maxSpeedMps)
        driving.speedMps = std::min(driving.speedMps, limitShare * *task.limits.maxSpeedMps);
    if (task.limits.maxAccelMps2) {
        driving.accelMps2 = std::min(driving.accelMps2, limitShare * *task.limits.maxAccelMps2 / 2);
        // the steepest part of the ramp is 15/8 of its mean
        driving.rampS =
            std::max(driving.rampS, 15.0 / 8 * driving.speedMps / (limitShare * *task.limits.maxAccelMps2));
    }
    driving.longestM = longestS * driving.speedMps;
    CourseRun run = driveCourse(course, driving);
    std::size_t seen = 0, moments = 0;
    for (double timeS = 0; timeS < run.durationS; timeS += stepS, ++moments)
        seen += camerasThatSee(setUp, run.motion->at(timeS).position, robot) > 0;
    const double share = double(seen) / double(moments);
    const Message what =
        ODO_TEXT("workflow.course_of_task", "course of task '%1'")(Named::task(setUp.task->name));
    if (share < leastSeen)
        return fail(
            ErrorCode::Undetermined, certificateSubject(),
            ODO_TEXT("workflow.course_not_seen", "the cameras see only %1 of the course of task '%2'")(
                quantity(100 * share, 0, "%"), Named::task(setUp.task->name)),
            ODO_TEXT("workflow.choose_seen_task",
                     "choose a task on the floor that they see, or leave the task out"));
    if (seen < moments)
        remarks.push_back(
            wholeMessage(what, ODO_TEXT("workflow.course_seen_in_part", "no camera sees %1 of the run whole")(
                                   quantity(100 * (1 - share), 0, "%"))));
    return run;
}

} // namespace

Eigen::AlignedBox2d floorOf(const CertificateSetUp &setUp)
{
    Eigen::AlignedBox2d box;
    for (const CertificateCamera &camera : setUp.cameras)
        for (const Marker &marker : camera.layout.markers)
            box.extend(marker.pointInWorld);
    return box;
}

Result<CourseRun> planKnownRun(const CertificateSetUp &setUp, const SimulatedRobot &robot,
                               std::vector<Message> &remarks)
{
    return setUp.task ? runAlongTask(setUp, robot, remarks) : runOverFloor(setUp, robot);
}

} // namespace odo
