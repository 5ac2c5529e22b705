// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/task.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr std::string_view insideWord = "stay_inside", outsideWord = "stay_outside";
constexpr std::size_t fewestCorners = 3, mostCorners = 100, mostZones = 30;
constexpr double shortestEdgeM = 0.001;

Message nameIsThereTwice()
{
    return ODO_TEXT("analysis.name_twice", "the name is used twice");
}

/// As much of a word that was typed as an error shows.
std::string beginningOf(std::string_view word)
{
    return std::string(word.substr(0, 40));
}

/// Positive: c lies to the left of a → b.
double turn(const Vector2d &a, const Vector2d &b, const Vector2d &c)
{
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Of a point on the line through a and b.
bool isBetween(const Vector2d &a, const Vector2d &b, const Vector2d &point)
{
    return (point - a).dot(point - b) <= 0;
}

bool touch(const Vector2d &a, const Vector2d &b, const Vector2d &c, const Vector2d &d)
{
    const double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0)
        return true;
    return (abc == 0 && isBetween(a, b, c)) || (abd == 0 && isBetween(a, b, d)) ||
           (cda == 0 && isBetween(c, d, a)) || (cdb == 0 && isBetween(c, d, b));
}

/// Whether two edges meet elsewhere than in the corner that neighbours share.
bool meetsItself(const std::vector<Vector2d> &corners)
{
    const std::size_t count = corners.size();
    const auto corner = [&](std::size_t i) -> const Vector2d & { return corners[i % count]; };
    for (std::size_t i = 0; i < count; ++i) {
        // A neighbour that turns straight back lies upon its edge.
        if (turn(corner(i), corner(i + 1), corner(i + 2)) == 0 &&
            (corner(i) - corner(i + 1)).dot(corner(i + 2) - corner(i + 1)) > 0)
            return true;
        for (std::size_t j = i + 2; j < count; ++j) {
            if ((j + 1) % count != i && touch(corner(i), corner(i + 1), corner(j), corner(j + 1)))
                return true;
        }
    }
    return false;
}

} // namespace

Message zoneSubject(std::string name)
{
    return ODO_TEXT("analysis.zone", "zone '%1'")(std::move(name));
}

Message gateSubject(std::string name)
{
    return ODO_TEXT("analysis.gate", "gate '%1'")(std::move(name));
}

Message checkTheNumbers()
{
    return ODO_TEXT("analysis.check_numbers", "check the numbers");
}

bool isOnFloor(const Vector2d &point)
{
    constexpr double furthestM = 1000; // a floor, not a country
    return point.allFinite() && point.cwiseAbs().maxCoeff() <= furthestM;
}

Result<ZoneRule> parseZoneRule(std::string_view word)
{
    if (word == insideWord)
        return ZoneRule::StayInside;
    if (word == outsideWord)
        return ZoneRule::StayOutside;
    return fail(ErrorCode::NotFound, ODO_TEXT("analysis.rule", "rule '%1'")(beginningOf(word)),
                ODO_TEXT("analysis.no_such_rule", "zones have no such rule"),
                ODO_TEXT("analysis.use_a_rule", "use stay_inside or stay_outside"));
}

std::string_view zoneRuleWord(ZoneRule rule)
{
    return rule == ZoneRule::StayInside ? insideWord : outsideWord;
}

Zone rectangularZone(const std::string &name, ZoneRule rule, const Vector2d &one, const Vector2d &opposite)
{
    const Vector2d low = one.cwiseMin(opposite), high = one.cwiseMax(opposite);
    return {name, rule, {low, {high.x(), low.y()}, high, {low.x(), high.y()}}};
}

