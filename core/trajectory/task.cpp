// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/task.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace odo {

namespace {

template <class Value, std::size_t Count>
using Words = std::array<std::pair<Value, std::string_view>, Count>;

constexpr Words<TaskTemplate, 5> templateWords{{{TaskTemplate::Free, "free"},
                                                {TaskTemplate::StraightLine, "straight_line"},
                                                {TaskTemplate::Circle, "circle"},
                                                {TaskTemplate::FigureEight, "figure_eight"},
                                                {TaskTemplate::Slalom, "slalom"}}};
constexpr Words<GateRole, 4> roleWords{{{GateRole::Start, "start"},
                                        {GateRole::Finish, "finish"},
                                        {GateRole::StartFinish, "start_finish"},
                                        {GateRole::Split, "split"}}};

constexpr double shortestGateM = 0.001;
constexpr double largestChordErrorM = 5e-5;

template <class Value, std::size_t Count>
Result<Value> parse(const Words<Value, Count> &words, std::string_view word, const char *kind)
{
    std::string known;
    for (const auto &[value, its] : words) {
        if (its == word)
            return value;
        known += (known.empty() ? "" : its == words.back().second ? " or " : ", ") + std::string(its);
    }
    return fail(ErrorCode::NotFound, std::string(kind) + " '" + std::string(word.substr(0, 40)) + "'",
                "there is no such " + std::string(kind), "use " + known);
}

template <class Value, std::size_t Count>
std::string_view wordOf(const Words<Value, Count> &words, Value value)
{
    return std::find_if(words.begin(), words.end(), [value](const auto &one) { return one.first == value; })
        ->second;
}

/// A curve of one parameter from 0 to 1, with chords short enough for its sharpest bend.
ReferencePath sampled(const std::function<Eigen::Vector2d(double)> &curve, double lengthM, double sharpestRadiusM,
                      bool closed)
{
    // A chord c on a circle of radius r leaves it by c²/8r. Even steps of the parameter are uneven on the curve.
    const double chordM = std::sqrt(8 * sharpestRadiusM * largestChordErrorM) / 2;
    // Other than std::clamp, these give a number for none, as of lengths beyond those that can be computed with.
    const auto pieces = static_cast<std::size_t>(std::fmin(std::fmax(std::ceil(lengthM / chordM), 16.0), 4096.0));
    ReferencePath path;
    path.closed = closed;
    for (std::size_t i = 0; i < pieces + (closed ? 0 : 1); ++i)
        path.points.push_back(curve(static_cast<double>(i) / static_cast<double>(pieces)));
    return path;
}

} // namespace

Result<TaskTemplate> parseTaskTemplate(std::string_view word)
{
    return parse(templateWords, word, "template");
}

std::string_view taskTemplateWord(TaskTemplate kind)
{
    return wordOf(templateWords, kind);
}

Result<GateRole> parseGateRole(std::string_view word)
{
    return parse(roleWords, word, "role");
}

std::string_view gateRoleWord(GateRole role)
{
    return wordOf(roleWords, role);
}

Result<void> checkGate(const Gate &gate)
{
    const std::string what = "gate '" + gate.name + "'";
    if (!isOnFloor(gate.from) || !isOnFloor(gate.to))
        return fail(ErrorCode::InvalidInput, what, "its ends are not on a floor of 1 km", "check the numbers");
    if ((gate.to - gate.from).norm() < shortestGateM)
        return fail(ErrorCode::InvalidInput, what, "its ends are less than 1 mm apart",
                    "give the two ends of the line that is to be passed");
    return {};
}

Result<void> checkGateAmong(const std::vector<Gate> &gates)
{
    const Gate &last = gates.back();
    const std::string what = "gate '" + last.name + "'";
    const auto starts = [](GateRole role) { return role == GateRole::Start || role == GateRole::StartFinish; };
    const auto ends = [](GateRole role) { return role == GateRole::Finish || role == GateRole::StartFinish; };
    for (std::size_t i = 0; i + 1 < gates.size(); ++i) {
        if (gates[i].name == last.name)
            return fail(ErrorCode::InvalidInput, what, "the name is there twice",
                        "give each gate a name of its own");
        if ((starts(gates[i].role) && starts(last.role)) || (ends(gates[i].role) && ends(last.role)))
            return fail(ErrorCode::InvalidInput, what,
                        "gate '" + gates[i].name + "' is the " +
                            (starts(gates[i].role) && starts(last.role) ? "start" : "finish") + " already",
                        "keep one start and one finish, or one gate with the role start_finish");
    }
    return {};
}

