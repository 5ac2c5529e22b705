// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// What a zone requires of a robot's reference point.
enum class ZoneRule { StayInside, StayOutside };

/// A part of the floor within which a robot must stay, or out of which it must keep: a polygon by its
/// corners, in order all the way round, either way. World frame, metres. Its edge belongs to it. Each zone of
/// a task is judged by itself.
struct Zone
{
    std::string name;
    ZoneRule rule = ZoneRule::StayInside;
    std::vector<Eigen::Vector2d> corners;
};

/// Whether a position can be on a floor: finite, and within a kilometre of the world's axes.
bool isOnFloor(const Eigen::Vector2d &point);

/// "stay_inside", "stay_outside"; NotFound, with the words there are, for another.
Result<ZoneRule> parseZoneRule(std::string_view word);
std::string_view zoneRuleWord(ZoneRule rule);

/// A rectangle along the axes, by two opposite corners.
Zone rectangularZone(const std::string &name, ZoneRule rule, const Eigen::Vector2d &one,
                     const Eigen::Vector2d &opposite);

/// Whether a zone can be judged, InvalidInput where not: less than 3 corners or more than 100, corners that
/// are not on a floor of 1 km or less than a millimetre from the next, an outline that crosses or touches
/// itself.
Result<void> checkZone(const Zone &zone);
/// What the last zone adds to those before it: its name; and that there are 30 at most.
Result<void> checkZoneAmong(const std::vector<Zone> &zones);

/// What kind of course a task is; gates and path say where it lies on the floor.
enum class TaskTemplate { Free, StraightLine, Circle, FigureEight, Slalom };

/// What passing a gate means. StartFinish: one gate that is both, so that a run has laps.
enum class GateRole { Start, Finish, StartFinish, Split };

/// A line on the floor that a robot's reference point passes, from the left side of the segment to its right
/// as seen from `from` to `to`. World frame, metres.
struct Gate
{
    std::string name;
    GateRole role = GateRole::Split;
    Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
};

/// The course that is to be followed: straight pieces between points, in the order of driving. World frame,
/// metres. No points: there is none.
struct ReferencePath
{
    std::vector<Eigen::Vector2d> points;
    bool closed = false; ///< the last point is joined to the first
};

/// What no robot in the task can do; a measurement beyond it is a spike.
struct TaskLimits
{
    std::optional<double> maxSpeedMps, maxAccelMps2;
};

/// What a robot is to do in a trial.
struct Task
{
    TaskTemplate kind = TaskTemplate::Free;
    std::vector<Gate> gates; ///< in the order in which they are to be passed
    ReferencePath path;
    TaskLimits limits;
    std::vector<Zone> zones = {};
};

/// "free", "straight_line", "circle", "figure_eight", "slalom"; NotFound, with the words there are, for
/// another.
Result<TaskTemplate> parseTaskTemplate(std::string_view word);
std::string_view taskTemplateWord(TaskTemplate kind);
/// "start", "finish", "start_finish", "split"; NotFound likewise.
Result<GateRole> parseGateRole(std::string_view word);
std::string_view gateRoleWord(GateRole role);

/// Whether a task can be measured, InvalidInput where not: numbers that are none, a gate shorter than a
/// millimetre, names twice, two starts or finishes, a path of a single point, limits that are not above zero,
/// zones that are none (checkZone). The parts' functions are for readers that know the line of each part.
Result<void> checkTask(const Task &task);
Result<void> checkGate(const Gate &gate);
/// What the last gate adds to those before it: its name and its role.
Result<void> checkGateAmong(const std::vector<Gate> &gates);
Result<void> checkReferencePath(const ReferencePath &path);
Result<void> checkTaskLimits(const TaskLimits &limits);

/// What errors of a zone or a gate are about, and the advice where numbers make no sense, also those of
/// others.
Message zoneSubject(std::string name);
Message gateSubject(std::string name);
Message checkTheNumbers();

/// A gate of a width that is passed in a direction, at right angles.
Gate gateAcross(const std::string &name, GateRole role, const Eigen::Vector2d &centre,
                const Eigen::Vector2d &direction, double widthM);

/// Reference paths of the templates, sampled so finely that no chord leaves the curve by more than 0.05 mm;
/// closed but for the slalom. Driven anticlockwise, the eight from its centre towards +x and +y as
/// x = a·sin φ, y = b·sin 2φ. The slalom is a sine along from → to that crosses the line once between two
/// equally spaced poles and swings to the left of the first one.
ReferencePath circlePath(const Eigen::Vector2d &centre, double radiusM);
ReferencePath figureEightPath(const Eigen::Vector2d &centre, double halfWidthM, double halfHeightM);
ReferencePath slalomPath(const Eigen::Vector2d &from, const Eigen::Vector2d &to, int poles, double swingM);

} // namespace odo
