// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/corner_grid.h"
#include "core/calibration/internal/image_edges.h"
#include "core/calibration/internal/luma_matrix.h"
#include "core/calibration/internal/round_markers.h"
#include "core/calibration/internal/tag_detection.h"
#include "core/calibration/marker_detection.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr int largestMarkerPx = 130;               // from its middle to its rim
constexpr double inMiddle = 0.5, besideTag = 1.15; // of its half side
constexpr int tapeReachPx = 26;                    // beyond the reach: how much of the strips counts
constexpr double leastTapePx = 3, mostTapePx = 40;
constexpr double antiparallel = -0.95; // 18°: perspective
constexpr double armPx = 5;            // of a strip beyond the crossing, to count as one
constexpr double roundedPx = 3;        // about a corner, where no points of edges are taken
constexpr float fieldPx = 5;           // from a saddle into its fields
constexpr double leastContrast = 24;   // between them: a floor's own grain has saddles as well
constexpr double leastSnapSigmaPx = 0.02, clickSigmaPx = 1, saddleSigmaPx = 0.1;

PixelRect around(const Vector2d &near, double reach)
{
    return {static_cast<int>(std::floor(near.x() - reach)), static_cast<int>(std::floor(near.y() - reach)),
            static_cast<int>(std::ceil(near.x() + reach)) + 1,
            static_cast<int>(std::ceil(near.y() + reach)) + 1};
}

/// Beside a tag of a ChArUco board its corners are meant, beside the printed ones the tag; what reads by
/// chance is a tag only in its middle.
bool isMeant(const SeenTag &tag, const Vector2d &click)
{
    const Vector2d inTag = (tag.pixelFromTag.inverse() * click.homogeneous()).hnormalized();
    return tag.family == printedTagFamily().front() ||
           inTag.cwiseAbs().maxCoeff() < (isReadByChance(tag.family) ? inMiddle : besideTag);
}

std::optional<SnappedMarker> nearestTag(const std::vector<SeenTag> &tags, bool byChance, const Vector2d &near,
                                        double reachPx)
{
    std::optional<SnappedMarker> best;
    for (const SeenTag &tag : tags) {
        if (isReadByChance(tag.family) == byChance && (tag.pixel - near).norm() <= reachPx &&
            isMeant(tag, near) && (!best || (tag.pixel - near).norm() < (best->pixel - near).norm()))
            best =
                SnappedMarker{SnappedMarker::Kind::Tag, tag.pixel, std::max(leastSnapSigmaPx, tag.sigmaPx)};
    }
    return best;
}

std::optional<SnappedMarker> nearestRound(const std::vector<RoundMarker> &shapes, RoundMarker::Kind kind,
                                          const Vector2d &near, double reachPx)
{
    std::optional<SnappedMarker> best;
    for (const RoundMarker &shape : shapes) {
        // A click into a small dot, but one beside a ring as well: there is much that looks like a dot.
        const double reach =
            kind == RoundMarker::Kind::Ring ? reachPx : std::min(reachPx, shape.outline.semiAxes.x() + 2);
        if (shape.kind != kind || (shape.centrePx - near).norm() > reach)
            continue;
        if (!best || (shape.centrePx - near).norm() < (best->pixel - near).norm())
            best = SnappedMarker{kind == RoundMarker::Kind::Ring ? SnappedMarker::Kind::Ring
                                                                 : SnappedMarker::Kind::Dot,
                                 shape.centrePx, std::max(leastSnapSigmaPx, shape.sigmaPx)};
    }
    return best;
}

/// σ of where two edges cross.
double sigmaOf(const StraightEdge &one, const StraightEdge &other, const Vector2d &crossing)
{
    const double sine =
        std::abs(one.toBright.x() * other.toBright.y() - one.toBright.y() * other.toBright.x());
    const double a = one.sigmaAt(one.direction().dot(crossing - one.middle));
    const double b = other.sigmaAt(other.direction().dot(crossing - other.middle));
    return std::max(leastSnapSigmaPx, std::hypot(a, b) / sine / std::sqrt(2.0));
}

/// Two edges with a strip of tape between them.
struct Strip
{
    const StraightEdge *left, *right;
    bool isBright;
    double widthPx;
};

