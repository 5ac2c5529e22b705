// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/marker_detection.h"

#include "core/calibration/dot_centre.h"
#include "core/calibration/floor_registration.h"
#include "core/calibration/marker_assignment.h"
#include "core/calibration/round_markers.h"
#include "core/calibration/tag_foretelling.h"
#include "core/calibration/wording.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr int leastPictureSide = 32;

/// Dots' middles are corrected by a first pose, which is off by less than they are.
std::vector<MarkerPixel> withTrueCentres(std::vector<MarkerPixel> markers,
                                         const std::vector<RoundMarker> &shapes, const MarkerLayout &layout,
                                         const CameraModel &camera, bool intrinsicsKnown)
{
    const auto registration = registerFloor(layout, markers, camera, intrinsicsKnown);
    if (!registration)
        return markers;
    const auto lens = CameraModel::create(registration->intrinsics);
    if (!lens)
        return markers;
    const FloorView view(*lens, registration->worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
    for (MarkerPixel &marker : markers) {
        const auto isIt = [&](const RoundMarker &shape) {
            return shape.kind == RoundMarker::Kind::Dot && shape.centrePx == marker.pixel;
        };
        const auto dot = std::ranges::find_if(shapes, isIt);
        if (dot != shapes.end())
            marker.pixel = dotCentre(dot->outline, view).value_or(marker.pixel);
    }
    return markers;
}

bool isSeenTwice(const std::vector<SeenTag> &tags)
{
    return std::ranges::any_of(
        tags, [&](const SeenTag &tag) { return std::ranges::count(tags, tag.number, &SeenTag::number) > 1; });
}

/// Tags of the layout: those read, then smaller ones, then those that the others foretell.
std::vector<SeenTag> layoutTags(const Frame &frame, const MarkerLayout &layout, const MarkerSearch &search)
{
    const auto count = static_cast<int>(layout.markers.size());
    const auto ofLayout = [&](std::vector<SeenTag> tags) {
        std::erase_if(tags, [&](const SeenTag &tag) { return tag.number >= count; });
        return tags;
    };
    const auto all = [&](const std::vector<SeenTag> &tags) { return std::ssize(tags) >= count; };
    std::vector<SeenTag> tags = ofLayout(findTags(frame));
    if (tags.empty() || all(tags))
        return tags;
    const std::vector<SeenTag> read = tags;
    for (const SeenTag &small : ofLayout(findSmallTags(frame))) {
        if (std::ranges::find(read, small.number, &SeenTag::number) == read.end())
            tags.push_back(small);
    }
    if (all(tags) || isSeenTwice(tags))
        return tags;
    std::ranges::move(
        foretoldTags(frame, layout, tags, search.intrinsicsKnown ? search.camera : std::nullopt),
        std::back_inserter(tags));
    return tags;
}

} // namespace

Result<std::vector<MarkerPixel>> findMarkers(const Frame &frame, const MarkerLayout &layout,
                                             const MarkerSearch &search)
{
    const std::string what = "the floor markers cannot be found";
    if (frame.y.data == nullptr || frame.y.width < leastPictureSide || frame.y.height < leastPictureSide)
        return fail(ErrorCode::Undetermined, what, "the picture is too small", "use a picture of the camera");
    const auto tags = layoutTags(frame, layout, search);
    std::vector<MarkerPixel> markers;
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < layout.markers.size(); ++i) {
        const auto isIt = [&](const SeenTag &tag) { return tag.number == static_cast<int>(i); };
        const auto count = std::ranges::count_if(tags, isIt);
        if (count > 1)
            return fail(ErrorCode::Undetermined, what,
                        "tag " + std::to_string(i) + " (marker " + layout.markers[i].label + ") is seen " +
                            std::to_string(count) + " times",
                        "leave one of them on the floor");
        if (count == 0)
            missing.push_back(layout.markers[i].label);
        else
            markers.push_back({layout.markers[i].label, std::ranges::find_if(tags, isIt)->pixel});
    }
    if (markers.size() >= 4)
        return markers;
    const auto shapes = findRoundMarkers(frame);
    std::vector<MarkerPixel> hints = markers;
    for (const MarkerPixel &hint : search.hints) {
        if (std::ranges::find(hints, hint.label, &MarkerPixel::label) == hints.end())
            hints.push_back(hint);
    }
    if (shapes.size() + hints.size() < 4)
        return fail(ErrorCode::Undetermined, what,
                    std::to_string(markers.size()) + " of " + std::to_string(layout.markers.size()) +
                        " were found, four are needed" +
                        (missing.empty() ? "" : "; missing: " + listed(missing)),
                    "show the missing tags (AprilTag 36h11, numbered from 0 in the layout's order) or rings, "
                    "or mark the "
                    "markers by hand");
    const CameraModel camera = search.camera.value_or(CameraModel::assumed(frame.y.width, frame.y.height));
    const bool known = search.camera && search.intrinsicsKnown;
    auto assigned = assignMarkers(shapes, layout, camera, known, hints);
    if (!assigned)
        return assigned;
    return withTrueCentres(std::move(*assigned), shapes, layout, camera, known);
}

} // namespace odo
