// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/zone.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr std::string_view insideWord = "stay_inside", outsideWord = "stay_outside";
constexpr std::size_t fewestCorners = 3, mostCorners = 100, mostZones = 30;
constexpr double shortestEdgeM = 0.001;

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
    return (abc == 0 && isBetween(a, b, c)) || (abd == 0 && isBetween(a, b, d)) || (cda == 0 && isBetween(c, d, a)) ||
           (cdb == 0 && isBetween(c, d, b));
}

/// Whether two edges meet elsewhere than in the corner that neighbours share.
bool meetsItself(const std::vector<Vector2d> &corners)
{
    const std::size_t count = corners.size();
    const auto corner = [&](std::size_t i) -> const Vector2d & { return corners[i % count]; };
    for (std::size_t i = 0; i < count; ++i) {
        // A neighbour that turns straight back lies upon its edge.
        if (turn(corner(i), corner(i + 1), corner(i + 2)) == 0 && (corner(i) - corner(i + 1)).dot(corner(i + 2) - corner(i + 1)) > 0)
            return true;
        for (std::size_t j = i + 2; j < count; ++j) {
            if ((j + 1) % count != i && touch(corner(i), corner(i + 1), corner(j), corner(j + 1)))
                return true;
        }
    }
    return false;
}

} // namespace

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
    return fail(ErrorCode::NotFound, "rule '" + std::string(word.substr(0, 40)) + "'", "there is no such rule of a zone",
                "use stay_inside or stay_outside");
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
    const auto refuse = [&zone](const std::string &why, const std::string &advice) {
        return fail(ErrorCode::InvalidInput, "zone '" + zone.name + "'", why, advice);
    };
    const auto &corners = zone.corners;
    if (corners.size() < fewestCorners)
        return refuse("it has less than three corners", "give the corners of its outline, all the way round");
    if (corners.size() > mostCorners)
        return refuse("it has more than " + std::to_string(mostCorners) + " corners",
                      "draw it more coarsely");
    if (!std::ranges::all_of(corners, isOnFloor))
        return refuse("its corners are not on a floor of 1 km", "check the numbers");
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if ((corners[(i + 1) % corners.size()] - corners[i]).norm() < shortestEdgeM)
            return refuse("two corners are less than 1 mm apart", "give each corner once");
    }
    if (meetsItself(corners))
        return refuse("its outline crosses itself", "give the corners in order, all the way round");
    return {};
}

Result<void> checkZoneAmong(const std::vector<Zone> &zones)
{
    const std::string what = "zone '" + zones.back().name + "'";
    if (zones.size() > mostZones)
        return fail(ErrorCode::InvalidInput, what, "the task has " + std::to_string(mostZones) + " zones already",
                    "join zones that lie beside one another");
    if (std::ranges::count(zones, zones.back().name, &Zone::name) > 1)
        return fail(ErrorCode::InvalidInput, what, "the name is there twice", "give each zone a name of its own");
    return {};
}

} // namespace odo