std::vector<Strip> stripsOf(const std::vector<StraightEdge> &edges)
{
    std::vector<Strip> strips;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            if (edges[i].toBright.dot(edges[j].toBright) > antiparallel)
                continue;
            const double towards = edges[i].toBright.dot(edges[j].middle - edges[i].middle);
            if (std::abs(towards) >= leastTapePx && std::abs(towards) <= mostTapePx)
                strips.push_back({&edges[i], &edges[j], towards > 0, std::abs(towards)});
        }
    }
    return strips;
}

/// The four corners that two strips have in common, those of the first strip's left edge before those of its
/// right one.
std::optional<std::array<Vector2d, 4>> cornersOf(const Strip &one, const Strip &other)
{
    const auto a = crossingOf(*one.left, *other.left), b = crossingOf(*one.left, *other.right);
    const auto c = crossingOf(*one.right, *other.left), d = crossingOf(*one.right, *other.right);
    if (!a || !b || !c || !d)
        return std::nullopt;
    return std::array{*a, *b, *c, *d};
}

/// An edge goes on beyond a point, in the direction away from another point on it.
bool goesOn(const StraightEdge &edge, const Vector2d &beyond, const Vector2d &from)
{
    const double at = edge.direction().dot(beyond - edge.middle);
    const bool forwards = edge.direction().dot(beyond - from) > 0;
    return forwards ? edge.runs(at + roundedPx, at + roundedPx + armPx)
                    : edge.runs(at - roundedPx - armPx, at - roundedPx);
}

int armsOf(const Strip &one, const Strip &other, const std::array<Vector2d, 4> &corners)
{
    const auto &[a, b, c, d] = corners;
    int arms = 0;
    arms += goesOn(*one.left, a, b) && goesOn(*one.right, c, d);
    arms += goesOn(*one.left, b, a) && goesOn(*one.right, d, c);
    arms += goesOn(*other.left, a, c) && goesOn(*other.right, b, d);
    arms += goesOn(*other.left, c, a) && goesOn(*other.right, d, b);
    return arms;
}

std::optional<SnappedMarker> nearestCrossing(const std::vector<StraightEdge> &edges, const Vector2d &near,
                                             double reachPx)
{
    const std::vector<Strip> strips = stripsOf(edges);
    std::optional<SnappedMarker> best;
    for (std::size_t i = 0; i < strips.size(); ++i) {
        for (std::size_t j = i + 1; j < strips.size(); ++j) {
            if (strips[i].isBright != strips[j].isBright)
                continue;
            const auto corners = cornersOf(strips[i], strips[j]);
            if (!corners || armsOf(strips[i], strips[j], *corners) < 3)
                continue;
            // The diagonals of the square that the strips share cross in its middle, whatever the
            // perspective.
            const auto &[a, b, c, d] = *corners;
            const Eigen::Vector3d one = a.homogeneous().cross(d.homogeneous()),
                                  other = b.homogeneous().cross(c.homogeneous());
            const Vector2d middle = one.cross(other).hnormalized();
            if (!middle.allFinite() || (middle - near).norm() > reachPx ||
                (best && (best->pixel - near).norm() < (middle - near).norm()))
                continue;
            const double sigma = 0.5 * std::hypot(sigmaOf(*strips[i].left, *strips[j].left, middle),
                                                  sigmaOf(*strips[i].right, *strips[j].right, middle));
            best =
                SnappedMarker{SnappedMarker::Kind::TapeCrossing, middle, std::max(leastSnapSigmaPx, sigma)};
        }
    }
    return best;
}

/// Points of the edge reach to within a few pixels of a position, and go on from there on one side at least.
bool reaches(const StraightEdge &edge, const Vector2d &position)
{
    const double at = edge.direction().dot(position - edge.middle);
    return edge.runs(at + roundedPx, at + roundedPx + armPx) ||
           edge.runs(at - roundedPx - armPx, at - roundedPx);
}

