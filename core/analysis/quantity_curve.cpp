// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/quantity_curve.h"

#include "core/analysis/internal/derived_curves.h"
#include "core/analysis/motion_stretches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

using Values = std::vector<std::optional<CurveValue>>;

double alongPath(const ProfilePoint &point, const Eigen::Vector2d &acceleration)
{
    constexpr double standing = 1e-9;
    const double speed = point.velocity.norm();
    return speed > standing ? acceleration.dot(point.velocity) / speed : acceleration.norm();
}

/// All samples from `reach` before to `reach` after are used.
bool areUsed(const Profile &profile, std::size_t i, std::size_t reach)
{
    if (i < reach || i + reach >= profile.samples.size())
        return false;
    for (std::size_t k = i - reach; k <= i + reach; ++k)
        if (!isUsed(profile.samples[k]))
            return false;
    return true;
}

std::optional<Eigen::Vector2d> measuredVelocity(const Profile &profile, std::size_t i)
{
    if (i == 0 || i + 1 >= profile.samples.size())
        return std::nullopt;
    const Sample &before = profile.samples[i - 1], &after = profile.samples[i + 1];
    if (!before.position || !after.position || after.time <= before.time)
        return std::nullopt;
    return (*after.position - *before.position) / toSeconds(after.time - before.time);
}

std::optional<CurveValue> measuredAcceleration(const Profile &profile, std::size_t i)
{
    if (!areUsed(profile, i, 2) || !profile.points[i].valid)
        return std::nullopt;
    const auto at = [&](std::size_t k) { return *profile.samples[k].position; };
    const double step = toSeconds(profile.samples[i + 2].time - profile.samples[i - 2].time) / 4;
    if (step <= 0)
        return std::nullopt;
    const Eigen::Vector2d change = 2 * at(i + 2) - at(i + 1) - 2 * at(i) - at(i - 1) + 2 * at(i - 2);
    return CurveValue{alongPath(profile.points[i], change / (7 * step * step)), 0};
}

/// Of all angles that are the same direction the one next to another.
double nextTo(double other, double angle)
{
    return other + std::remainder(angle - other, 2 * std::numbers::pi);
}

/// Next to the smoothed heading; of a robot that reverses the direction that it comes from.
std::optional<CurveValue> measuredHeading(const Profile &profile, std::size_t i,
                                          const std::optional<Heading> &smoothed)
{
    if (smoothed && smoothed->isOfBody) {
        const auto &measured = profile.samples[i].heading;
        if (!measured || !isUsed(profile.samples[i]))
            return std::nullopt;
        return CurveValue{nextTo(smoothed->radians, measured->radians), 0};
    }
    if (!smoothed || !smoothed->sigmaRad || !areUsed(profile, i, 1))
        return std::nullopt;
    const auto velocity = measuredVelocity(profile, i);
    if (!velocity || velocity->isZero())
        return std::nullopt;
    const double along = std::atan2(velocity->y(), velocity->x());
    const double angle = nextTo(smoothed->radians, along),
                 back = nextTo(smoothed->radians, along + std::numbers::pi);
    const bool isReversing = std::abs(back - smoothed->radians) < std::abs(angle - smoothed->radians);
    return CurveValue{isReversing ? back : angle, 0};
}

} // namespace

std::span<const Quantity> allQuantities()
{
    static constexpr std::array all{
        Quantity::Speed,     Quantity::Acceleration, Quantity::Heading,
        Quantity::TurnRate,  Quantity::PositionX,    Quantity::PositionY,
        Quantity::VelocityX, Quantity::VelocityY,    Quantity::LateralAcceleration,
        Quantity::Jerk,      Quantity::Distance,     Quantity::Displacement,
        Quantity::Separation};
    return all;
}

