// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/lens_fit.h"

namespace odo {

/// Indices of corners, a list for each view, ascending.
using CornerMarks = std::vector<std::vector<std::size_t>>;

/// The corners that stand out from a fit of their lens: farther from their place than 5 σ (and 0.1 px), with σ from the
/// median distance (of normal errors one corner in 270 000 is so far). Where the fit shows any, it is made again with
/// Cauchy's loss, so that they cannot bend it, and the corners are judged by that. Empty lists where none stands out.
CornerMarks outlyingCorners(const std::vector<BoardView> &views, const LensFit &fit, const JobControl &control);

/// Of the marks those that stand alone. Three or more near one another (two squares) that are moved the same way are no
/// misread corners but say something of the picture or the board (bent, cut, covered), which a person has to look at. So
/// does a view that would keep fewer than six.
CornerMarks singleCorners(const std::vector<BoardView> &views, const LensFit &fit, const CornerMarks &marks);

std::size_t countOf(const CornerMarks &marks);

/// The views without the corners marked.
std::vector<BoardView> withoutCorners(const std::vector<BoardView> &views, const CornerMarks &marks);

} // namespace odo
