// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/ellipse_edge.h"

#include "core/calibration/saddle_points.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

namespace {

using Eigen::Vector2d;
using Conic = Eigen::Matrix<double, 6, 1>; // of (x², xy, y², x, y, 1)

constexpr double stepPx = 0.25;
constexpr double leastReachPx = 1.25, mostReachPx = 5;
constexpr double leastStep = 12;  // of brightness, over the edge
constexpr double leastShare = 0.66; // of the rays that must find an edge
constexpr int passes = 3;

Conic rowOf(const Vector2d &p)
{
    Conic row;
    row << p.x() * p.x(), p.x() * p.y(), p.y() * p.y(), p.x(), p.y(), 1;
    return row;
}

double gradientOf(const Conic &conic, const Vector2d &p)
{
    return Vector2d(2 * conic(0) * p.x() + conic(1) * p.y() + conic(3), conic(1) * p.x() + 2 * conic(2) * p.y() + conic(4)).norm();
}

std::optional<EllipseOutline> outlineOf(const Conic &conic)
{
    Eigen::Matrix2d form;
    form << conic(0), 0.5 * conic(1), 0.5 * conic(1), conic(2);
    if (!(form.determinant() > 0))
        return std::nullopt;
    const Vector2d centre = -0.5 * form.inverse() * conic.segment<2>(3);
    const double level = -(conic(5) + 0.5 * conic.segment<2>(3).dot(centre));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(form);
    const Vector2d squares = level * axes.eigenvalues().cwiseInverse();
    if (!(squares.minCoeff() > 0))
        return std::nullopt;
    // The smaller curvature belongs to the longer axis, whichever sign the form has.
    const int longer = squares(0) >= squares(1) ? 0 : 1;
    const Vector2d along = axes.eigenvectors().col(longer);
    return EllipseOutline{centre, {std::sqrt(squares(longer)), std::sqrt(squares(1 - longer))}, std::atan2(along.y(), along.x())};
}

/// Distance of a point from an ellipse, outwards positive, to first order.
double distanceFrom(const EllipseOutline &outline, const Vector2d &point)
{
    const Vector2d p = Eigen::Rotation2Dd(-outline.angleRad) * (point - outline.centre);
    const Vector2d q = p.cwiseQuotient(outline.semiAxes);
    const double gradient = q.cwiseQuotient(outline.semiAxes).norm();
    return gradient > 0 ? 0.5 * (q.squaredNorm() - 1) / gradient : -outline.semiAxes.y();
}

double rmsFrom(const EllipseOutline &outline, const std::vector<Vector2d> &points)
{
    double squares = 0;
    for (const Vector2d &point : points)
        squares += std::pow(distanceFrom(outline, point), 2);
    return std::sqrt(squares / static_cast<double>(points.size()));
}

std::vector<Vector2d> edgePoints(const cv::Mat &luma, const EllipseOutline &about, double reachShare, bool brighterOutside,
                                 std::size_t rays)
{
    std::vector<Vector2d> points;
    const Eigen::Rotation2Dd turn(about.angleRad);
    for (std::size_t i = 0; i < rays; ++i) {
        const double angle = 2 * EIGEN_PI * static_cast<double>(i) / static_cast<double>(rays);
        const Vector2d circle(std::cos(angle), std::sin(angle));
        const Vector2d outwards = turn * Vector2d(circle.cwiseQuotient(about.semiAxes).normalized());
        const Vector2d from = about.pointAt(angle);
        // The distance from the middle along the normal, which is what neighbouring edges keep in proportion.
        const double across = (from - about.centre).dot(outwards);
        const double reach = std::clamp(reachShare * across, leastReachPx, mostReachPx);
        if (from.x() < reach + 1 || from.y() < reach + 1 || from.x() > luma.cols - reach - 2 || from.y() > luma.rows - reach - 2)
            continue;
        if (const auto edge = edgeAhead(luma, from, outwards, reach, brighterOutside))
            points.emplace_back(from + *edge * outwards);
    }
    return points;
}

} // namespace

Vector2d EllipseOutline::pointAt(double parameterRad) const
{
    const Vector2d onAxes(semiAxes.x() * std::cos(parameterRad), semiAxes.y() * std::sin(parameterRad));
    return centre + Eigen::Rotation2Dd(angleRad) * onAxes;
}