Result<void> checkZone(const Zone &zone)
{
    const auto refuse = [&zone](Message why, Message advice) {
        return fail(ErrorCode::InvalidInput, zoneSubject(zone.name), std::move(why), std::move(advice));
    };
    const auto &corners = zone.corners;
    if (corners.size() < fewestCorners)
        return refuse(
            ODO_TEXT("analysis.few_corners", "it has fewer than three corners"),
            ODO_TEXT("analysis.give_corners", "enter the corners of its outline, all the way round"));
    if (corners.size() > mostCorners)
        return refuse(ODO_TEXT("analysis.many_corners", "it has more than %1 corners")(mostCorners),
                      ODO_TEXT("analysis.draw_coarsely", "draw it with fewer corners"));
    if (!std::ranges::all_of(corners, isOnFloor))
        return refuse(ODO_TEXT("analysis.corners_off_floor", "its corners are not all on a floor of 1 km"),
                      checkTheNumbers());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if ((corners[(i + 1) % corners.size()] - corners[i]).norm() < shortestEdgeM)
            return refuse(ODO_TEXT("analysis.corners_too_near", "two corners are less than 1 mm apart"),
                          ODO_TEXT("analysis.corners_once", "enter each corner once"));
    }
    if (meetsItself(corners))
        return refuse(ODO_TEXT("analysis.outline_crosses", "its outline crosses itself"),
                      ODO_TEXT("analysis.corners_in_order", "enter the corners in order, all the way round"));
    return {};
}

Result<void> checkZoneAmong(const std::vector<Zone> &zones)
{
    const Message what = zoneSubject(zones.back().name);
    if (zones.size() > mostZones)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("analysis.many_zones", "the task already has %1 zones")(mostZones),
                    ODO_TEXT("analysis.join_zones", "merge neighbouring zones"));
    if (std::ranges::count(zones, zones.back().name, &Zone::name) > 1)
        return fail(ErrorCode::InvalidInput, what, nameIsThereTwice(),
                    ODO_TEXT("analysis.name_each_zone", "give each zone a name of its own"));
    return {};
}

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
Result<Value> parse(const Words<Value, Count> &words, std::string_view word, Message what, Message why)
{
    std::vector<std::string> known;
    for (const auto &[value, its] : words) {
        if (its == word)
            return value;
        known.emplace_back(its);
    }
    return fail(ErrorCode::NotFound, std::move(what), std::move(why),
                ODO_TEXT("analysis.use_one_of",
                         "use %1")(listed(known, MessageArgument::Kind::Label, MessageArgument::Joint::Or)));
}

template <class Value, std::size_t Count>
std::string_view wordOf(const Words<Value, Count> &words, Value value)
{
    return std::find_if(words.begin(), words.end(), [value](const auto &one) { return one.first == value; })
        ->second;
}

/// A curve of one parameter from 0 to 1, with chords short enough for its sharpest bend.
ReferencePath sampled(const std::function<Eigen::Vector2d(double)> &curve, double lengthM,
                      double sharpestRadiusM, bool closed)
{
    // A chord c on a circle of radius r leaves it by c²/8r. Even steps of the parameter are uneven on the
    // curve.
    const double chordM = std::sqrt(8 * sharpestRadiusM * largestChordErrorM) / 2;
    // Other than std::clamp, these give a number for none, as of lengths beyond those that can be computed
    // with.
    const auto pieces =
        static_cast<std::size_t>(std::fmin(std::fmax(std::ceil(lengthM / chordM), 16.0), 4096.0));
    ReferencePath path;
    path.closed = closed;
    for (std::size_t i = 0; i < pieces + (closed ? 0 : 1); ++i)
        path.points.push_back(curve(static_cast<double>(i) / static_cast<double>(pieces)));
    return path;
}

} // namespace

Result<TaskTemplate> parseTaskTemplate(std::string_view word)
{
    return parse(templateWords, word, ODO_TEXT("analysis.template", "template '%1'")(beginningOf(word)),
                 ODO_TEXT("analysis.no_such_template", "no template has this name"));
}

std::string_view taskTemplateWord(TaskTemplate kind)
{
    return wordOf(templateWords, kind);
}

Result<GateRole> parseGateRole(std::string_view word)
{
    return parse(roleWords, word, ODO_TEXT("analysis.role", "role '%1'")(beginningOf(word)),
                 ODO_TEXT("analysis.no_such_role", "gates have no such role"));
}

std::string_view gateRoleWord(GateRole role)
{
    return wordOf(roleWords, role);
}

Result<void> checkGate(const Gate &gate)
{
    const Message what = gateSubject(gate.name);
    if (!isOnFloor(gate.from) || !isOnFloor(gate.to))
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("analysis.ends_off_floor", "its ends are not both on a floor of 1 km"),
                    checkTheNumbers());
    if ((gate.to - gate.from).norm() < shortestGateM)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("analysis.ends_too_near", "its ends are less than 1 mm apart"),
                    ODO_TEXT("analysis.give_ends", "enter the two ends of the line that the robot passes"));
    return {};
}

