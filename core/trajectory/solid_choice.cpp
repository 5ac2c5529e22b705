// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/solid_choice.h"

#include "core/trajectory/axis_track.h"
#include "core/trajectory/body_direction.h"
#include "core/trajectory/level_fit.h"
#include "core/trajectory/shape_estimation.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double simpleEnough = 1.5; // misfit of a box that needs no other solid
constexpr double clearlyLess = 0.9; // of a box's misfit
constexpr double taper = 0.1, topShift = 0.15; // of guesses whose upper part sits to the front or to the rear

// What the same errors of all outlines (shadows at the foot, sides that look like the floor) leave of the place in a solid that is fitted to them, as a share of
// its length: known robots come back so (tests/workflow/tst_any_look). Across the heading most robots are alike on both sides.
constexpr double placeAlong = 0.025, placeAcross = 0.005;

using Axes = std::vector<std::vector<BodyAxis>>;

struct StartedFit
{
    LevelFit fit;
    const Axes *directions = nullptr; ///< from which it began
};

/// By how much the other fit puts the robot elsewhere throughout, along and across its heading.
Eigen::Vector2d meanShift(const LevelFit &fit, const LevelFit &other)
{
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double count = 0;
    for (const BodyPose &pose : fit.poses) {
        const auto same = std::ranges::lower_bound(other.poses, pose.time, {}, &BodyPose::time);
        if (same == other.poses.end() || same->time != pose.time)
            continue;
        const Eigen::Vector2d forward(std::cos(pose.headingRad), std::sin(pose.headingRad)), shift = same->place - pose.place;
        sum += Eigen::Vector2d(shift.dot(forward), shift.dot(Eigen::Vector2d(-forward.y(), forward.x())));
        count += 1;
    }
    return count > 0 ? Eigen::Vector2d(sum / count) : Eigen::Vector2d(Eigen::Vector2d::Zero());
}

/// What the fits say together: each counts by how well it explains the outlines. Outlines have errors that last over a run, so that they tell the fits
/// apart no better than so many independent figures would.
struct Consensus
{
    Eigen::Vector2d shift = Eigen::Vector2d::Zero(); ///< of the place from that of the best fit, along and across its heading
    SolidDoubt doubt;
};

Consensus consensusOf(const LevelFit &best, const std::vector<StartedFit> &all)
{
    constexpr double independentFigures = 20;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero(), squares = Eigen::Vector2d::Zero();
    double weights = 0;
    for (const StartedFit &one : all) {
        const double ratio = one.fit.misfit / best.misfit;
        const double weight = std::exp(-0.5 * independentFigures * (ratio * ratio - 1));
        const Eigen::Vector2d shift = meanShift(best, one.fit);
        sum += weight * shift;
        squares += weight * shift.cwiseAbs2();
        weights += weight;
    }
    Consensus consensus;
    consensus.shift = sum / weights;
    const Eigen::Vector2d variance = squares / weights - consensus.shift.cwiseAbs2();
    const auto sigma = [](double ofFit, double amongFits, double leastM) { return std::sqrt(ofFit * ofFit + std::max(0.0, amongFits) + leastM * leastM); };
    consensus.doubt = {best.lastingPx, sigma(best.sigmaForwardM, variance.x(), placeAlong * best.shape.lengthM),
                       sigma(best.sigmaLeftM, variance.y(), placeAcross * best.shape.lengthM)};
    return consensus;
}

/// The same solid, told to stand at another place in it.
SolidShape movedPlace(SolidShape shape, const Eigen::Vector2d &shift)
{
    for (SolidLevel &level : shape.levels) {
        level.frontM -= shift.x();
        level.backM += shift.x();
        level.leftM -= shift.y();
        level.rightM += shift.y();
    }
    return shape;
}

/// What a box leaves unexplained, a solid of several levels may explain.
bool takeSolidOfLevels(const std::vector<ViewTrack> &views, const RobotShape &told, const Axes &axes, double boxMisfit, FoundSolid &solid)
{
    // A body that is nearly square does not tell its axis, but mostly moves along it.
    const Axes directed = directedAxes(views, solid.seen, axes), moved = directionsOfMotion(views, solid.seen, axes);
    const std::pair<const Axes *, LevelStart> starts[] = {{&directed, {}}, {&moved, {}}, {&moved, {taper, topShift}}, {&moved, {taper, -topShift}}};
    const std::vector<CommonOutlines> times = levelTimes(views);
    std::vector<StartedFit> fits;
    for (const auto &[directions, start] : starts) {
        if (auto fit = fitLevels(times, views, *directions, solid.shape, told, start))
            fits.push_back({std::move(*fit), directions});
    }
    const auto best = std::ranges::min_element(fits, {}, [](const StartedFit &one) { return one.fit.misfit; });
    if (best == fits.end() || best->fit.misfit > std::min(worstShapeMisfit, clearlyLess * boxMisfit))
        return false;
    const Consensus consensus = consensusOf(best->fit, fits);
    solid.shape = movedPlace(best->fit.shape, consensus.shift);
    solid.sigmaTopM = best->fit.sigmaTopM;
    solid.seen = placeBody(views, solid.shape, refineDirections(views, solid.shape, *best->directions), consensus.doubt);
    return true;
}

} // namespace

std::optional<FoundSolid> findSolid(const std::vector<ViewTrack> &views, const RobotShape &told)
{
    const auto box = estimateShape(views, told);
    if (!box)
        return std::nullopt;
    const Axes axes = trackAxis(views, box->shape);
    FoundSolid solid{box->shape, box->sigmaTopM, placeBody(views, box->shape, axes)};
    const bool hasLevels = told.anyLook && box->misfit > simpleEnough && takeSolidOfLevels(views, told, axes, box->misfit, solid);
    return hasLevels || box->misfit <= worstShapeMisfit ? std::optional(std::move(solid)) : std::nullopt;
}

} // namespace odo