Values quantityValues(const Profile &profile, Quantity quantity, OtherProfiles others)
{
    if (quantity == Quantity::Jerk)
        return jerkValues(profile);
    if (quantity == Quantity::Distance)
        return distanceValues(profile);
    if (quantity == Quantity::Displacement)
        return displacementValues(profile);
    if (quantity == Quantity::Separation)
        return separationValues(profile, others);
    Values values(profile.points.size());
    const auto headings =
        quantity == Quantity::Heading ? headingsOf(profile) : std::vector<std::optional<Heading>>();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const ProfilePoint &point = profile.points[i];
        if (!point.valid)
            continue;
        switch (quantity) {
        case Quantity::Speed:
            values[i] = {point.speedMps, point.sigmaSpeedMps};
            break;
        case Quantity::Acceleration:
            values[i] = {alongPath(point, point.acceleration), point.sigmaAccelMps2};
            break;
        case Quantity::Heading:
            if (headings[i])
                values[i] = {headings[i]->radians, headings[i]->sigmaRad.value_or(0)};
            break;
        case Quantity::TurnRate:
            values[i] = turnRateOf(point);
            break;
        case Quantity::PositionX:
            values[i] = {point.position.x(), point.sigmaXM};
            break;
        case Quantity::PositionY:
            values[i] = {point.position.y(), point.sigmaYM};
            break;
        case Quantity::VelocityX:
            values[i] = {point.velocity.x(), point.sigmaSpeedMps};
            break;
        case Quantity::VelocityY:
            values[i] = {point.velocity.y(), point.sigmaSpeedMps};
            break;
        case Quantity::LateralAcceleration:
            values[i] = lateralAccelerationOf(point);
            break;
        case Quantity::Jerk:
        case Quantity::Distance:
        case Quantity::Displacement:
        case Quantity::Separation:
            break; // of more than one point
        }
    }
    return values;
}

Values measuredValues(const Profile &profile, Quantity quantity)
{
    Values values(profile.samples.size());
    const auto headings =
        quantity == Quantity::Heading ? headingsOf(profile) : std::vector<std::optional<Heading>>();
    const auto first = std::ranges::find_if(profile.samples, isUsed);
    const Eigen::Vector2d start =
        first == profile.samples.end() ? Eigen::Vector2d(Eigen::Vector2d::Zero()) : *first->position;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Sample &sample = profile.samples[i];
        const int axis = quantity == Quantity::PositionX ? 0 : 1;
        switch (quantity) {
        case Quantity::Speed:
            if (const auto speed = areUsed(profile, i, 1) ? measuredSpeed(profile, i) : std::nullopt)
                values[i] = {*speed, 0};
            break;
        case Quantity::Acceleration:
            values[i] = measuredAcceleration(profile, i);
            break;
        case Quantity::Heading:
            values[i] = measuredHeading(profile, i, headings[i]);
            break;
        case Quantity::VelocityX:
        case Quantity::VelocityY:
            if (const auto velocity = areUsed(profile, i, 1) ? measuredVelocity(profile, i) : std::nullopt)
                values[i] = {quantity == Quantity::VelocityX ? velocity->x() : velocity->y(), 0};
            break;
        case Quantity::Displacement:
            if (isUsed(sample))
                values[i] = {(*sample.position - start).norm(), 0};
            break;
        case Quantity::TurnRate:
        case Quantity::LateralAcceleration:
        case Quantity::Jerk:
        case Quantity::Distance:
        case Quantity::Separation:
            break;
        case Quantity::PositionX:
        case Quantity::PositionY:
            if (isUsed(sample))
                values[i] = {(*sample.position)[axis],
                             std::sqrt(std::max(0.0, sample.covariance(axis, axis)))};
            break;
        }
    }
    return values;
}

std::optional<double> measuredSpeed(const Profile &profile, std::size_t sample)
{
    const auto velocity = measuredVelocity(profile, sample);
    return velocity ? std::optional(velocity->norm()) : std::nullopt;
}

namespace {

bool isLeftOf(const BandPoint &point, double x)
{
    return point.x < x;
}

bool isBeyond(double x, const BandPoint &point)
{
    return x < point.x;
}

/// A column that covers both, which are of the same index.
void unite(CurveColumn &column, const CurveColumn &other)
{
    column.low = std::min(column.low, other.low);
    column.high = std::max(column.high, other.high);
    column.bandLow = std::min(column.bandLow, other.bandLow);
    column.bandHigh = std::max(column.bandHigh, other.bandHigh);
}

} // namespace

BandPoint::BandPoint(double position, const CurveValue &curveValue)
    : x(position), value(float(curveValue.value)), reach(float(coverage95 * curveValue.sigma))
{
}

CurveValue BandPoint::curveValue() const
{
    return {double(value), double(reach) / coverage95};
}

