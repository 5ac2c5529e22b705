// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <cmath>

namespace odo {

/// How a view's own clock (zero at its first frame) lies against the first view's, on which all is told.
struct ViewClock
{
    Nanoseconds startOffset{0}; ///< how much later this view's first frame was taken than the first view's
    double rate = 0;            ///< by how much its clock runs faster: 2e-4 gains 0.2 ms a second

    /// Time of the first view's clock at a time of the own one; exact where the rates are equal.
    Nanoseconds commonTime(Nanoseconds own) const
    {
        const double gained = static_cast<double>(own.count()) * rate / (1 + rate);
        return startOffset + own - Nanoseconds(std::llround(gained));
    }
    /// The other way.
    Nanoseconds ownTime(Nanoseconds common) const
    {
        const Nanoseconds since = common - startOffset;
        return since + Nanoseconds(std::llround(static_cast<double>(since.count()) * rate));
    }
};

/// The clock of anything that has a start offset and a clock rate: ViewTrack, NamedView.
template <class View>
ViewClock clockOf(const View &view)
{
    return {view.startOffset, view.clockRate};
}

/// When, on the first view's clock, something stamped by the view's own clock was seen (an Observation).
template <class View, class Stamped>
Nanoseconds timeOf(const View &view, const Stamped &stamped)
{
    return clockOf(view).commonTime(stamped.time);
}

} // namespace odo
