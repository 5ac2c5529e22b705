// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/positioned_robot.h"

#include "core/trajectory/internal/free_height.h"
#include "core/trajectory/internal/height_estimation.h"
#include "core/trajectory/internal/track_profile.h"
#include "core/trajectory/internal/view_alignment.h"
#include "core/trajectory/solid_choice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

// Where the height is triangulated in every frame.
constexpr double freePlaneSigmaM = 0.002;
// A ruler's: both of its ends are read to the nearest millimetre, 1 mm/√12 each.
constexpr double givenHeightSigmaM = 0.00041;
// Pixel noise alone moves the height of a frame by some millimetres.
constexpr double leastScatterM = 0.02;

bool areSilhouettes(const std::vector<ViewTrack> &views)
{
    return std::ranges::any_of(views, [](const ViewTrack &view) {
        return std::ranges::any_of(view.observations,
                                   [](const Observation &one) { return !one.supportPx.empty(); });
    });
}

/// Sightings on one plane. Where the views show that the point strays from it (a person's head, a wrong
/// height given), each ray is trusted less along its own direction: two views then determine the position by
/// their bearings.
std::vector<std::vector<Sighting>> lookAtPlane(const std::vector<ViewTrack> &views,
                                               const std::vector<Nanoseconds> &times, double planeM,
                                               bool &strays)
{
    auto sightings = viewFromAllSides(views, times, planeM);
    const double scatterM = heightScatterM(viewFromAllSides(views, times, 0), planeM);
    if (scatterM < leastScatterM)
        return sightings;
    strays = !areSilhouettes(views);
    for (auto &view : sightings) {
        for (Sighting &sighting : view) {
            const Eigen::Vector2d shift = scatterM * sighting.position.displacementPerMetreHeight;
            if (sighting.seen)
                sighting.position.calibrationCovariance += shift * shift.transpose();
        }
    }
    return sightings;
}

/// The outlines are a solid's silhouettes: each gives the floor position of that solid.
std::optional<PositionedRobot> positionSolid(const std::vector<ViewTrack> &views,
                                             const std::vector<Nanoseconds> &times, const RobotShape &given,
                                             std::optional<FoundSolid> solid)
{
    if (!solid)
        return std::nullopt;
    PositionedRobot placed;
    for (std::size_t v = 0; v < views.size(); ++v) {
        placed.views.push_back(views[v].floorView ? sightingsAt(times, solid->seen[v])
                                                  : std::vector<Sighting>(times.size()));
        solid->seen[v] = {};
    }
    const double ofTop =
        given.heightM ? givenHeightSigmaM * middleHeightM(solid->shape) / solid->shape.topM : 0;
    placed.planeM = middleHeightM(solid->shape);
    placed.planeSigmaM = std::hypot(ofTop, solid->sigmaMiddleM);
    placed.heightM = solid->shape.topM;
    placed.estimated = !given.heightM;
    placed.clearanceM = solid->shape.baseM;
    placed.isPlainAndRight = solid->isPlainAndRight;
    placed.headings = std::move(solid->headings);
    return placed;
}

/// Whole silhouettes that no solid explains show now one part of the robot and now another (it looks like the
/// floor, or like its shadow): the position in them is hardly better known than they are large.
void uncertaintyUnexplained(const std::vector<ViewTrack> &views,
                            std::vector<std::vector<Sighting>> &sightings)
{
    constexpr double shareOfRadius = 0.7;
    for (std::size_t v = 0; v < views.size(); ++v) {
        double largestPx = 0;
        for (const Observation &observation : views[v].observations)
            if (observation.found && !observation.supportPx.empty())
                largestPx = std::max(largestPx, observation.areaPx);
        if (largestPx == 0 || !views[v].floorView)
            continue;
        const double radiusPx = std::sqrt(largestPx / std::numbers::pi);
        const Eigen::Vector3d camera = views[v].floorView->cameraInWorld();
        const double focalPx = views[v].floorView->camera().intrinsics().fxPx;
        for (Sighting &sighting : sightings[v]) {
            const Eigen::Vector2d &position = sighting.position.pointInWorld;
            const double awayM = (camera - Eigen::Vector3d(position.x(), position.y(), 0)).norm(),
                         uncertaintyM = shareOfRadius * radiusPx * awayM / focalPx;
            sighting.position.calibrationCovariance +=
                Eigen::Matrix2d::Identity() * uncertaintyM * uncertaintyM;
        }
    }
}

/// One height for the whole run: given, or estimated from the views, or (from one view alone) unknown.
Result<PositionedRobot> positionAtOneHeight(const std::vector<ViewTrack> &views,
                                            const std::vector<Nanoseconds> &times, const RobotShape &shape)
{
    const bool markShown = shape.heightM && isMarkAtTop(views, *shape.heightM);
    if (!markShown) {
        if (auto solid = positionSolid(views, times, shape, findSolid(views, shape)))
            return std::move(*solid);
    }
    if (!shape.referenceM.isZero())
        return fail(
            ErrorCode::Undetermined, cannotMeasurePath(),
            ODO_TEXT("trajectory.heading_unknown", "its reference point is not the centre of its footprint, "
                                                   "but its outlines do not show its heading"),
            ODO_TEXT("trajectory.centre_reference", "set its reference point to 0,0 and track again"));
    const PlaneChoice plane = choosePlane(views, times, shape);
    const bool known = plane.heightM > 0;
    bool strays = false;
    PositionedRobot placed{known ? lookAtPlane(views, times, plane.planeM, strays)
                                 : viewFromAllSides(views, times, 0),
                           known ? plane.planeM : 0,
                           plane.sigmaM,
                           plane.heightM,
                           plane.estimated,
                           {}};
    placed.strays = strays;
    uncertaintyUnexplained(views, placed.views);
    return placed;
}

} // namespace

std::vector<Nanoseconds> timesOf(const ViewTrack &view)
{
    std::vector<Nanoseconds> times;
    for (const Observation &observation : view.observations)
        times.push_back(timeOf(view, observation));
    return times;
}

Result<PositionedRobot> positionRobot(const std::vector<ViewTrack> &views,
                                      const std::vector<Nanoseconds> &times, const RobotShape &shape)
{
    if (!shape.heightVaries)
        return positionAtOneHeight(views, times, shape);
    auto placed = freeHeight(viewFromAllSides(views, times, 0));
    if (!placed)
        return fail(ErrorCode::Undetermined, cannotMeasurePath(),
                    ODO_TEXT("trajectory.seldom_together", "its height is set to be triangulated, but two "
                                                           "registered views rarely saw it at the same time"),
                    ODO_TEXT("trajectory.add_view", "add a second view, or set one height for the robot"));
    return PositionedRobot{std::move(placed->views), 0, freePlaneSigmaM, placed->medianHeightM, true, {}};
}

std::optional<PositionedRobot> positionPlainSolid(const std::vector<ViewTrack> &views,
                                                  const std::vector<Nanoseconds> &times,
                                                  const RobotShape &shape)
{
    if (!areSilhouettes(views))
        return std::nullopt;
    return positionSolid(views, times, shape, findPlainSolid(views, shape));
}

} // namespace odo
