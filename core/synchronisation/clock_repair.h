// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace odo {

/// A moment at which a clip's time stamps go on too early (frames were lost, or the camera paused) or too
/// late (frames were doubled, or the clock jumped).
struct ClockStep
{
    double afterS = 0;    ///< own time as stamped; what is stamped later is off
    double lengthS = 0;   ///< that is added to those times, or taken off where it is negative
    double sigmaS = 0;    ///< of the length
    double squeezedS = 0; ///< where it is negative: the time before it that is not one, as of doubled frames
};

/// What makes a clip's time stamps even again.
struct ClockRepair
{
    std::vector<ClockStep> steps; ///< in order

    /// The repaired time of a stamped one.
    double timeS(double stampedS) const
    {
        double addedS = 0;
        for (const ClockStep &step : steps) {
            if (stampedS > step.afterS)
                addedS += step.lengthS;
            else if (const double intoS = stampedS - step.afterS + step.squeezedS;
                     step.squeezedS > 0 && intoS > 0)
                addedS += step.lengthS * intoS / step.squeezedS * squeeze;
        }
        return stampedS + addedS;
    }

private:
    static constexpr double squeeze = 0.999; ///< so that times still increase
};

} // namespace odo