std::optional<double> edgeAhead(const cv::Mat &luma, const Vector2d &from, const Vector2d &direction, double reachPx,
                                bool brighterAhead)
{
    constexpr int most = 2 * static_cast<int>(mostReachPx / stepPx) + 1;
    std::array<double, most> slopes{};
    const int half = static_cast<int>(std::min(reachPx, mostReachPx) / stepPx);
    const auto greyAlong = [&](double distance) {
        const Vector2d p = from + distance * direction;
        return static_cast<double>(greyAt(luma, cv::Point2f(static_cast<float>(p.x()), static_cast<float>(p.y()))));
    };
    const double sign = brighterAhead ? 1 : -1;
    int steepest = 0;
    for (int i = -half; i <= half; ++i) {
        const double at = stepPx * i;
        const double slope = std::max(0.0, sign * (greyAlong(at + 0.5) - greyAlong(at - 0.5)));
        slopes[static_cast<std::size_t>(i + half)] = slope;
        if (slope > slopes[static_cast<std::size_t>(steepest)])
            steepest = i + half;
    }
    if (steepest == 0 || steepest == 2 * half)
        return std::nullopt;
    double middle = steepest;
    const double window = std::min<double>(half, 1.75 / stepPx);
    double sum = 0;
    for (int pass = 0; pass < 3; ++pass) {
        double moment = 0;
        sum = 0;
        for (int i = 0; i <= 2 * half; ++i) {
            const double off = (i - middle) / window;
            const double weight = off * off < 1 ? (1 - off * off) * slopes[static_cast<std::size_t>(i)] : 0;
            sum += weight;
            moment += weight * i;
        }
        if (!(sum > 0))
            return std::nullopt;
        middle = moment / sum;
    }
    if (sum * stepPx < leastStep)
        return std::nullopt;
    return stepPx * (middle - half);
}

std::optional<EllipseOutline> ellipseThrough(const std::vector<Vector2d> &points)
{
    if (points.size() < 8)
        return std::nullopt;
    Vector2d mean = Vector2d::Zero();
    for (const Vector2d &point : points)
        mean += point / static_cast<double>(points.size());
    double scale = 0;
    for (const Vector2d &point : points)
        scale += (point - mean).norm() / static_cast<double>(points.size());
    if (!(scale > 0))
        return std::nullopt;
    std::vector<double> weights(points.size(), 1);
    Conic conic = Conic::Zero();
    for (int pass = 0; pass < passes; ++pass) {
        Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Conic row = weights[i] * rowOf((points[i] - mean) / scale);
            normal += row * row.transpose();
        }
        conic = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(normal).eigenvectors().col(0);
        for (std::size_t i = 0; i < points.size(); ++i)
            weights[i] = 1 / std::max(1e-9, gradientOf(conic, (points[i] - mean) / scale));
    }
    auto outline = outlineOf(conic);
    if (!outline)
        return std::nullopt;
    outline->centre = scale * outline->centre + mean;
    outline->semiAxes *= scale;
    return outline;
}

std::optional<EllipseEdge> fitEdge(const cv::Mat &luma, const EllipseOutline &start, double reachShare, bool brighterOutside)
{
    EllipseOutline outline = start;
    std::vector<Vector2d> points;
    const auto rays = static_cast<std::size_t>(std::clamp(3 * (start.semiAxes.x() + start.semiAxes.y()), 24.0, 160.0));
    for (int pass = 0; pass < passes; ++pass) {
        points = edgePoints(luma, outline, reachShare, brighterOutside, rays);
        if (static_cast<double>(points.size()) < leastShare * static_cast<double>(rays))
            return std::nullopt;
        auto fitted = ellipseThrough(points);
        if (!fitted)
            return std::nullopt;
        const double rms = rmsFrom(*fitted, points);
        std::erase_if(points, [&](const Vector2d &point) { return std::abs(distanceFrom(*fitted, point)) > 2.5 * rms + 0.02; });
        if (auto again = ellipseThrough(points))
            fitted = again;
        outline = *fitted;
        if (!(outline.semiAxes.y() > 0.5) || (outline.centre - start.centre).norm() > start.semiAxes.x())
            return std::nullopt;
    }
    const double rms = rmsFrom(outline, points);
    const double count = static_cast<double>(points.size());
    // A point tells of the middle across the edge only, half of it for each coordinate; five values are fitted.
    return EllipseEdge{outline, rms * std::sqrt(2.0 / std::max(1.0, count - 5)), rms};
}

} // namespace odo
