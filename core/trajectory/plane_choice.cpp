// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/plane_choice.h"

#include "core/trajectory/coloured_part.h"
#include "core/trajectory/height_estimation.h"
#include "core/trajectory/view_interpolation.h"

namespace odo {

namespace {

// A told height is that of the top; where the colour ends is known less well.
constexpr double toldPlaneSigmaM = 0.002;
// A robot of unknown height seen by one view is taken to lie on the floor; most are less than 120 mm high.
constexpr double unknownPlaneSigmaM = 0.03;

} // namespace

std::vector<std::vector<Sighting>> lookFromAllViews(const std::vector<ViewTrack> &views,
                                                    const std::vector<Nanoseconds> &times, double planeM)
{
    std::vector<std::vector<Sighting>> all;
    for (const ViewTrack &view : views)
        all.push_back(view.floorView ? sightingsAt(times, placeObservations(view, planeM))
                                     : std::vector<Sighting>(times.size()));
    return all;
}

PlaneChoice choosePlane(const std::vector<ViewTrack> &views, const std::vector<Nanoseconds> &times,
                        const RobotShape &shape)
{
    if (shape.heightM) {
        const bool mark = isMarkAtTop(views, *shape.heightM);
        return {mark ? *shape.heightM : silhouettePlaneM(*shape.heightM), toldPlaneSigmaM, *shape.heightM,
                false};
    }
    if (const auto estimate = estimatePlane(lookFromAllViews(views, times, 0))) {
        const bool mark = isMarkAtTop(views, estimate->planeM);
        return {estimate->planeM, estimate->sigmaM, mark ? estimate->planeM : 2 * estimate->planeM, true};
    }
    return {0, unknownPlaneSigmaM, 0, false};
}

} // namespace odo
