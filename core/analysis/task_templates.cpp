// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/task_templates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double smallestM = 0.001;
constexpr int mostPoles = 100;
const Eigen::Vector2d up(0, 1);

void addLine(const TemplateSizes &sizes, Task &task)
{
    const Eigen::Vector2d way(std::cos(sizes.directionRad), std::sin(sizes.directionRad));
    const Eigen::Vector2d half = way * sizes.lengthM / 2;
    constexpr double gatesAt = 0.8; // of the half: the robot has come to speed, and need not stop yet
    const auto gate = [&](const char *name, GateRole role, double at) {
        task.gates.push_back(gateAcross(name, role, sizes.centre + at * half, way, sizes.gateM));
    };
    if (task.kind == TaskTemplate::StraightLine) {
        task.path.points = {sizes.centre - half, sizes.centre + half};
        gate("Start", GateRole::Start, -gatesAt);
        gate("Half-way", GateRole::Split, 0);
        gate("Finish", GateRole::Finish, gatesAt);
        return;
    }
    if (task.kind == TaskTemplate::Slalom)
        task.path = slalomPath(sizes.centre - half, sizes.centre + half, sizes.poles, sizes.widthM / 2);
    gate("Start", GateRole::Start, -1);
    gate("Finish", GateRole::Finish, 1);
}

void addRound(const TemplateSizes &sizes, Task &task)
{
    const Eigen::Vector2d end(sizes.lengthM / 2, 0);
    const bool circle = task.kind == TaskTemplate::Circle;
    task.path =
        circle ? circlePath(sizes.centre, end.x()) : figureEightPath(sizes.centre, end.x(), sizes.widthM / 2);
    // The circle goes up at its right end and down at its left one; the eight goes down at both.
    task.gates = {
        gateAcross("Lap", GateRole::StartFinish, sizes.centre + end, circle ? up : -up, sizes.gateM),
        gateAcross("Half lap", GateRole::Split, sizes.centre - end, -up, sizes.gateM)};
}

} // namespace

Result<Task> taskFromTemplate(TaskTemplate kind, const TemplateSizes &sizes)
{
    const auto refuse = [](Message why, Message advice) {
        return fail(ErrorCode::InvalidInput, ODO_TEXT("analysis.template_of_task", "template of a task"),
                    std::move(why), std::move(advice));
    };
    for (const double size : {sizes.lengthM, sizes.widthM, sizes.gateM})
        if (!(size >= smallestM) || !std::isfinite(size))
            return refuse(ODO_TEXT("analysis.size_too_small", "a size is less than 1 mm"),
                          ODO_TEXT("analysis.give_sizes", "enter the sizes in millimetres"));
    if (!sizes.centre.allFinite() || !std::isfinite(sizes.directionRad))
        return refuse(ODO_TEXT("analysis.place_no_number", "its position is not a number"),
                      ODO_TEXT("analysis.give_place", "enter its position in millimetres"));
    if (sizes.poles < 1 || sizes.poles > mostPoles)
        return refuse(ODO_TEXT("analysis.wrong_poles", "a slalom has 1 to 100 poles, not %1")(sizes.poles),
                      ODO_TEXT("analysis.give_another_number", "choose another number"));
    Task task;
    task.kind = kind;
    if (kind == TaskTemplate::Circle || kind == TaskTemplate::FigureEight)
        addRound(sizes, task);
    else
        addLine(sizes, task);
    ODO_TRY(checkTask(task));
    return task;
}

TemplateSizes suggestedSizes(const Task &task, const Eigen::Vector2d &position)
{
    TemplateSizes sizes;
    sizes.centre = position;
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d &point : task.path.points)
        box.extend(point);
    if (task.path.points.empty())
        for (const Gate &gate : task.gates)
            box.extend((gate.from + gate.to) / 2);
    if (!task.gates.empty())
        sizes.gateM = std::max(smallestM, (task.gates.front().to - task.gates.front().from).norm());
    if (box.isEmpty() || box.sizes().maxCoeff() < smallestM)
        return sizes;
    sizes.centre = box.center();
    sizes.lengthM = std::max(smallestM, box.sizes().x());
    sizes.widthM = std::max(smallestM, box.sizes().y());
    const bool isRound = task.kind == TaskTemplate::Circle || task.kind == TaskTemplate::FigureEight;
    const auto &points = task.path.points;
    const Eigen::Vector2d along = points.size() > 1 ? Eigen::Vector2d(points.back() - points.front())
                                  : task.gates.size() > 1
                                      ? Eigen::Vector2d(task.gates.back().from - task.gates.front().from)
                                      : Eigen::Vector2d(1, 0);
    if (!isRound && along.norm() >= smallestM) {
        sizes.lengthM = along.norm();
        if (points.size() > 1)
            sizes.centre = (points.front() + points.back()) / 2;
        sizes.directionRad = std::atan2(along.y(), along.x());
        sizes.widthM = TemplateSizes().widthM;
        const Eigen::Vector2d left = Eigen::Vector2d(-along.y(), along.x()).normalized();
        double swingM = 0;
        int crossings = 0;
        double before = 0;
        for (const Eigen::Vector2d &point : points) {
            const double aside = left.dot(point - points.front());
            swingM = std::max(swingM, std::abs(aside));
            if (std::abs(aside) <= smallestM)
                continue; // on the line, as both ends are
            crossings += before * aside < 0;
            before = aside;
        }
        if (task.kind == TaskTemplate::Slalom && swingM >= smallestM) {
            sizes.widthM = 2 * swingM;
            sizes.poles = std::clamp(crossings + 1, 1, mostPoles);
        }
    }
    return sizes;
}

} // namespace odo
