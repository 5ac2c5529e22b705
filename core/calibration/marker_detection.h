// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/camera_model.h"
#include "core/video/frame.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace odo {

/// What is known before detecting the markers.
struct MarkerSearch
{
    std::optional<CameraModel> camera; ///< of the frame's size; without it one free of distortion is assumed
    bool intrinsicsKnown = false;      ///< the camera's focal length is to be relied on
    /// Markers marked by hand; a pixel within 20 px of a shape means that shape.
    std::vector<MarkerPixel> hints;
};

/// Finds the floor markers of a layout in an image, in the layout's order. First tags: those of the numbers
/// in the labels, of any family, where the labels are numbers, or else AprilTags 36h11 with the label's index
/// in the layout (first marker: tag 0, ...); see findLayoutTags() in layout_tags.h; corners of a
/// ChArUco board where labels name them (boardCorner() in layout_board.h). Where fewer than four of
/// them are seen, rings and dots as well, named by assignMarkers(). The pixel is the image of the marker's
/// middle, not the middle of its image. Error Undetermined, naming how many of how many were found, when
/// fewer than four are seen, and as findLayoutTags and assignMarkers; where they are found in the mirrored
/// image, it says that instead.
Result<std::vector<MarkerPixel>> findMarkers(const Frame &frame, const MarkerLayout &layout,
                                             const MarkerSearch &search = {});

/// What a click on a marker hit.
struct SnappedMarker
{
    enum class Kind {
        None,         ///< nothing found: the pixel is the click itself
        Tag,          ///< where the diagonals of an AprilTag or ArUco tag cross
        Ring,         ///< middle of a ring, corrected for perspective
        Dot,          ///< middle of a dot's ellipse; registering corrects it (dotCentre in dot_centre.h)
        TapeCrossing, ///< where the middles of two strips of tape cross (or one ends upon the other)
        TapeCorner,   ///< where two straight edges meet: corner of tape, of a tile, of a sheet
        Saddle,       ///< where four fields meet, dark and bright by turns
    } kind = Kind::None;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); ///< luma pixels
    double sigmaPx = 0; ///< of one coordinate, from the edges' own scatter; a click: 1
};

/// Moves a click to the marker that was meant: the first of the kinds above of which there is one within
/// reachPx; a dot only where the click lies in it, an ArUco tag likewise, a corner or a saddle by which is
/// nearer. Thread-safe.
SnappedMarker snapToMarker(const Frame &frame, const Eigen::Vector2d &near, double reachPx = 20);

} // namespace odo