std::vector<ProfilePiece> piecesOf(const Profile &profile)
{
    const std::vector<RunInstant> instants = validInstants(profile.samples, profile.points);
    std::vector<ProfilePiece> pieces;
    std::size_t first = 0; // of the piece that is not closed
    const auto add = [&](std::size_t last, bool isBridged) {
        const auto sampleOf = [&](std::size_t i) {
            return static_cast<std::size_t>(instants[i].point - profile.points.data());
        };
        pieces.push_back({sampleOf(first), sampleOf(last), isBridged});
        first = last;
    };
    const std::vector<BridgedStretch> stretches = bridgedStretches(instants);
    auto bridged = stretches.begin();
    for (std::size_t i = 1; i < instants.size(); ++i) {
        if (!instants[i].joined) {
            add(i - 1, false);
            first = i;
        } else if (bridged != stretches.end() && i == bridged->last) {
            if (bridged->first > first)
                add(bridged->first, false);
            add(i, true);
            ++bridged;
        }
    }
    if (!instants.empty())
        add(instants.size() - 1, false);
    return pieces;
}

namespace {

void addRuns(const Values &values, const std::vector<double> &positions, const ProfilePiece &piece,
             std::vector<CurveRun> &runs)
{
    bool isNew = true;
    for (std::size_t i = piece.first; i <= piece.last; ++i) {
        if (!values[i]) {
            isNew = true;
            continue;
        }
        if (isNew)
            runs.push_back({i, {}});
        isNew = false;
        runs.back().points.emplace_back(positions[i], *values[i]);
    }
}

} // namespace

std::vector<CurveRun> curveRuns(const std::vector<std::optional<CurveValue>> &values,
                                const std::vector<double> &positions, const std::vector<ProfilePiece> &pieces,
                                bool bridged)
{
    std::vector<CurveRun> runs;
    for (const ProfilePiece &piece : pieces)
        if (piece.isBridged == bridged)
            addRuns(values, positions, piece, runs);
    return runs;
}

std::span<const BandPoint> visiblePoints(std::span<const BandPoint> points, double low, double high)
{
    if (points.empty() || points.back().x < low || points.front().x > high)
        return {};
    const auto inside = std::lower_bound(points.begin(), points.end(), low, isLeftOf);
    const auto beyond = std::upper_bound(inside, points.end(), high, isBeyond);
    return {inside == points.begin() ? inside : inside - 1, beyond == points.end() ? beyond : beyond + 1};
}

std::size_t visibleCount(std::span<const CurveRun> runs, double low, double high)
{
    std::size_t count = 0;
    for (const CurveRun &run : runs)
        count += visiblePoints(run.points, low, high).size();
    return count;
}

std::vector<CurveColumn> curveColumns(std::span<const CurveRun> runs, double low, double high, int count,
                                      ColumnReach reach)
{
    std::vector<CurveColumn> columns;
    if (count <= 0 || !(high > low))
        return columns;
    columns.reserve(static_cast<std::size_t>(count));
    const double step = (high - low) / count;
    for (const CurveRun &run : runs) {
        const std::span<const BandPoint> visible = visiblePoints(run.points, low, high);
        auto point = visible.begin();
        const auto end = std::upper_bound(visible.begin(), visible.end(), high, isBeyond);
        while (point != end && point->x < low)
            ++point;
        bool isJoined = false;
        while (point != end) {
            const int index = std::min(count - 1, static_cast<int>((point->x - low) / step));
            // The last column takes what rounding leaves over.
            const double edge = index + 1 < count ? low + (index + 1) * step : high + step;
            CurveColumn column{index, isJoined, point->value, point->value, point->low(), point->high()};
            if (reach == ColumnReach::Line && point != visible.begin())
                column.low = column.high = double((point - 1)->value);
            do {
                const double value = double(point->value), from = point->low(), to = point->high();
                column.low = value < column.low ? value : column.low;
                column.high = value > column.high ? value : column.high;
                column.bandLow = from < column.bandLow ? from : column.bandLow;
                column.bandHigh = to > column.bandHigh ? to : column.bandHigh;
                ++point;
            } while (point != end && point->x < edge);
            if (!columns.empty() && columns.back().index >= index)
                unite(columns.back(), column);
            else
                columns.push_back(column);
            isJoined = reach == ColumnReach::Line;
        }
    }
    return columns;
}

} // namespace odo
