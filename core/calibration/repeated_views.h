// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_detection.h"

#include <cstddef>
#include <vector>

namespace odo {

/// Whether an image shows the board in the same position as another one: a copy, the same image compressed
/// again, or another frame of a board held still. Then nine tenths of its corners are within 2 % of the
/// board's extent, and within a quarter of a square, of a corner of the other, and the board was tilted by
/// less than 8 degrees: tilts tell the focal length even where they move few pixels. A hand that holds a
/// board still moves it by some millimetres, as much as that; careful sets of real images have steps of 4 %
/// and more. Corners are matched by their pixels, since a board that is cut off, or looks the same when
/// turned, is not labelled the same in every frame. False where the corners lie as on no plane. Pure; any
/// thread.
bool repeatsPosition(const BoardView &view, const BoardView &other);

/// Images of a board by its positions.
struct BoardPositions
{
    std::vector<std::size_t> counting; ///< indices of the images that count, one a position, ascending
    std::vector<std::size_t> shownBy;  ///< of each image the one that counts for it: itself, if it counts

    std::size_t repeats() const { return shownBy.size() - counting.size(); }
};

/// Of images that show the board in the same position one counts. The others see the same corners of the
/// board through the same part of the lens, bent and blurred alike: what is wrong with them is wrong with it,
/// so they are no independent evidence, whatever their pixel noise. The one that counts has the most corners,
/// and of several such it is the first. Those that repeat it do not count, nor those that repeat these, nor
/// those that repeat these in turn: the frames of a hand that is not quite still. A board that moves slowly
/// on counts again after every third such step. Pure; any thread.
BoardPositions positionsIn(const std::vector<BoardView> &views);

} // namespace odo
