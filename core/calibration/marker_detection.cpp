// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/marker_detection.h"

#include "core/calibration/floor_registration.h"
#include "core/calibration/internal/layout_board.h"
#include "core/calibration/internal/layout_tags.h"
#include "core/calibration/internal/marker_assignment.h"
#include "core/calibration/internal/round_markers.h"
#include "core/calibration/internal/wording.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr int leastImageSide = 32;

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

/// The luma of a frame, seen in a mirror.
Frame mirrored(const Frame &frame)
{
    auto buffer = std::make_shared<FrameBuffer>(frame.format);
    for (int y = 0; y < frame.y.height; ++y)
        std::reverse_copy(frame.y.row(y), frame.y.row(y) + frame.y.width, buffer->yRow(y));
    return FrameBuffer::toFrame(std::move(buffer), frame.index, frame.time);
}

/// Of an image in which the markers are not found: they are, once it is mirrored. A tag cannot be read as
/// another one in a mirror; of rings and dots all must fit.
std::optional<Error> mirroredMarkers(const Frame &frame, const MarkerLayout &layout,
                                     const MarkerSearch &search, const Message &what)
{
    const Frame mirror = mirrored(frame);
    const std::size_t ofLayout = countLayoutTags(mirror, layout);
    const Message flip = ODO_TEXT("calibration.flip_image",
                                  "switch off mirroring in the camera or its program, or flip the file");
    if (ofLayout >= 2)
        return Error{ErrorCode::Undetermined, what,
                     ODO_TEXT("calibration.tags_mirrored", "%1 tags were found, mirrored")(ofLayout), flip};
    const CameraModel camera = search.camera.value_or(CameraModel::assumed(frame.y.width, frame.y.height));
    const auto shapes = findRoundMarkers(mirror);
    const auto assigned = assignMarkers(shapes, layout, camera, search.camera && search.intrinsicsKnown, {});
    if (!assigned || assigned->size() < std::max<std::size_t>(5, layout.markers.size()))
        return std::nullopt;
    return Error{ErrorCode::Undetermined, what,
                 ODO_TEXT("calibration.rings_mirrored",
                          "%1 rings and dots fit the layout, mirrored")(assigned->size()),
                 flip};
}

Error tooFewMarkers(const LayoutTags &tags, const MarkerLayout &layout, const Message &what)
{
    return {ErrorCode::Undetermined, what,
            joined({ODO_TEXT("calibration.markers_found", "%1 of %2 were found, four are needed")(
                        tags.markers.size(), layout.markers.size()),
                    tags.missing.empty() ? Message()
                                         : ODO_TEXT("calibration.markers_missing", "missing: %1")(
                                               listed(tags.missing, MessageArgument::Kind::Marker))},
                   Join::Semicolon),
            tags.byPlace ? ODO_TEXT("calibration.show_missing_tags",
                                    "show the missing tags (AprilTag 36h11, numbered from 0 in the layout's "
                                    "order) or rings, or mark the markers by hand")
                         : ODO_TEXT("calibration.show_numbered_tags",
                                    "show the missing tags (of one family, with the numbers of the labels) "
                                    "or rings, or mark the markers by hand")};
}

/// Both in the layout's order.
void addMarkers(LayoutTags &tags, std::vector<MarkerPixel> others, const MarkerLayout &layout)
{
    for (MarkerPixel &marker : others) {
        std::erase(tags.missing, marker.label);
        tags.markers.push_back(std::move(marker));
    }
    std::ranges::stable_sort(tags.markers, {}, [&](const MarkerPixel &marker) {
        return std::ranges::find(layout.markers, marker.label, &Marker::label);
    });
}

} // namespace

Result<std::vector<MarkerPixel>> findMarkers(const Frame &frame, const MarkerLayout &layout,
                                             const MarkerSearch &search)
{
    const Message what = ODO_TEXT("calibration.markers_not_found", "the floor markers cannot be found");
    if (frame.y.data == nullptr || frame.y.width < leastImageSide || frame.y.height < leastImageSide)
        return fail(ErrorCode::Undetermined, what,
                    ODO_TEXT("calibration.picture_too_small", "the image is too small"), useCameraImage());
    auto tags = ODO_TRY(findLayoutTags(frame, layout, search));
    auto board = findBoardCorners(frame, layout);
    if (board)
        addMarkers(tags, std::move(*board), layout);
    if (tags.markers.size() >= 4)
        return std::move(tags.markers);
    if (!board)
        return fail(ErrorCode::Undetermined, what, board.error().why, board.error().advice);
    const auto shapes = findRoundMarkers(frame);
    std::vector<MarkerPixel> hints = tags.markers;
    for (const MarkerPixel &hint : search.hints) {
        if (std::ranges::find(hints, hint.label, &MarkerPixel::label) == hints.end())
            hints.push_back(hint);
    }
    if (shapes.size() + hints.size() < 4) {
        if (auto error = mirroredMarkers(frame, layout, search, what))
            return tl::unexpected(*error);
        return tl::unexpected(tooFewMarkers(tags, layout, what));
    }
    const CameraModel camera = search.camera.value_or(CameraModel::assumed(frame.y.width, frame.y.height));
    const bool known = search.camera && search.intrinsicsKnown;
    auto assigned = assignMarkers(shapes, layout, camera, known, hints);
    if (!assigned) {
        auto error = mirroredMarkers(frame, layout, search, what);
        return tl::unexpected(error ? *error : assigned.error());
    }
    return withTrueCentres(std::move(*assigned), shapes, layout, camera, known);
}

} // namespace odo
