// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/range_statistics.h"

#include "core/analysis/metrics.h"
#include "core/analysis/motion_stretches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace odo {

namespace {

bool isPosition(Quantity quantity)
{
    return quantity == Quantity::PositionX || quantity == Quantity::PositionY;
}
bool isAngle(Quantity quantity)
{
    return quantity == Quantity::Heading || quantity == Quantity::TurnRate;
}

/// The calibration's variance of a position's axis: the mean over the used samples of a span, m².
double positionVariance(const Profile &profile, Quantity quantity, const TimeSpan &span)
{
    const int axis = quantity == Quantity::PositionX ? 0 : 1;
    double sum = 0, count = 0;
    for (const Sample &sample : profile.samples)
        if (span.contains(sample.time) && sample.position && !isRejected(sample.flags)) {
            sum += sample.commonCovariance(axis, axis);
            count += 1;
        }
    return count > 0 ? sum / count : 0;
}

/// Share of the time that each point stands for.
std::vector<double> sharesOf(const std::vector<CurvePoint> &points)
{
    std::vector<double> shares(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double before = i > 0 ? points[i].timeS - points[i - 1].timeS : 0;
        const double after = i + 1 < points.size() ? points[i + 1].timeS - points[i].timeS : 0;
        shares[i] = (before + after) / 2;
    }
    const double whole = std::accumulate(shares.begin(), shares.end(), 0.0);
    for (double &share : shares)
        share = whole > 0 ? share / whole : 1.0 / static_cast<double>(shares.size());
    return shares;
}

/// σ of Σ wᵢ eᵢ.
double sigmaOfSum(const std::vector<CurvePoint> &points, ErrorCourse course,
                  const std::vector<double> &weights)
{
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), 1);
    for (std::size_t i = 0; i < points.size(); ++i)
        rows(static_cast<Eigen::Index>(i), 0) = weights[i];
    return std::sqrt(std::max(0.0, errorCovariance(points, course, rows)(0, 0)));
}

/// The direction in which an error of the position changes the quantity.
Eigen::Vector2d errorDirection(const ProfilePoint &point, Quantity quantity)
{
    if (isPosition(quantity))
        return quantity == Quantity::PositionX ? Eigen::Vector2d::UnitX() : Eigen::Vector2d::UnitY();
    if (quantity == Quantity::VelocityX || quantity == Quantity::VelocityY)
        return quantity == Quantity::VelocityX ? Eigen::Vector2d::UnitX() : Eigen::Vector2d::UnitY();
    const double speed = point.velocity.norm();
    const Eigen::Vector2d along =
        speed > 0 ? Eigen::Vector2d(point.velocity / speed) : Eigen::Vector2d::UnitX();
    const bool isAcross = isAngle(quantity) || quantity == Quantity::LateralAcceleration;
    return isAcross ? Eigen::Vector2d(-along.y(), along.x()) : along;
}

double medianOf(const std::vector<CurvePoint> &points, const std::vector<double> &shares)
{
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return points[a].value < points[b].value; });
    // Each value is at the middle of its time; between two the curve is assumed straight.
    double reached = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const double middle = reached + shares[order[i]] / 2;
        if (middle >= 0.5) {
            if (i == 0)
                return points[order[0]].value;
            const double before = reached - shares[order[i - 1]] / 2;
            const double part = middle > before ? (0.5 - before) / (middle - before) : 1;
            return std::lerp(points[order[i - 1]].value, points[order[i]].value, part);
        }
        reached += shares[order[i]];
    }
    return points[order.back()].value;
}

/// The stretches within 1.5 σ of the median decide it, by their mean.
double sigmaOfMedian(const std::vector<CurvePoint> &points, ErrorCourse course,
                     const std::vector<double> &shares, double median)
{
    std::vector<double> weights(points.size(), 0);
    double whole = 0;
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double apart = std::abs(points[i].value - median);
        if (apart < std::abs(points[nearest].value - median))
            nearest = i;
        if (apart <= sigmasNearPercentile * points[i].sigma)
            whole += weights[i] = shares[i];
    }
    if (whole <= 0)
        return points[nearest].sigma;
    for (double &weight : weights)
        weight /= whole;
    return sigmaOfSum(points, course, weights);
}

TimedValue extreme(const std::vector<CurvePoint> &points, double sign)
{
    const auto sure = [sign](const CurvePoint &point) { return sign * point.value - 2 * point.sigma; };
    const CurvePoint &found =
        *std::max_element(points.begin(), points.end(),
                          [&](const CurvePoint &a, const CurvePoint &b) { return sure(a) < sure(b); });
    return {found.timeS, {found.value, found.sigma}};
}

} // namespace

ErrorCourse errorCourseOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Speed:
    case Quantity::VelocityX:
    case Quantity::VelocityY:
    case Quantity::Heading: // the part across the path of the same velocity
        return ErrorCourse::Velocity;
    case Quantity::Acceleration:
    case Quantity::LateralAcceleration:
    case Quantity::TurnRate:
    case Quantity::Jerk: // rougher still: what is averaged of it is the difference of two accelerations
        return ErrorCourse::Acceleration;
    case Quantity::PositionX:
    case Quantity::PositionY:
    case Quantity::Distance:
    case Quantity::Displacement:
    case Quantity::Separation:
        break;
    }
    return ErrorCourse::Position;
}