Result<void> checkGateAmong(const std::vector<Gate> &gates)
{
    const Gate &last = gates.back();
    const Message what = gateSubject(last.name);
    const auto starts = [](GateRole role) {
        return role == GateRole::Start || role == GateRole::StartFinish;
    };
    const auto ends = [](GateRole role) { return role == GateRole::Finish || role == GateRole::StartFinish; };
    for (std::size_t i = 0; i + 1 < gates.size(); ++i) {
        if (gates[i].name == last.name)
            return fail(ErrorCode::InvalidInput, what, nameIsThereTwice(),
                        ODO_TEXT("analysis.name_each_gate", "give each gate a name of its own"));
        if ((starts(gates[i].role) && starts(last.role)) || (ends(gates[i].role) && ends(last.role)))
            return fail(
                ErrorCode::InvalidInput, what,
                starts(gates[i].role) && starts(last.role)
                    ? ODO_TEXT("analysis.start_is_there", "gate '%1' is already the start")(gates[i].name)
                    : ODO_TEXT("analysis.finish_is_there", "gate '%1' is already the finish")(gates[i].name),
                ODO_TEXT("analysis.one_start_and_finish",
                         "keep one start and one finish, or one gate with the role start_finish"));
    }
    return {};
}

Result<void> checkReferencePath(const ReferencePath &path)
{
    const auto refuse = [](Message why, Message advice) {
        return fail(ErrorCode::InvalidInput, ODO_TEXT("analysis.reference_path", "reference path"),
                    std::move(why), std::move(advice));
    };
    constexpr std::size_t mostPoints = 5000;
    if (path.points.empty())
        return {};
    if (path.points.size() < 2 || (path.closed && path.points.size() < 3))
        return refuse(
            ODO_TEXT("analysis.few_points", "it has too few points"),
            ODO_TEXT("analysis.give_two_points", "enter at least two points, or three for a closed path"));
    if (path.points.size() > mostPoints)
        return refuse(ODO_TEXT("analysis.many_points", "it has more than %1 points")(mostPoints),
                      ODO_TEXT("analysis.sample_coarsely", "sample it with fewer points"));
    if (!std::all_of(path.points.begin(), path.points.end(), isOnFloor))
        return refuse(ODO_TEXT("analysis.points_off_floor", "its points are not all on a floor of 1 km"),
                      checkTheNumbers());
    double lengthM = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i)
        lengthM += (path.points[i] - path.points[i - 1]).norm();
    if (lengthM < shortestGateM)
        return refuse(ODO_TEXT("analysis.path_too_short", "it is shorter than 1 mm"), checkTheNumbers());
    return {};
}

Result<void> checkTaskLimits(const TaskLimits &limits)
{
    for (const std::optional<double> &limit : {limits.maxSpeedMps, limits.maxAccelMps2}) {
        if (limit && !(*limit > 0 && std::isfinite(*limit)))
            return fail(
                ErrorCode::InvalidInput, ODO_TEXT("analysis.limits", "limits of a task"),
                ODO_TEXT("analysis.limit_not_positive", "a limit is zero or negative"),
                ODO_TEXT("analysis.give_limits",
                         "enter the largest speed and acceleration that a robot can reach in the task"));
    }
    return {};
}

Result<void> checkTask(const Task &task)
{
    std::vector<Gate> before;
    for (const Gate &gate : task.gates) {
        ODO_TRY(checkGate(gate));
        before.push_back(gate);
        ODO_TRY(checkGateAmong(before));
    }
    std::vector<Zone> zones;
    for (const Zone &zone : task.zones) {
        ODO_TRY(checkZone(zone));
        zones.push_back(zone);
        ODO_TRY(checkZoneAmong(zones));
    }
    ODO_TRY(checkReferencePath(task.path));
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
        [&](double part) -> Eigen::Vector2d {
            return from + part * along + swingM * std::sin(waves * part) * left;
        },
        along.norm() + 2 * poles * swingM, sharpestM, false);
}

} // namespace odo
