// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/outline_memory.h"
#include "core/tracking/region_measure.h"
#include "core/tracking/tracked_frame.h"

#include <optional>

namespace odo {

/// What is known of a robot before it is looked at.
struct ExpectedOutline
{
    Eigen::Vector2d motionPx; ///< since the last frame
    double wholeAreaPx = 0;   ///< of all of it, where only a part was seen of late
};

/// The outline of one robot from frame to frame: fitted where it can be, and set beside the one before.
class RobotOutline
{
public:
    void reset();
    /// Gives the shape the area, the place and the moments of the outline, and tells how far to trust it (0
    /// to 1). The shape stays as it is, and nothing is told, where no outline can be fitted, or where the
    /// robot is not convex as a rule: then its hull is not its outline.
    std::optional<double> refine(const TrackedFrame &frame, const RegionMask &mask,
                                 const ExpectedOutline &expected, RegionShape &shape);

private:
    bool fit(const TrackedFrame &frame, const RegionMask &mask, const OutlineHint &hint);

    OutlineFit m_fit;
    OutlineMemory m_memory;
    Outline m_outline;
    double m_solidity = -1; ///< running mean; below 0 before the first
};

} // namespace odo
