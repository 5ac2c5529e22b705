// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/solid_choice.h"

#include "core/trajectory/axis_track.h"
#include "core/trajectory/body_direction.h"
#include "core/trajectory/coloured_part.h"
#include "core/trajectory/common_outlines.h"
#include "core/trajectory/level_fit.h"
#include "core/trajectory/reach_learning.h"
#include "core/trajectory/shape_estimation.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double worstLevelMisfit = 3; // beyond it the outlines are not those of one solid
constexpr double taper = 0.1, topShift = 0.15; // of guesses whose upper part sits to the front or to the rear

// What the same errors of all outlines (shadows at the foot, sides that look like the floor) leave of the place in a solid that is fitted to them, as a share of
// its length: known robots come back so (tests/workflow/tst_any_look). Across the heading most robots are alike on both sides.
constexpr double placeAlong = 0.008, placeAcross = 0.005;

using Axes = std::vector<std::vector<BodyAxis>>;

/// A box where each view saw it, with its axes.
struct PlacedSolid
{
    FoundSolid solid;
    Axes axes;
};

PlacedSolid placedSolid(const std::vector<ViewTrack> &views, const ShapeEstimate &estimate)
{
    Axes axes = trackAxis(views, estimate.shape);
    return {{estimate.shape, estimate.sigmaMiddleM, placeBody(views, estimate.shape, axes)}, std::move(axes)};
}

/// Lays a box or cylinder by another point of it, for which its front must be known: of a cylinder only its motion tells it.
void moveToReference(const std::vector<ViewTrack> &views, const Eigen::Vector2d &referenceM, PlacedSolid &placed)
{
    FoundSolid &solid = placed.solid;
    placed.axes = solid.shape.form == SolidShape::Form::Cylinder ? directionsOfMotion(views, solid.seen, placed.axes)
                                                                 : directedAxes(views, solid.seen, std::move(placed.axes));
    solid.shape = movedPlace(asLevels(solid.shape), referenceM);
    solid.seen = placeBody(views, solid.shape, placed.axes);
}

/// Whether most of what was found may be a silhouette of all of the robot: of one that is mostly seen in parts, the few that seem whole are parts as well.
bool areMostlyWhole(const std::vector<ViewTrack> &views)
{
    std::size_t found = 0, whole = 0;
    for (const ViewTrack &view : views) {
        for (const Observation &observation : view.observations) {
            found += observation.found;
            whole += observation.found && observation.score >= leastOutlineScore;
        }
    }
    return 2 * whole >= found;
}

bool haveSupport(const std::vector<ViewTrack> &views)
{
    return std::ranges::any_of(views, [](const ViewTrack &view) {
        return std::ranges::any_of(view.observations, [](const Observation &observation) { return !observation.supportPx.empty(); });
    });
}

/// What a box leaves unexplained, a solid of several levels may explain.
std::optional<LevelFit> bestLevels(const std::vector<CommonOutlines> &times, const std::vector<ViewTrack> &views, const RobotShape &told, const PlacedSolid &box)
{
    // A body that is nearly square does not tell its axis, but mostly moves along it.
    const Axes directed = directedAxes(views, box.solid.seen, box.axes), moved = directionsOfMotion(views, box.solid.seen, box.axes);
    const std::pair<const Axes *, LevelStart> starts[] = {{&directed, {taper, 0}}, {&moved, {taper, topShift}}, {&moved, {taper, -topShift}}};
    std::optional<LevelFit> best;
    for (const auto &[directions, start] : starts) {
        auto fit = fitLevels(times, views, *directions, box.solid.seen, box.solid.shape, told, start);
        if (fit && (!best || fit->misfit < best->misfit))
            best = std::move(fit);
    }
    return best;
}

std::optional<FoundSolid> findSolidOfLevels(const std::vector<ViewTrack> &views, const RobotShape &told, const PlacedSolid &box)
{
    const std::vector<CommonOutlines> times = levelTimes(views);
    const std::optional<LevelFit> best = bestLevels(times, views, told, box);
    const auto learned = best && best->misfit < worstLevelMisfit ? learnReach(times, *best, told) : std::nullopt;
    if (!learned)
        return std::nullopt;
    FoundSolid solid{movedPlace(best->shape, learned->middleM + told.referenceM), best->sigmaTopM * middleHeightM(best->shape) / best->shape.topM, {}};
    const SolidDoubt doubt{learned->outlines, best->lastingPx, std::hypot(learned->sigmaForwardM, placeAlong * best->shape.lengthM),
                           std::hypot(learned->sigmaLeftM, placeAcross * best->shape.lengthM)};
    solid.seen = placeBody(views, solid.shape, trackDirection(views, solid.shape, learned->outlines, best->poses), doubt);
    return solid;
}

} // namespace

std::optional<double> misfitOfOutlines(const std::vector<ViewTrack> &views, const RobotShape &told)
{
    if (!haveSupport(views) || !areMostlyWhole(views))
        return std::nullopt;
    const auto guess = estimateShape(views, {});
    const auto levels = guess ? bestLevels(levelTimes(views), views, told, placedSolid(views, *guess)) : std::nullopt;
    return levels ? std::optional(levels->misfit) : std::nullopt;
}

double explainedShare(const std::vector<ViewTrack> &views, const RobotShape &told)
{
    if (told.heightM && isMarkAtTop(views, *told.heightM)) // which goes without a solid
        return 1;
    const auto solid = findSolid(views, told);
    double all = 0, explained = 0;
    for (std::size_t v = 0; solid && v < solid->seen.size(); ++v) {
        for (const Sighting &sighting : solid->seen[v]) {
            all += sighting.seen && !sighting.cut;
            explained += sighting.seen && !sighting.cut && sighting.score > 0;
        }
    }
    return all > 0 ? explained / all : 0;
}

std::optional<FoundSolid> findSolid(const std::vector<ViewTrack> &views, const RobotShape &told)
{
    if (haveSupport(views)) {
        if (!areMostlyWhole(views))
            return std::nullopt;
        // A box that is only where the search begins need not have the size of the robot's whole outline.
        const auto guess = estimateShape(views, {});
        if (auto levels = guess ? findSolidOfLevels(views, told, placedSolid(views, *guess)) : std::nullopt)
            return levels;
    }
    const auto box = estimateShape(views, told);
    if (!box || box->misfit > worstShapeMisfit)
        return std::nullopt;
    PlacedSolid placed = placedSolid(views, *box);
    if (!told.referenceM.isZero())
        moveToReference(views, told.referenceM, placed);
    return std::move(placed.solid);
}

} // namespace odo
