// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/coloured_part.h"

#include "core/base/upper_median.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace odo {

namespace {

constexpr double markShare = 0.5; // of the span from foot to top; a body covers all of it and more

/// The outline's length along the picture of a vertical from the floor to heightM, as a share of that
/// vertical.
std::optional<double> verticalShare(const FloorView &view, const Ellipse &ellipse, double heightM)
{
    const auto place = view.floorFromPixel(ellipse.centrePx, heightM);
    if (!place)
        return std::nullopt;
    const auto foot = view.pixelFromWorld({place->x(), place->y(), 0});
    const auto top = view.pixelFromWorld({place->x(), place->y(), heightM});
    if (!foot || !top)
        return std::nullopt;
    const Eigen::Vector2d span = *top - *foot;
    if (span.norm() < 1)
        return std::nullopt; // seen from straight above: nothing can be told
    const double angle = std::atan2(span.y(), span.x()) - ellipse.angleRad;
    const double extent =
        2 * std::hypot(ellipse.semiMajorPx * std::cos(angle), ellipse.semiMinorPx * std::sin(angle));
    return extent / span.norm();
}

} // namespace

bool isMarkAtTop(const std::vector<ViewTrack> &views, double heightM)
{
    std::vector<double> shares;
    for (const ViewTrack &view : views) {
        if (!view.floorView)
            continue;
        for (const Observation &observation : view.observations) {
            if (!observation.found || observation.touchesBorder)
                continue;
            if (const auto share = verticalShare(*view.floorView, observation.ellipse, heightM))
                shares.push_back(*share);
        }
    }
    if (shares.empty())
        return false;
    return upperMedian(std::move(shares)) < markShare;
}

} // namespace odo
