// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/floor_view.h"
#include "core/video/frame.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace odo {

/// The part of the floor on which motion counts: a rectangle along the world's axes, metres.
using FloorArea = Eigen::AlignedBox2d;

/// That of a layout's markers, with a margin of 0.2 m around them.
FloorArea watchedArea(const MarkerLayout &layout);

/// Whether something moved on the floor, as one camera saw it.
struct MotionSight
{
    Nanoseconds time{0}; ///< when the frame was taken
    bool moves = false;
};

/// Whether something moves on the floor before a registered camera, by its frames alone: no robot need be
/// known.
///
/// The luma of each frame is averaged in cells of some pixels whose centre is on the watched floor, and
/// compared with the frame `lag` before, after the light of all cells was equalised. A cell has changed where
/// it differs by more than six standard deviations of all cells (1.4826 times their median absolute
/// difference: Rousseeuw and Croux 1993), and by three levels at least. Something moves where three changed
/// cells have changed neighbours, in two frames in a row: a glitch of one frame is no motion. Where more than
/// half of the floor changes it is the light.
///
/// What stands up from the floor counts where its image covers the watched floor. Not thread-safe; a frame of
/// 1280×720 takes some tenths of a millisecond.
class FloorMotion
{
public:
    /// What moves is seen for so long after it has stopped.
    static constexpr Nanoseconds lag = std::chrono::milliseconds(150);

    FloorMotion(FloorView view, FloorArea area);

    /// The next frame, and when it was taken. nullopt: there is no earlier one to compare with, the light
    /// changed, or the frame has another size than the registration.
    std::optional<MotionSight> add(const Frame &frame, Nanoseconds taken);

    std::size_t cellCount() const { return m_cells.size(); }

private:
    struct Cell
    {
        int x0, y0; ///< its first pixel
        int index;  ///< in the grid of all cells
    };
    struct Past
    {
        Nanoseconds taken;
        std::vector<float> means; ///< of each cell
    };
    std::vector<float> meansOf(const PlaneView &luma) const;
    std::optional<bool> differs(const std::vector<float> &now, const std::vector<float> &before) const;
    std::size_t changedWithNeighbours(const std::vector<std::uint8_t> &changed) const;

    const FloorView m_view;
    int m_cellPx = 0, m_columns = 0, m_rows = 0;
    std::vector<Cell> m_cells; ///< on the watched floor
    std::deque<Past> m_past;   ///< the last ones, from `lag` ago on
    bool m_differed = false;   ///< the frame before
};

} // namespace odo
