// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/marker_assignment.h"

#include "core/base/percentile.h"
#include "core/calibration/internal/assignment_search.h"
#include "core/calibration/internal/grown_assignment.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/geometry/floor_view.h"
#include "core/geometry/homography.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace odo {

namespace {

using Eigen::Vector2d;
using Solution = AssignmentSearch::Solution;

constexpr double clearlyBetter = 3, leastDifferencePx = 0.7;
constexpr std::size_t leastToGrow = 12;        // markers; fewer have too few neighbours
constexpr std::size_t mostToSearch = 24;       // markers; of more there are too many fours
constexpr std::size_t mostGrown = 400;         // shapes, the largest ones
constexpr std::size_t mostPosed = 40;          // assignments
constexpr double mostChance = -9;              // decimal logarithm; thousands of beginnings are tried
constexpr double leastMisfitDifference = 0.02; // of the markers' spacing
constexpr double grownHintReachPx = 20;
constexpr double leastPoseFitPx = 1.5, worstPoseFit = 0.004; // of the extent, of a lens that is known
constexpr std::size_t mostStrays = 3;                        // a third
constexpr double leastStrayPx = 3, strayOfMedian = 10;       // of the misfits: one is astray
constexpr double worstBentFit = 0.03;                        // of one that is not

tl::unexpected<Error> refuseAssignment(Message why, Message advice)
{
    return fail(ErrorCode::Undetermined,
                ODO_TEXT("calibration.markers_not_told_apart", "the markers cannot be distinguished"),
                std::move(why), std::move(advice));
}

/// Those of an assignment; pixel: of a shape by its index.
std::vector<MarkerPixel> pixelsOf(const std::vector<int> &assignment, const MarkerLayout &layout,
                                  const std::function<Vector2d(int)> &pixel)
{
    std::vector<MarkerPixel> pixels;
    for (std::size_t label = 0; label < layout.markers.size(); ++label) {
        if (assignment[label] >= 0)
            pixels.push_back({layout.markers[label].label, pixel(assignment[label])});
    }
    return pixels;
}

/// Solutions that are as good as the first one.
std::vector<std::vector<int>> rivals(const std::vector<Solution> &solutions)
{
    std::vector<std::vector<int>> rivals;
    const Solution &best = solutions.front();
    for (const Solution &other : solutions) {
        if (other.matched == best.matched && other.sizesAgree == best.sizesAgree &&
            other.rmsPx < std::max(clearlyBetter * best.rmsPx, best.rmsPx + leastDifferencePx))
            rivals.push_back(other.assignment);
    }
    return rivals;
}

tl::unexpected<Error> askForOne(const MarkerLayout &layout, const std::vector<std::vector<int>> &equal)
{
    // The label whose shape differs most often says the most.
    std::string best;
    std::size_t most = 0;
    for (std::size_t label = 0; label < layout.markers.size(); ++label) {
        std::set<int> shapes;
        for (const std::vector<int> &assignment : equal)
            shapes.insert(assignment[label]);
        if (shapes.size() > most) {
            most = shapes.size();
            best = layout.markers[label].label;
        }
    }
    return refuseAssignment(
        ODO_TEXT("calibration.markers_fit_many_ways",
                 "they fit the layout equally well in %1 ways, because it looks the same from several sides")(
            equal.size()),
        ODO_TEXT("calibration.tell_by_hand", "mark by hand which of them is %1")(Named::marker(best)));
}

/// What one way of assigning found: the markers, or why they cannot be told apart.
struct Outcome
{
    std::size_t matched = 0;
    Result<std::vector<MarkerPixel>> markers;
};

std::optional<Outcome> searched(const std::vector<RoundMarker> &shapes, const MarkerLayout &layout,
                                const CameraModel &camera, bool intrinsicsKnown,
                                const std::vector<MarkerPixel> &hints)
{
    AssignmentSearch search(layout, camera, intrinsicsKnown);
    search.addShapes(shapes);
    search.fix(hints);
    if (search.count() < 4)
        return std::nullopt;
    const auto solutions = search.solutions();
    if (solutions.empty())
        return std::nullopt;
    const Solution &best = solutions.front();
    const auto equal = rivals(solutions);
    if (equal.size() > 1)
        return Outcome{best.matched, askForOne(layout, equal)};
    return Outcome{best.matched,
                   pixelsOf(best.assignment, layout, [&](int shape) { return search.pixel(shape); })};
}

MarkerShapeSeen seenShape(const RoundMarker &shape)
{
    MarkerShapeSeen seen{shape.centrePx, shape.outline.area(), Eigen::Matrix2d::Identity()};
    if (seen.areaPx > 0)
        seen.round = shape.outline.semiAxes.cwiseInverse().asDiagonal() *
                     Eigen::Rotation2Dd(-shape.outline.angleRad).toRotationMatrix();
    return seen;
}

/// The shape of each marker that is known; a pixel without one becomes a shape.
std::vector<int> knownShapes(std::vector<MarkerShapeSeen> &shapes, const MarkerLayout &layout,
                             const std::vector<MarkerPixel> &hints)
{
    std::vector<int> known(layout.markers.size(), GrownAssignment::nothing);
    for (const MarkerPixel &hint : hints) {
        const auto label = std::ranges::find(layout.markers, hint.label, &Marker::label);
        if (label == layout.markers.end())
            continue;
        const auto away = [&](const MarkerShapeSeen &shape) { return (shape.pixel - hint.pixel).norm(); };
        auto nearest = std::ranges::min_element(shapes, {}, away);
        if (nearest == shapes.end() || away(*nearest) > grownHintReachPx) {
            shapes.push_back({hint.pixel, 0, Eigen::Matrix2d::Identity()});
            nearest = shapes.end() - 1;
        }
        known[static_cast<std::size_t>(label - layout.markers.begin())] =
            static_cast<int>(nearest - shapes.begin());
    }
    return known;
}

/// A pose that fits the markers, without those that do not fit it: growth over a gap may have gone astray.
/// nullopt where no camera above the floor sees most of them so.
std::optional<PlanePose> posedWithoutStrays(GrownAssignment &one, const std::vector<MarkerShapeSeen> &seen,
                                            const MarkerLayout &layout, const CameraModel &camera,
                                            bool intrinsicsKnown)
{
    const double share = intrinsicsKnown ? worstPoseFit : worstBentFit;
    for (const std::size_t least = one.matched - one.matched / mostStrays; one.matched >= least;) {
        std::vector<PointPair> pairs;
        std::vector<Vector2d> pixels;
        std::vector<std::size_t> labels;
        for (std::size_t label = 0; label < layout.markers.size(); ++label) {
            if (one.shapes[label] < 0)
                continue;
            pixels.push_back(seen[static_cast<std::size_t>(one.shapes[label])].pixel);
            pairs.push_back({layout.markers[label].pointInWorld, pixels.back(), layout.markers[label].label});
            labels.push_back(label);
        }
        const auto pose =
            fitPlanePose(pairs, camera, intrinsicsKnown ? FocalLength::Known : FocalLength::Free);
        if (!pose || !(pose->worldFromCamera.translation.z() > 0))
            return std::nullopt;
        const FloorView view(pose->camera, pose->worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
        std::vector<double> away;
        for (const PointPair &pair : pairs) {
            const auto pixel = view.pixelFromWorld({pair.source.x(), pair.source.y(), 0});
            away.push_back(pixel ? (*pixel - pair.target).norm() : std::numeric_limits<double>::infinity());
        }
        const auto worst = std::ranges::max_element(away) - away.begin();
        const double worstPx = away[static_cast<std::size_t>(worst)];
        if (pose->rmsPx < std::max(leastPoseFitPx, share * extentOf(pixels)) &&
            worstPx < std::max(leastStrayPx, strayOfMedian * upperMedian(std::move(away))))
            return *pose;
        one.shapes[labels[static_cast<std::size_t>(worst)]] = GrownAssignment::nothing;
        --one.matched;
    }
    return std::nullopt;
}

/// How many of the layout's markers lie in the image.
std::size_t visibleMarkers(const PlanePose &pose, const MarkerLayout &layout)
{
    const FloorView view(pose.camera, pose.worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
    const Intrinsics &lens = pose.camera.intrinsics();
    return static_cast<std::size_t>(std::ranges::count_if(layout.markers, [&](const Marker &marker) {
        const auto pixel = view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
        return pixel && pixel->x() > 0 && pixel->y() > 0 && pixel->x() < lens.widthPx &&
               pixel->y() < lens.heightPx;
    }));
}

/// The probability, as its decimal logarithm, that so many of the visible markers have a shape that near by
/// chance: binomial, from three that are given. shapes: how many lie in the image.
double chanceOf(const GrownAssignment &assignment, std::size_t visible, std::size_t shapes)
{
    constexpr double given = 3, leastMisfit = 0.01, reach = 2;
    const double n = static_cast<double>(std::max(visible, assignment.matched)) - given,
                 k = static_cast<double>(assignment.matched) - given;
    if (!(k > 0))
        return 0;
    // As dense as the markers are, shapes have each one spacing squared for themselves.
    const double dense = std::max(1.0, static_cast<double>(shapes) / (n + given));
    const double within = reach * std::max(leastMisfit, assignment.misfit);
    const double share = std::min(0.9, dense * double(EIGEN_PI) * within * within);
    const double ways = std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1);
    return (ways + k * std::log(share)) / std::log(10.0);
}

/// Of many markers: from neighbours.
std::optional<Outcome> grownFrom(const std::vector<RoundMarker> &shapes, const MarkerLayout &layout,
                                 const CameraModel &camera, bool intrinsicsKnown,
                                 const std::vector<MarkerPixel> &hints)
{
    std::vector<MarkerShapeSeen> seen;
    for (std::size_t i = 0; i < std::min(mostGrown, shapes.size()); ++i)
        seen.push_back(seenShape(shapes[i]));
    const auto known = knownShapes(seen, layout, hints);
    std::vector<Vector2d> positions;
    for (const Marker &marker : layout.markers)
        positions.push_back(marker.pointInWorld);
    const Intrinsics &lens = camera.intrinsics();
    auto grown = growAssignments(positions, seen, known, Vector2d(lens.widthPx, lens.heightPx));
    if (grown.size() > mostPosed)
        grown.resize(mostPosed);
    const auto markersOf = [&](const GrownAssignment &one) {
        return pixelsOf(one.shapes, layout,
                        [&](int shape) { return seen[static_cast<std::size_t>(shape)].pixel; });
    };
    std::erase_if(grown, [&](GrownAssignment &one) {
        const auto pose = posedWithoutStrays(one, seen, layout, camera, intrinsicsKnown);
        const std::size_t visible = pose ? visibleMarkers(*pose, layout) : 0;
        return !pose || 2 * one.matched < visible || chanceOf(one, visible, seen.size()) > mostChance;
    });
    std::ranges::stable_sort(grown, std::greater(), &GrownAssignment::matched);
    if (grown.empty())
        return std::nullopt;
    const GrownAssignment &best = grown.front();
    // Where some are hidden, one that is none may stand for one that is.
    const std::size_t spare = best.matched == layout.markers.size() ? 0 : 1;
    std::vector<std::vector<int>> equal;
    for (const GrownAssignment &other : grown) {
        if (other.matched + spare >= best.matched &&
            other.misfit < std::max(clearlyBetter * best.misfit, best.misfit + leastMisfitDifference))
            equal.push_back(other.shapes);
    }
    if (equal.size() > 1)
        return Outcome{best.matched, askForOne(layout, equal)};
    return Outcome{best.matched, markersOf(best)};
}

} // namespace

Result<std::vector<MarkerPixel>> assignMarkers(const std::vector<RoundMarker> &shapes,
                                               const MarkerLayout &layout, const CameraModel &camera,
                                               bool intrinsicsKnown, const std::vector<MarkerPixel> &hints)
{
    std::vector<RoundMarker> rings;
    std::ranges::copy_if(shapes, std::back_inserter(rings),
                         [](const RoundMarker &shape) { return shape.kind == RoundMarker::Kind::Ring; });
    std::optional<Result<std::vector<MarkerPixel>>> best;
    std::size_t most = 0;
    for (const std::vector<RoundMarker> &some : {rings, shapes}) {
        if (best && (most == layout.markers.size() || some.size() == rings.size()))
            break;
        std::optional<Outcome> outcome;
        if (layout.markers.size() >= leastToGrow)
            outcome = grownFrom(some, layout, camera, intrinsicsKnown, hints);
        if (!outcome && layout.markers.size() <= mostToSearch)
            outcome = searched(some, layout, camera, intrinsicsKnown, hints);
        if (!outcome || outcome->matched <= most)
            continue;
        most = outcome->matched;
        best = std::move(outcome->markers);
    }
    if (best)
        return *best;
    if (shapes.size() + hints.size() < 4)
        return refuseAssignment(
            ODO_TEXT("calibration.too_few_shapes",
                     "%1 rings or dots were found, four are needed")(shapes.size()),
            ODO_TEXT("calibration.show_more_shapes",
                     "show more of them, larger or in better light, or mark the markers by hand"));
    return refuseAssignment(ODO_TEXT("calibration.shapes_fit_nowhere",
                                     "no assignment of the %1 rings and dots fits the layout")(shapes.size()),
                            ODO_TEXT("calibration.check_layout_places",
                                     "check the layout's positions and their unit, cover "
                                     "other round objects, or mark the markers by hand"));
}

} // namespace odo
