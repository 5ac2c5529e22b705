// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace odo {

/// Corners of an area of a frame in their order, luma pixels of upright frames; the last is joined to the
/// first. Where it crosses itself it is inside as even-odd counts.
using PixelPolygon = std::vector<Eigen::Vector2d>;

/// Where in the frames of a view robots are searched, as a person gives it: what is outside is no evidence.
struct SearchedArea
{
    std::vector<PixelPolygon> search; ///< within any of them; none: in the whole frame
    std::vector<PixelPolygon> ignored;

    bool isWholeFrame() const { return search.empty() && ignored.empty(); }
    bool operator==(const SearchedArea &) const = default;
};

/// Whether a pixel is inside. Pure.
bool isWithin(const PixelPolygon &polygon, const Eigen::Vector2d &pixel);

/// As it is noted with what was tracked by it; empty for a whole frame. Pure.
std::string noteOf(const SearchedArea &area);
/// That part of a longer note, of notes that each begin with "; ". Pure.
std::string areaNoteIn(const std::string &note);

} // namespace odo
