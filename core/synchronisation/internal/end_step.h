// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/step_fit.h"

#include <optional>

namespace odo {

/// A lag that holds for one end of the tracks only.
struct EndStep
{
    double atS = 0;       ///< of the second clip, as repaired, by the first's pace
    double changeS = 0;   ///< of the lag of what lies beyond
    bool isBegin = false; ///< it holds before that moment; otherwise behind it
};

/// Where the tracks are far apart at one end, which no small change of a lag explains: the lag at which they
/// lie on one another there, if there is one. A long course of lags does not pay for so short a piece that
/// lies behind a long pause. Shift and scale are those of the relation. Pure.
std::optional<EndStep> stepNearEnd(const std::vector<TimedPosition> &first,
                                   const std::vector<TimedPosition> &second, const SteppedClocks &clocks,
                                   bool withRate);

} // namespace odo