Result<void> checkReferencePath(const ReferencePath &path)
{
    const auto refuse = [](const std::string &why, const std::string &advice) {
        return fail(ErrorCode::InvalidInput, "reference path", why, advice);
    };
    constexpr std::size_t mostPoints = 5000;
    if (path.points.empty())
        return {};
    if (path.points.size() < 2 || (path.closed && path.points.size() < 3))
        return refuse("it has too few points", "give two points or more, three where the path is closed");
    if (path.points.size() > mostPoints)
        return refuse("it has more than " + std::to_string(mostPoints) + " points", "sample it more coarsely");
    if (!std::all_of(path.points.begin(), path.points.end(), isOnFloor))
        return refuse("its points are not on a floor of 1 km", "check the numbers");
    double lengthM = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i)
        lengthM += (path.points[i] - path.points[i - 1]).norm();
    if (lengthM < shortestGateM)
        return refuse("it is shorter than 1 mm", "check the numbers");
    return {};
}

Result<void> checkTaskLimits(const TaskLimits &limits)
{
    for (const std::optional<double> &limit : {limits.maxSpeedMps, limits.maxAccelMps2}) {
        if (limit && !(*limit > 0 && std::isfinite(*limit)))
            return fail(ErrorCode::InvalidInput, "limits of a task", "a limit is not above zero",
                        "give the largest speed and acceleration that a robot can have in the task");
    }
    return {};
}

Result<void> checkTask(const Task &task)
{
    std::vector<Gate> before;
    for (const Gate &gate : task.gates) {
        if (auto valid = checkGate(gate); !valid)
            return valid;
        before.push_back(gate);
        if (auto valid = checkGateAmong(before); !valid)
            return valid;
    }
    std::vector<Zone> zones;
    for (const Zone &zone : task.zones) {
        if (auto valid = checkZone(zone); !valid)
            return valid;
        zones.push_back(zone);
        if (auto valid = checkZoneAmong(zones); !valid)
            return valid;
    }
    if (auto valid = checkReferencePath(task.path); !valid)
        return valid;
    return checkTaskLimits(task.limits);
}

Gate gateAcross(const std::string &name, GateRole role, const Eigen::Vector2d &centre,
                const Eigen::Vector2d &direction, double widthM)
{
    const Eigen::Vector2d half = Eigen::Vector2d(-direction.y(), direction.x()).normalized() * widthM / 2;
    return {name, role, centre - half, centre + half};
}

ReferencePath circlePath(const Eigen::Vector2d &centre, double radiusM)
{
    return sampled(
        [&](double part) -> Eigen::Vector2d {
            const double angle = 2 * std::numbers::pi * part;
            return centre + radiusM * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        },
        2 * std::numbers::pi * radiusM, radiusM, true);
}

ReferencePath figureEightPath(const Eigen::Vector2d &centre, double halfWidthM, double halfHeightM)
{
    // x = a·sin φ, y = b·sin 2φ bends with a radius of 4b²/a at its ends and of a²/8b on top of its loops.
    const double sharpestM =
        std::min(4 * halfHeightM * halfHeightM / halfWidthM, halfWidthM * halfWidthM / (8 * halfHeightM));
    return sampled(
        [&](double part) -> Eigen::Vector2d {
            const double angle = 2 * std::numbers::pi * part;
            return centre + Eigen::Vector2d(halfWidthM * std::sin(angle), halfHeightM * std::sin(2 * angle));
        },
        4 * halfWidthM + 8 * halfHeightM, sharpestM, true);
}

ReferencePath slalomPath(const Eigen::Vector2d &from, const Eigen::Vector2d &to, int poles, double swingM)
{
    const Eigen::Vector2d along = to - from;
    const Eigen::Vector2d left = Eigen::Vector2d(-along.y(), along.x()).normalized();
    const double waves = std::numbers::pi * poles;
    // y = s·sin(waves·x/l) bends most at the poles, with s·(waves/l)².
    const double sharpestM = std::pow(along.norm() / waves, 2) / swingM;
    return sampled(
        [&](double part) -> Eigen::Vector2d { return from + part * along + swingM * std::sin(waves * part) * left; },
        along.norm() + 2 * poles * swingM, sharpestM, false);
}

} // namespace odo