std::optional<SnappedMarker> nearestCorner(const std::vector<StraightEdge> &edges, const Vector2d &near,
                                           double reachPx)
{
    std::optional<SnappedMarker> best;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const auto crossing = crossingOf(edges[i], edges[j]);
            if (!crossing || (*crossing - near).norm() > reachPx || !reaches(edges[i], *crossing) ||
                !reaches(edges[j], *crossing))
                continue;
            if (!best || (*crossing - near).norm() < (best->pixel - near).norm())
                best = SnappedMarker{SnappedMarker::Kind::TapeCorner, *crossing,
                                     sigmaOf(edges[i], edges[j], *crossing)};
        }
    }
    return best;
}

/// How much brighter one pair of opposite fields is than the other, in grey values.
double contrastOf(const cv::Mat &image, const SaddlePoint &saddle)
{
    const auto fields = [&](const cv::Point2f &diagonal) {
        const cv::Point2f step = fieldPx / static_cast<float>(std::max(1e-3, cv::norm(diagonal))) * diagonal;
        return greyAt(image, saddle.position + step) + greyAt(image, saddle.position - step);
    };
    return 0.5 *
           std::abs(fields(saddle.edges[0] + saddle.edges[1]) - fields(saddle.edges[0] - saddle.edges[1]));
}

std::optional<SnappedMarker> nearestSaddle(const cv::Mat &image, const Vector2d &near, double reachPx)
{
    cv::Mat smooth;
    cv::GaussianBlur(image, smooth, {0, 0}, 1);
    std::vector<cv::Point2f> best;
    for (const SaddlePoint &saddle : findSaddlePoints(smooth)) {
        const Vector2d position(saddle.position.x, saddle.position.y);
        if ((position - near).norm() <= reachPx && contrastOf(smooth, saddle) >= leastContrast &&
            (best.empty() || (position - near).norm() < (Vector2d(best[0].x, best[0].y) - near).norm()))
            best = {saddle.position};
    }
    if (best.empty())
        return std::nullopt;
    cv::cornerSubPix(image, best, {4, 4}, {-1, -1},
                     {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 40, 0.005});
    return SnappedMarker{SnappedMarker::Kind::Saddle, {best[0].x, best[0].y}, saddleSigmaPx};
}

/// Tape, corners and saddles, in a part of the image that is cut out.
std::optional<SnappedMarker> nearestOfEdges(const Frame &frame, const Vector2d &near, double reachPx)
{
    const PixelRect rect = around(near, reachPx + tapeReachPx).clipped({0, 0, frame.y.width, frame.y.height});
    if (rect.width() < 24 || rect.height() < 24)
        return std::nullopt;
    const cv::Mat image = lumaMatrix(frame)(cv::Rect(rect.x0, rect.y0, rect.width(), rect.height())).clone();
    const Vector2d origin(rect.x0, rect.y0), local = near - origin;
    const auto edges = findStraightEdges(image);
    auto found = nearestCrossing(edges, local, reachPx);
    if (!found) {
        const auto saddle = nearestSaddle(image, local, reachPx),
                   corner = nearestCorner(edges, local, reachPx);
        // At a saddle two edges meet as well.
        const bool isSaddle =
            saddle && (!corner || (saddle->pixel - local).norm() <= (corner->pixel - local).norm() + 2);
        found = isSaddle ? saddle : corner;
    }
    if (found)
        found->pixel += origin;
    return found;
}

} // namespace

SnappedMarker snapToMarker(const Frame &frame, const Vector2d &near, double reachPx)
{
    SnappedMarker click{SnappedMarker::Kind::None, near, clickSigmaPx};
    if (frame.y.data == nullptr || !near.allFinite() || near.x() < 0 || near.y() < 0 ||
        near.x() > frame.y.width - 1 || near.y() > frame.y.height - 1)
        return click;
    const auto tags = findTags(frame, around(near, reachPx + largestMarkerPx), allTagFamilies());
    if (const auto tag = nearestTag(tags, false, near, reachPx))
        return *tag;
    const auto shapes = findRoundMarkers(frame, around(near, reachPx + largestMarkerPx));
    if (const auto ring = nearestRound(shapes, RoundMarker::Kind::Ring, near, reachPx))
        return *ring;
    if (const auto dot = nearestRound(shapes, RoundMarker::Kind::Dot, near, reachPx))
        return *dot;
    if (const auto tag = nearestTag(tags, true, near, reachPx))
        return *tag;
    return nearestOfEdges(frame, near, reachPx).value_or(click);
}

} // namespace odo
