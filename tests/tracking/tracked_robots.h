// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/colour_tracker.h"

#include <QtGlobal>
#include <algorithm>

/// What the tests of the colour tracker share: colours, a tracker, and the errors of a run.
namespace odo::test {

inline constexpr RgbColour red{214, 40, 34}, blue{30, 90, 200}, green{40, 160, 60}, floorGrey{150, 146, 138};

inline std::unique_ptr<ColourTracker> trackerOf(std::vector<TrackTarget> targets)
{
    auto tracker = ColourTracker::create(std::move(targets));
    if (!tracker)
        qFatal("%s", tracker.error().message().c_str());
    return std::move(*tracker);
}

/// Figures of one run of a single robot.
struct Errors
{
    int frames = 0, found = 0;
    double sum = 0, worst = 0, leastScore = 1;

    void add(const Observation &seen, const Eigen::Vector2d &truth)
    {
        ++frames;
        if (!seen.found)
            return;
        ++found;
        const double error = (seen.ellipse.centrePx - truth).norm();
        sum += error;
        worst = std::max(worst, error);
        leastScore = std::min(leastScore, seen.score);
    }
    double mean() const { return sum / std::max(found, 1); }
};

} // namespace odo::test
