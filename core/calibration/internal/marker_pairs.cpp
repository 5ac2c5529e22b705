// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/marker_pairs.h"

#include "core/calibration/internal/wording.h"

#include <algorithm>
#include <set>

namespace odo {

namespace {

constexpr double nearestPixels = 1.0;     // markers closer than that are one and the same
constexpr double nearestPositions = 1e-3; // of the layout's extent
constexpr double tooClose = 0.01;         // of the layout's extent: of four markers each must count

Message correctLayout()
{
    return ODO_TEXT("calibration.correct_layout", "correct the layout");
}

Message nameEachMarker()
{
    return ODO_TEXT("calibration.name_each_marker", "give each marker a name of its own");
}

template <class Points>
Result<void> checkLabels(const Points &points, const MessageText &isThereTwice)
{
    std::set<std::string> seen;
    for (const auto &point : points) {
        if (!seen.insert(point.label).second)
            return refuseFloor(isThereTwice(Named::marker(point.label)), nameEachMarker());
    }
    return {};
}

Result<void> checkNumbers(const MarkerLayout &layout, const std::vector<MarkerPixel> &pixels)
{
    for (const Marker &marker : layout.markers) {
        if (!marker.pointInWorld.allFinite())
            return refuseFloor(
                ODO_TEXT("calibration.marker_place_no_number",
                         "the position of marker %1 is not a finite number")(Named::marker(marker.label)),
                correctLayout(), ErrorCode::InvalidInput);
    }
    for (const MarkerPixel &pixel : pixels) {
        if (!pixel.pixel.allFinite())
            return refuseFloor(
                ODO_TEXT("calibration.marker_pixel_no_number",
                         "the pixel of marker %1 is not a finite number")(Named::marker(pixel.label)),
                correctPixels(), ErrorCode::InvalidInput);
    }
    return {};
}

} // namespace

std::vector<Eigen::Vector2d> positionsOf(std::span<const PointPair> pairs)
{
    std::vector<Eigen::Vector2d> positions;
    for (const PointPair &pair : pairs)
        positions.push_back(pair.source);
    return positions;
}

tl::unexpected<Error> refuseFloor(Message why, Message advice, ErrorCode code)
{
    return fail(code, ODO_TEXT("calibration.floor_not_registered", "the floor cannot be registered"),
                std::move(why), std::move(advice));
}

Result<void> checkDistances(const std::vector<PointPair> &pairs, double extentM)
{
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        for (std::size_t j = i + 1; j < pairs.size(); ++j) {
            const MessageArgument one = Named::marker(pairs[i].label), other = Named::marker(pairs[j].label);
            const double apartM = (pairs[i].source - pairs[j].source).norm();
            if (apartM <= nearestPositions * extentM)
                return refuseFloor(ODO_TEXT("calibration.markers_at_one_place",
                                            "markers %1 and %2 have the same floor position")(one, other),
                                   correctLayout());
            if ((pairs[i].target - pairs[j].target).norm() < nearestPixels)
                return refuseFloor(ODO_TEXT("calibration.markers_on_one_pixel",
                                            "markers %1 and %2 are on the same pixel")(one, other),
                                   markWhereSeen());
            if (pairs.size() == 4 && apartM < tooClose * extentM)
                return refuseFloor(ODO_TEXT("calibration.markers_too_close",
                                            "markers %1 and %2 are only %3 apart, too close for two of four")(
                                       one, other, millimetres(apartM)),
                                   spreadMarkers());
        }
    }
    return {};
}

Result<std::vector<PointPair>> commonMarkers(const MarkerLayout &layout,
                                             const std::vector<MarkerPixel> &pixels)
{
    ODO_TRY(checkLabels(layout.markers, ODO_TEXT("calibration.marker_twice_in_layout",
                                                 "marker %1 appears twice in the layout")));
    ODO_TRY(checkLabels(
        pixels, ODO_TEXT("calibration.marker_twice_in_picture", "marker %1 appears twice in the image")));
    ODO_TRY(checkNumbers(layout, pixels));
    std::vector<PointPair> pairs;
    std::vector<std::string> names;
    for (const Marker &marker : layout.markers) {
        const auto seen = std::ranges::find(pixels, marker.label, &MarkerPixel::label);
        if (seen == pixels.end())
            continue;
        pairs.push_back({marker.pointInWorld, seen->pixel, marker.label});
        names.push_back(marker.label);
    }
    std::vector<std::string> unknown;
    for (const MarkerPixel &pixel : pixels) {
        if (std::ranges::find(layout.markers, pixel.label, &Marker::label) == layout.markers.end())
            unknown.push_back(pixel.label);
    }
    if (pairs.size() >= 4)
        return pairs;
    const MessageArgument known = listed(names, MessageArgument::Kind::Marker);
    Message there = unknown.empty()
                        ? ODO_TEXT("calibration.common_markers", "they have %1 (%2)")(pairs.size(), known)
                        : ODO_TEXT("calibration.common_and_unknown_markers",
                                   "they have %1 (%2), and the layout does not contain %3")(
                              pairs.size(), known, listed(unknown, MessageArgument::Kind::Marker));
    return refuseFloor(
        joined({ODO_TEXT("calibration.four_common_markers",
                         "the layout and the image must have four markers in common"),
                std::move(there)},
               Join::Semicolon),
        ODO_TEXT("calibration.mark_more", "mark more of the layout's markers, by their names in the layout"));
}

} // namespace odo
