// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/straight_edges.h"

#include "core/calibration/ellipse_edge.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr std::size_t mostEdges = 12, leastPoints = 8;
constexpr double leastSlope = 16, shareOfSteepest = 0.25; // Sobel's, per pixel
constexpr double reachPx = 1.2, sameDirection = 0.985;    // 10°
constexpr double gapPx = 2.5, roundCornerPx = 3;
constexpr double worstEdgeSigma = 0.4;                    // of one point: no straight edge of anything
constexpr double leastSine = 0.42;                        // 25°

struct Point
{
    Vector2d place, toBright;
    bool used = false;
};

/// Pixels whose slope is the largest along their own gradient.
std::vector<Point> steepPoints(const cv::Mat &picture)
{
    cv::Mat smooth, dx, dy, slope;
    cv::GaussianBlur(picture, smooth, {0, 0}, 0.8);
    cv::Sobel(smooth, dx, CV_32F, 1, 0, 3, 0.125);
    cv::Sobel(smooth, dy, CV_32F, 0, 1, 3, 0.125);
    cv::magnitude(dx, dy, slope);
    double steepest = 0;
    cv::minMaxLoc(slope, nullptr, &steepest);
    const double least = std::max(leastSlope / 2, shareOfSteepest * steepest);
    std::vector<Point> points;
    for (int y = 2; y < picture.rows - 2; ++y) {
        for (int x = 2; x < picture.cols - 2; ++x) {
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
    return std::abs(toBright.dot(point.place - middle)) < reachPx && point.toBright.dot(toBright) > sameDirection;
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

/// Points of a line that follow one another without a long gap may be of two things in a row; they are kept together,
/// since an edge that passes behind a crossing strip goes on beyond it.
std::optional<StraightEdge> measured(const cv::Mat &picture, const std::vector<Vector2d> &rough, Vector2d middle, Vector2d normal)
{
    std::vector<Vector2d> points;
    for (const Vector2d &point : rough) {
        const Vector2d onLine = point - normal.dot(point - middle) * normal;
        if (const auto edge = edgeAhead(picture, onLine, normal, 2.5, true); edge && std::abs(*edge) < 1.5)
            points.emplace_back(onLine + *edge * normal);
    }
    points = awayFromEnds(std::move(points), {-normal.y(), normal.x()});
    for (int pass = 0; pass < 2 && points.size() >= leastPoints; ++pass) {
        fitLine(points, middle, normal);
        std::erase_if(points, [&](const Vector2d &point) { return std::abs(normal.dot(point - middle)) > 0.6; });
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
    return sigmaPx * std::sqrt(1 / static_cast<double>(along.size()) + alongPx * alongPx / std::max(squares, 1e-9));
}

bool StraightEdge::runs(double fromPx, double toPx) const
{
    const auto count = std::ranges::count_if(along, [&](double at) { return at >= fromPx && at <= toPx; });
    return static_cast<double>(count) >= 0.5 * (toPx - fromPx) - 1;
}

std::vector<StraightEdge> findStraightEdges(const cv::Mat &picture)
{
    std::vector<Point> points = steepPoints(picture);
    std::vector<StraightEdge> edges;
    for (std::size_t tries = 0; tries < 2 * mostEdges && edges.size() < mostEdges; ++tries) {
        const Point *best = nullptr;
        std::size_t most = 0;
        for (const Point &seed : points) {
            if (seed.used)
                continue;
            const auto count = static_cast<std::size_t>(std::ranges::count_if(
                points, [&](const Point &point) { return !point.used && isOn(point, seed.place, seed.toBright); }));
            if (count > most) {
                most = count;
                best = &seed;
            }
        }
        if (most < leastPoints)
            break;
        Vector2d middle = best->place, normal = best->toBright;
        std::vector<Vector2d> members;
        for (int pass = 0; pass < 3; ++pass) {
            members.clear();
            for (const Point &point : points) {
                if (!point.used && isOn(point, middle, normal))
                    members.push_back(point.place);
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
        if (auto edge = measured(picture, members, middle, normal))
            edges.push_back(std::move(*edge));
    }
    std::ranges::stable_sort(edges, std::greater(), [](const StraightEdge &edge) { return edge.along.size(); });
    return edges;
}

std::optional<Vector2d> crossingOf(const StraightEdge &one, const StraightEdge &other)
{
    const double sine = one.toBright.x() * other.toBright.y() - one.toBright.y() * other.toBright.x();
    if (std::abs(sine) < leastSine)
        return std::nullopt;
    Eigen::Matrix2d normals;
    normals << one.toBright.transpose(), other.toBright.transpose();
    return Vector2d(normals.inverse() * Vector2d(one.toBright.dot(one.middle), other.toBright.dot(other.middle)));
}

} // namespace odo
