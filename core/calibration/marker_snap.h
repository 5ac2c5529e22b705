// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <Eigen/Core>

namespace odo {

/// What a click on a marker was taken for.
struct SnappedMarker
{
    enum class Kind {
        None,         ///< nothing found: the pixel is the click itself
        Tag,          ///< where the diagonals of an AprilTag cross
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
/// reachPx; a dot only where the click lies in it, a corner or a saddle by which is nearer. Thread-safe.
SnappedMarker snapToMarker(const Frame &frame, const Eigen::Vector2d &near, double reachPx = 20);

} // namespace odo
