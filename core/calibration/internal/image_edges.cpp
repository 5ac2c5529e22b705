// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/image_edges.h"

#include "core/calibration/internal/corner_grid.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace odo {

namespace {

using Eigen::Vector2d;
using Conic = Eigen::Matrix<double, 6, 1>; // of (x², xy, y², x, y, 1)

constexpr double stepPx = 0.25;
constexpr double leastReachPx = 1.25, mostReachPx = 5;
constexpr double leastStep = 12;    // of brightness, over the edge
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
    return Vector2d(2 * conic(0) * p.x() + conic(1) * p.y() + conic(3),
                    conic(1) * p.x() + 2 * conic(2) * p.y() + conic(4))
        .norm();
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
    return EllipseOutline{centre,
                          {std::sqrt(squares(longer)), std::sqrt(squares(1 - longer))},
                          std::atan2(along.y(), along.x())};
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

std::vector<Vector2d> edgePoints(const cv::Mat &luma, const EllipseOutline &about, double reachShare,
                                 bool brighterOutside, std::size_t rays)
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
        if (from.x() < reach + 1 || from.y() < reach + 1 || from.x() > luma.cols - reach - 2 ||
            from.y() > luma.rows - reach - 2)
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

std::optional<double> edgeAhead(const cv::Mat &luma, const Vector2d &from, const Vector2d &direction,
                                double reachPx, bool brighterAhead)
{
    constexpr int most = 2 * static_cast<int>(mostReachPx / stepPx) + 1;
    std::array<double, most> slopes{};
    const int half = static_cast<int>(std::min(reachPx, mostReachPx) / stepPx);
    const auto greyAlong = [&](double distance) {
        const Vector2d p = from + distance * direction;
        return static_cast<double>(
            greyAt(luma, cv::Point2f(static_cast<float>(p.x()), static_cast<float>(p.y()))));
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

std::optional<EllipseEdge> fitEdge(const cv::Mat &luma, const EllipseOutline &start, double reachShare,
                                   bool brighterOutside)
{
    EllipseOutline outline = start;
    std::vector<Vector2d> points;
    const auto rays =
        static_cast<std::size_t>(std::clamp(3 * (start.semiAxes.x() + start.semiAxes.y()), 24.0, 160.0));
    for (int pass = 0; pass < passes; ++pass) {
        points = edgePoints(luma, outline, reachShare, brighterOutside, rays);
        if (static_cast<double>(points.size()) < leastShare * static_cast<double>(rays))
            return std::nullopt;
        auto fitted = ellipseThrough(points);
        if (!fitted)
            return std::nullopt;
        const double rms = rmsFrom(*fitted, points);
        std::erase_if(points, [&](const Vector2d &point) {
            return std::abs(distanceFrom(*fitted, point)) > 2.5 * rms + 0.02;
        });
        if (auto again = ellipseThrough(points))
            fitted = again;
        outline = *fitted;
        if (!(outline.semiAxes.y() > 0.5) || (outline.centre - start.centre).norm() > start.semiAxes.x())
            return std::nullopt;
    }
    const double rms = rmsFrom(outline, points);
    const double count = static_cast<double>(points.size());
    // A point constrains the middle across the edge only, half of it for each coordinate; five values are
    // fitted.
    return EllipseEdge{outline, rms * std::sqrt(2.0 / std::max(1.0, count - 5)), rms};
}

namespace {

using Eigen::Vector2d;

constexpr std::size_t mostEdges = 12, leastPoints = 8;
constexpr double leastSlope = 16, shareOfSteepest = 0.25; // Sobel's, per pixel
constexpr double reachPx = 1.2, sameDirection = 0.985;    // 10°
constexpr double gapPx = 2.5, roundCornerPx = 3;
constexpr double worstEdgeSigma = 0.4; // of one point: no straight edge of anything
constexpr double leastSine = 0.42;     // 25°

struct Point
{
    Vector2d position, toBright;
    bool used = false;
};

/// Pixels whose slope is the largest along their own gradient.
std::vector<Point> steepPoints(const cv::Mat &image)
{
    cv::Mat smooth, dx, dy, slope;
    cv::GaussianBlur(image, smooth, {0, 0}, 0.8);
    cv::Sobel(smooth, dx, CV_32F, 1, 0, 3, 0.125);
    cv::Sobel(smooth, dy, CV_32F, 0, 1, 3, 0.125);
    cv::magnitude(dx, dy, slope);
    double steepest = 0;
    cv::minMaxLoc(slope, nullptr, &steepest);
    const double least = std::max(leastSlope / 2, shareOfSteepest * steepest);
    std::vector<Point> points;
    for (int y = 2; y < image.rows - 2; ++y) {
        for (int x = 2; x < image.cols - 2; ++x) {
            const double here = slope.at<float>(y, x);
            if (here < least)
                continue;
            const Vector2d normal = Vector2d(dx.at<float>(y, x), dy.at<float>(y, x)) / here;
            const auto at = [&](double step) {
                const double u = x + step * normal.x(), v = y + step * normal.y();
                const int i = static_cast<int>(u), j = static_cast<int>(v);
                const double a = u - i, b = v - j;
                return (1 - b) * ((1 - a) * slope.at<float>(j, i) + a * slope.at<float>(j, i + 1)) +
                       b * ((1 - a) * slope.at<float>(j + 1, i) + a * slope.at<float>(j + 1, i + 1));
            };
            const double before = at(-1), after = at(1);
            if (here < before || here <= after)
                continue;
            const double curvature = before - 2 * here + after;
            const double off = curvature < 0 ? std::clamp(0.5 * (before - after) / curvature, -1.0, 1.0) : 0;
            points.push_back({Vector2d(x, y) + off * normal, normal, false});
        }
    }
    return points;
}

bool isOn(const Point &point, const Vector2d &middle, const Vector2d &toBright)
{
    return std::abs(toBright.dot(point.position - middle)) < reachPx &&
           point.toBright.dot(toBright) > sameDirection;
}

/// The line through points by least squares across it; normal turned as the one given.
void fitLine(const std::vector<Vector2d> &points, Vector2d &middle, Vector2d &normal)
{
    middle.setZero();
    for (const Vector2d &point : points)
        middle += point / static_cast<double>(points.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Vector2d &point : points)
        spread += (point - middle) * (point - middle).transpose();
    const Vector2d across = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(0);
    normal = across.dot(normal) < 0 ? Vector2d(-across) : across;
}

/// Without the points beside a gap or an end: where an edge turns away, the blur draws it round the corner.
std::vector<Vector2d> awayFromEnds(std::vector<Vector2d> points, const Vector2d &direction)
{
    const auto along = [&](const Vector2d &point) { return direction.dot(point); };
    std::ranges::sort(points, {}, along);
    std::vector<double> ends;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i == 0 || along(points[i]) - along(points[i - 1]) > gapPx)
            ends.push_back(along(points[i]));
        if (i + 1 == points.size() || along(points[i + 1]) - along(points[i]) > gapPx)
            ends.push_back(along(points[i]));
    }
    std::erase_if(points, [&](const Vector2d &point) {
        return std::ranges::any_of(ends,
                                   [&](double end) { return std::abs(along(point) - end) < roundCornerPx; });
    });
    return points;
}

/// Points of a line that follow one another without a long gap may be of two things in a row; they are kept
/// together, since an edge that passes behind a crossing strip goes on beyond it.
std::optional<StraightEdge> measured(const cv::Mat &image, const std::vector<Vector2d> &rough,
                                     Vector2d middle, Vector2d normal)
{
    std::vector<Vector2d> points;
    for (const Vector2d &point : rough) {
        const Vector2d onLine = point - normal.dot(point - middle) * normal;
        if (const auto edge = edgeAhead(image, onLine, normal, 2.5, true); edge && std::abs(*edge) < 1.5)
            points.emplace_back(onLine + *edge * normal);
    }
    points = awayFromEnds(std::move(points), {-normal.y(), normal.x()});
    for (int pass = 0; pass < 2 && points.size() >= leastPoints; ++pass) {
        fitLine(points, middle, normal);
        std::erase_if(points,
                      [&](const Vector2d &point) { return std::abs(normal.dot(point - middle)) > 0.6; });
    }
    if (points.size() < leastPoints)
        return std::nullopt;
    fitLine(points, middle, normal);
    StraightEdge edge{middle, normal, {}, 0};
    double squares = 0;
    for (const Vector2d &point : points) {
        edge.along.push_back(edge.direction().dot(point - middle));
        squares += std::pow(normal.dot(point - middle), 2);
    }
    edge.sigmaPx = std::sqrt(squares / static_cast<double>(points.size() - 2));
    std::ranges::sort(edge.along);
    if (edge.sigmaPx > worstEdgeSigma ||
        edge.along.back() - edge.along.front() < static_cast<double>(leastPoints))
        return std::nullopt;
    return edge;
}

} // namespace

double StraightEdge::sigmaAt(double alongPx) const
{
    double squares = 0;
    for (const double at : along)
        squares += at * at;
    return sigmaPx *
           std::sqrt(1 / static_cast<double>(along.size()) + alongPx * alongPx / std::max(squares, 1e-9));
}

bool StraightEdge::runs(double fromPx, double toPx) const
{
    const auto count = std::ranges::count_if(along, [&](double at) { return at >= fromPx && at <= toPx; });
    return static_cast<double>(count) >= 0.5 * (toPx - fromPx) - 1;
}

std::vector<StraightEdge> findStraightEdges(const cv::Mat &image)
{
    std::vector<Point> points = steepPoints(image);
    std::vector<StraightEdge> edges;
    for (std::size_t tries = 0; tries < 2 * mostEdges && edges.size() < mostEdges; ++tries) {
        const Point *best = nullptr;
        std::size_t most = 0;
        for (const Point &seed : points) {
            if (seed.used)
                continue;
            const auto count =
                static_cast<std::size_t>(std::ranges::count_if(points, [&](const Point &point) {
                    return !point.used && isOn(point, seed.position, seed.toBright);
                }));
            if (count > most) {
                most = count;
                best = &seed;
            }
        }
        if (most < leastPoints)
            break;
        Vector2d middle = best->position, normal = best->toBright;
        std::vector<Vector2d> members;
        for (int pass = 0; pass < 3; ++pass) {
            members.clear();
            for (const Point &point : points) {
                if (!point.used && isOn(point, middle, normal))
                    members.push_back(point.position);
            }
            if (members.size() < leastPoints)
                break;
            fitLine(members, middle, normal);
        }
        bool usedAny = false;
        for (Point &point : points) {
            if (!point.used && isOn(point, middle, normal))
                point.used = usedAny = true;
        }
        if (!usedAny)
            break;
        if (auto edge = measured(image, members, middle, normal))
            edges.push_back(std::move(*edge));
    }
    std::ranges::stable_sort(edges, std::greater(),
                             [](const StraightEdge &edge) { return edge.along.size(); });
    return edges;
}

std::optional<Vector2d> crossingOf(const StraightEdge &one, const StraightEdge &other)
{
    const double sine = one.toBright.x() * other.toBright.y() - one.toBright.y() * other.toBright.x();
    if (std::abs(sine) < leastSine)
        return std::nullopt;
    Eigen::Matrix2d normals;
    normals << one.toBright.transpose(), other.toBright.transpose();
    return Vector2d(normals.inverse() *
                    Vector2d(one.toBright.dot(one.middle), other.toBright.dot(other.middle)));
}

} // namespace odo
