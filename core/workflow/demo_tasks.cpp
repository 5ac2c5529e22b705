// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/demo_tasks.h"

namespace odo {

namespace {

const Eigen::Vector2d middle(1.5, 1.1); // of the floor

Task straightLine()
{
    const Eigen::Vector2d from(0.35, 0.55), to(2.65, 1.6), way = (to - from).normalized();
    Task task;
    task.kind = TaskTemplate::StraightLine;
    task.gates = {gateAcross("Start", GateRole::Start, from + 0.4 * way, way, 0.5),
                  gateAcross("Half-way", GateRole::Split, (from + to) / 2, way, 0.5),
                  gateAcross("Finish", GateRole::Finish, to - 0.4 * way, way, 0.5)};
    task.path.points = {from, to};
    return task;
}

Task circle()
{
    constexpr double radiusM = 0.75;
    Task task;
    task.kind = TaskTemplate::Circle;
    const Eigen::Vector2d up(0, radiusM);
    task.gates = {gateAcross("Lap", GateRole::StartFinish, middle + up, {-1, 0}, 0.4),
                  gateAcross("Half lap", GateRole::Split, middle - up, {1, 0}, 0.4)};
    task.path = circlePath(middle, radiusM);
    return task;
}

Task figureEight()
{
    constexpr double halfWidthM = 1.05, halfHeightM = 0.6;
    Task task;
    task.kind = TaskTemplate::FigureEight;
    const Eigen::Vector2d end(halfWidthM, 0);
    task.gates = {gateAcross("Right", GateRole::StartFinish, middle + end, {0, -1}, 0.5),
                  gateAcross("Left", GateRole::Split, middle - end, {0, -1}, 0.5)};
    task.path = figureEightPath(middle, halfWidthM, halfHeightM);
    task.limits = {3.0, 15.0};
    return task;
}

Task stopAndGo()
{
    Task task;
    task.path.points = {{0.45, 0.5}, {2.5, 0.55}, {2.4, 1.7}, {0.6, 1.65}};
    const Eigen::Vector2d first = task.path.points[0], second = task.path.points[1];
    task.gates = {gateAcross("Start", GateRole::Start, first + 0.2 * (second - first), second - first, 0.4),
                  gateAcross("Finish", GateRole::Finish, {1.0, 1.6611}, {-1, 0}, 0.4)};
    return task;
}

} // namespace

std::vector<TaskRecord> demoTasks()
{
    return {{0, "Straight line", straightLine()},
            {0, "Circle", circle()},
            {0, "Figure eight", figureEight()},
            {0, "Stop and go", stopAndGo()}};
}

std::vector<Criterion> demoScoring(const Task &task)
{
    const bool hasLaps = task.kind == TaskTemplate::Circle || task.kind == TaskTemplate::FigureEight;
    return {{hasLaps ? "best_lap" : "gate_time", 1, 10, 60}, {"cross_track_rms", 0, 40, 40}, {"spikes", 10, 0, -10}};
}

} // namespace odo