std::vector<CurvePoint> pointsWithin(const Profile &profile, Quantity quantity, const TimeSpan &span,
                                     OtherProfiles others)
{
    const auto values = quantityValues(profile, quantity, others);
    const std::vector<MeasuredPosition> positions = measuredPositions(profile.samples, profile.points);
    std::vector<CurvePoint> points;
    for (const MeasuredPosition &measured : positions) {
        const auto i = static_cast<std::size_t>(measured.point - profile.points.data());
        if (!values[i] || !span.contains(profile.samples[i].time))
            continue;
        const double position = sigmaAlong(measured.own, errorDirection(*measured.point, quantity));
        CurvePoint point{measured.timeS, values[i]->value, isPosition(quantity) ? position : values[i]->sigma,
                         errorRate(position, measured.point->sigmaSpeedMps), measured.point->sigmaSpeedMps};
        const auto &body = measured.point->body;
        if (isAngle(quantity) && body) { // its errors are those of its own measurement
            point.errorRate = errorRate(body->sigmaRad, body->sigmaTurnRateRadps);
            point.integralSigma = body->sigmaRad;
        } else if (isAngle(quantity))
            point.integralSigma /= std::max(measured.point->sigmaSpeedMps, measured.point->speedMps);
        else if (quantity == Quantity::Jerk) // of the acceleration
            point.integralSigma = measured.point->sigmaAccelMps2;
        points.push_back(point);
    }
    return points;
}

std::vector<CurvePoint> measurementsWithin(const Profile &profile, Quantity quantity, const TimeSpan &span)
{
    std::vector<CurvePoint> points;
    const auto values = measuredValues(profile, quantity);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] && span.contains(profile.samples[i].time))
            points.push_back({toSeconds(profile.samples[i].time), values[i]->value, values[i]->sigma});
    return points;
}

std::optional<RangeStatistics> statisticsOf(const Profile &profile, Quantity quantity, const TimeSpan &span,
                                            OtherProfiles others)
{
    const std::vector<CurvePoint> points = pointsWithin(profile, quantity, span, others);
    if (points.empty())
        return std::nullopt;
    const ErrorCourse course = errorCourseOf(quantity);
    const std::vector<double> shares = sharesOf(points);
    RangeStatistics result;
    result.points = points.size();
    for (std::size_t i = 0; i < points.size(); ++i)
        result.mean.value += shares[i] * points[i].value;
    result.mean.sigma = sigmaOfSum(points, course, shares);
    result.median.value = medianOf(points, shares);
    result.median.sigma = sigmaOfMedian(points, course, shares, result.median.value);
    result.least = extreme(points, -1);
    result.most = extreme(points, 1);
    double variance = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        variance += shares[i] * std::pow(points[i].value - result.mean.value, 2);
    result.spread.value = std::sqrt(variance);
    std::vector<double> slopes(points.size(), 0); // of the spread by each error
    for (std::size_t i = 0; i < points.size() && variance > 0; ++i)
        slopes[i] = shares[i] * (points[i].value - result.mean.value) / result.spread.value;
    result.spread.sigma = sigmaOfSum(points, course, slopes);

    if (isAngle(quantity))
        return result;
    const double scale = sigmaOfScale(profile.samples, profile.points);
    const double measured = isPosition(quantity) ? std::sqrt(positionVariance(profile, quantity, span)) : 0;
    for (CurveValue *each : {&result.mean, &result.median, &result.least.value, &result.most.value})
        each->sigma = std::hypot(each->sigma, isPosition(quantity) ? measured : scale * each->value);
    result.spread.sigma = std::hypot(result.spread.sigma, scale * result.spread.value);
    return result;
}

std::optional<CurveValue> pathWithin(const Profile &profile, const TimeSpan &span)
{
    std::vector<Sample> samples;
    std::vector<ProfilePoint> points;
    for (std::size_t i = 0; i < profile.points.size(); ++i)
        if (span.contains(profile.samples[i].time)) {
            samples.push_back(profile.samples[i]);
            points.push_back(profile.points[i]);
        }
    for (const Metric &metric : measureRun(samples, points))
        if (metric.name == "path_length")
            return CurveValue{metric.value, metric.sigma.value_or(0)};
    return std::nullopt;
}

Result<CurveFit> fitQuantity(const Profile &profile, Quantity quantity, const TimeSpan &span, FitShape shape,
                             OtherProfiles others)
{
    auto fit = isPosition(quantity)
                   ? fitCurve(measurementsWithin(profile, quantity, span), ErrorCourse::Independent, shape)
                   : fitCurve(pointsWithin(profile, quantity, span, others), errorCourseOf(quantity), shape);
    if (!fit || isAngle(quantity))
        return fit;
    if (isPosition(quantity)) {
        // The smoother knows which part of the measurements' errors lasts; a slow error is the same to both
        // fits.
        const auto smoothed = fitCurve(pointsWithin(profile, quantity, span), ErrorCourse::Position, shape);
        const int highest = static_cast<int>(shape);
        if (smoothed && smoothed->sigma(highest) > fit->sigma(highest))
            fit->covariance = smoothed->covariance;
    }
    const double scale = sigmaOfScale(profile.samples, profile.points);
    for (int i = 0; i < 3; ++i) {
        const bool isAtPosition = isPosition(quantity) && i == 0;
        fit->covariance(i, i) += isAtPosition ? positionVariance(profile, quantity, span)
                                              : std::pow(scale * fit->coefficients[i], 2);
    }
    return fit;
}

} // namespace odo
