// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/marker_detection.h"

#include "core/calibration/floor_registration.h"
#include "core/calibration/marker_assignment.h"
#include "core/calibration/round_markers.h"
#include "core/calibration/wording.h"

extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
}

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr float leastMargin = 25; // of libapriltag's decision: beneath it come the tags read out of noise
constexpr int mostMendedBits = 1;
constexpr int leastSidePx = 32;

/// Where the diagonals cross, the picture of the tag's middle under perspective, unlike the mean of the
/// corners. libapriltag counts from the corner of the first pixel, we from its centre.
Vector2d centreOf(const apriltag_detection_t &tag)
{
    const auto corner = [&](int i) { return Eigen::Vector3d(tag.p[i][0], tag.p[i][1], 1); };
    const Eigen::Vector3d one = corner(0).cross(corner(2)), other = corner(1).cross(corner(3));
    return Vector2d(one.cross(other).hnormalized()) - Vector2d(0.5, 0.5);
}

/// Dots' middles are corrected by a first pose, which is off by less than they are.
std::vector<MarkerPixel> withTrueCentres(std::vector<MarkerPixel> markers, const std::vector<RoundMarker> &shapes,
                                         const MarkerLayout &layout, const CameraModel &camera, bool intrinsicsKnown)
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

} // namespace

std::vector<SeenTag> findTags(const Frame &frame, std::optional<PixelRect> part)
{
    const PixelRect all{0, 0, frame.y.width, frame.y.height};
    const PixelRect rect = part ? part->clipped(all) : all;
    if (frame.y.data == nullptr || rect.width() < leastSidePx || rect.height() < leastSidePx)
        return {};
    // Undecimated and unsmoothed, the detector only reads this.
    image_u8_t picture{rect.width(), rect.height(), static_cast<int>(frame.y.stride),
                       const_cast<std::uint8_t *>(frame.y.row(rect.y0) + rect.x0)};
    const std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t *)> family(tag36h11_create(),
                                                                                   tag36h11_destroy);
    const std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t *)> detector(
        apriltag_detector_create(), apriltag_detector_destroy);
    apriltag_detector_add_family_bits(detector.get(), family.get(), mostMendedBits);
    detector->quad_decimate = 1; // a registration is made once; small tags matter more than milliseconds
    detector->quad_sigma = 0;
    detector->refine_edges = true;
    zarray_t *found = apriltag_detector_detect(detector.get(), &picture);
    std::vector<SeenTag> tags;
    for (int i = 0; i < zarray_size(found); ++i) {
        apriltag_detection_t *tag = nullptr;
        zarray_get(found, i, static_cast<void *>(&tag));
        if (tag->decision_margin >= leastMargin)
            tags.push_back({tag->id, centreOf(*tag) + Vector2d(rect.x0, rect.y0)});
    }
    apriltag_detections_destroy(found);
    return tags;
}

Result<std::vector<MarkerPixel>> findMarkers(const Frame &frame, const MarkerLayout &layout, const MarkerSearch &search)
{
    const std::string what = "the floor markers cannot be found";
    if (frame.y.data == nullptr || frame.y.width < leastSidePx || frame.y.height < leastSidePx)
        return fail(ErrorCode::Undetermined, what, "the picture is too small", "use a picture of the camera");
    const auto tags = findTags(frame);
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
        return fail(
            ErrorCode::Undetermined, what,
            std::to_string(markers.size()) + " of " + std::to_string(layout.markers.size()) +
                " were found, four are needed" + (missing.empty() ? "" : "; missing: " + listed(missing)),
            "show the missing tags (AprilTag 36h11, numbered from 0 in the layout's order) or rings, or mark the "
            "markers by hand");
    const CameraModel camera = search.camera.value_or(CameraModel::assumed(frame.y.width, frame.y.height));
    const bool known = search.camera && search.intrinsicsKnown;
    auto assigned = assignMarkers(shapes, layout, camera, known, hints);
    if (!assigned)
        return assigned;
    return withTrueCentres(std::move(*assigned), shapes, layout, camera, known);
}

} // namespace odo
