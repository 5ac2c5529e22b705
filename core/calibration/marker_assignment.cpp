// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/marker_assignment.h"

#include "core/calibration/assignment_search.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

namespace odo {

namespace {

using Solution = AssignmentSearch::Solution;

constexpr const char *assignment = "the markers cannot be told apart";
constexpr double clearlyBetter = 3, leastDifferencePx = 0.7;

tl::unexpected<Error> refuseAssignment(std::string why, std::string advice)
{
    return fail(ErrorCode::Undetermined, assignment, std::move(why), std::move(advice));
}

std::vector<MarkerPixel> pixelsOf(const AssignmentSearch &search, const Solution &solution,
                                  const MarkerLayout &layout)
{
    std::vector<MarkerPixel> pixels;
    for (std::size_t label = 0; label < layout.markers.size(); ++label) {
        if (solution.assignment[label] != AssignmentSearch::nothing)
            pixels.push_back({layout.markers[label].label, search.pixel(solution.assignment[label])});
    }
    return pixels;
}

/// Solutions that are as good as the first one.
std::vector<Solution> rivals(const std::vector<Solution> &solutions)
{
    std::vector<Solution> rivals;
    const Solution &best = solutions.front();
    for (const Solution &other : solutions) {
        if (other.matched == best.matched && other.sizesAgree == best.sizesAgree &&
            other.rmsPx < std::max(clearlyBetter * best.rmsPx, best.rmsPx + leastDifferencePx))
            rivals.push_back(other);
    }
    return rivals;
}

tl::unexpected<Error> askForOne(const MarkerLayout &layout, const std::vector<Solution> &equal)
{
    // The label whose shape differs the most often tells the most.
    std::string best;
    std::size_t most = 0;
    for (std::size_t label = 0; label < layout.markers.size(); ++label) {
        std::set<int> shapes;
        for (const Solution &solution : equal)
            shapes.insert(solution.assignment[label]);
        if (shapes.size() > most) {
            most = shapes.size();
            best = layout.markers[label].label;
        }
    }
    return refuseAssignment(
        "in " + std::to_string(equal.size()) +
            " ways they fit the layout equally well, which looks the same from several sides",
        "tell by hand which of them is " + best);
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
        AssignmentSearch search(layout, camera, intrinsicsKnown);
        search.addShapes(some);
        search.fix(hints);
        if (search.count() < 4)
            continue;
        const auto solutions = search.solutions();
        if (solutions.empty() || solutions.front().matched <= most)
            continue;
        most = solutions.front().matched;
        const auto equal = rivals(solutions);
        if (equal.size() > 1)
            best = askForOne(layout, equal);
        else
            best = pixelsOf(search, solutions.front(), layout);
    }
    if (best)
        return *best;
    if (shapes.size() + hints.size() < 4)
        return refuseAssignment(std::to_string(shapes.size()) + " rings or dots were found, four are needed",
                                "show more of them, larger or in better light, or mark the markers by hand");
    return refuseAssignment(
        "none of the ways to name the " + std::to_string(shapes.size()) + " rings and dots fits the layout",
        "check the layout's places and their unit, cover other round things, or mark the markers by hand");
}

} // namespace odo
