// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/solid_choice.h"

#include "core/base/quiet_ceres.h"
#include "core/trajectory/internal/body_direction.h"
#include "core/trajectory/internal/body_heading.h"
#include "core/trajectory/internal/body_outline.h"
#include "core/trajectory/internal/height_estimation.h"
#include "core/trajectory/internal/level_fit.h"
#include "core/trajectory/internal/reach_learning.h"

#include <algorithm>
#include <array>
#include <ceres/ceres.h>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double worstLevelMisfit = 3;         // beyond it the outlines are not those of one solid
constexpr double taper = 0.1, topShift = 0.15; // of guesses whose upper part sits to the front or to the rear

// What the same errors of all outlines (shadows at the foot, sides that look like the floor) leave in the
// position of a solid that is fitted to them, as a share of its length: measured with known robots
// (tests/workflow/tst_any_look). Across the heading most robots are alike on both sides.
constexpr double positionAlong = 0.008, positionAcross = 0.005;

// A body whose middle is known so well has ends that are known alike: they turn it by that over a part of its
// length (measured with rendered robots before one and two cameras, tests/workflow/tst_turning_robots).
constexpr double headingArm = 1.0 / 3;

using Axes = std::vector<std::vector<BodyAxis>>;

/// A box where each view saw it, with its axes.
struct PositionedSolid
{
    FoundSolid solid;
    Axes axes;
    std::vector<MeasuredAxis> measured;
};

PositionedSolid positionedSolid(const std::vector<ViewTrack> &views, const ShapeEstimate &estimate)
{
    std::vector<MeasuredAxis> measured;
    Axes axes = trackAxis(views, estimate.shape, &measured);
    return {{estimate.shape, estimate.sigmaMiddleM, positionBody(views, estimate.shape, axes)},
            std::move(axes),
            std::move(measured)};
}

/// Positions a box or cylinder by another point of it, for which its front must be known: of a cylinder only
/// its motion shows it.
void moveToReference(const std::vector<ViewTrack> &views, const Eigen::Vector2d &referenceM,
                     PositionedSolid &placed)
{
    FoundSolid &solid = placed.solid;
    placed.axes = solid.shape.form == SolidShape::Form::Cylinder
                      ? directionsOfMotion(views, solid.seen, placed.axes)
                      : directedAxes(views, solid.seen, std::move(placed.axes));
    solid.shape = shiftedPosition(asLevels(solid.shape), referenceM);
    solid.seen = positionBody(views, solid.shape, placed.axes);
}

/// Whether most of what was found may be a silhouette of all of the robot: of one that is mostly seen in
/// parts, the few that seem whole are parts as well.
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
        return std::ranges::any_of(
            view.observations, [](const Observation &observation) { return !observation.supportPx.empty(); });
    });
}

/// What a box leaves unexplained, a solid of several levels may explain.
std::optional<LevelFit> bestLevels(const std::vector<CommonOutlines> &times,
                                   const std::vector<ViewTrack> &views, const RobotShape &given,
                                   const PositionedSolid &box)
{
    // A body that is nearly square does not show its axis, but mostly moves along it.
    const Axes directed = directedAxes(views, box.solid.seen, box.axes),
               moved = directionsOfMotion(views, box.solid.seen, box.axes);
    const std::pair<const Axes *, LevelStart> starts[] = {
        {&directed, {taper, 0}}, {&moved, {taper, topShift}}, {&moved, {taper, -topShift}}};
    std::optional<LevelFit> best;
    for (const auto &[directions, start] : starts) {
        auto fit = fitLevels(times, views, *directions, box.solid.seen, box.solid.shape, given, start);
        if (fit && (!best || fit->misfit < best->misfit))
            best = std::move(fit);
    }
    return best;
}

std::optional<FoundSolid> findSolidOfLevels(const std::vector<ViewTrack> &views, const RobotShape &given,
                                            const PositionedSolid &box)
{
    const std::vector<CommonOutlines> times = levelTimes(views);
    const std::optional<LevelFit> best = bestLevels(times, views, given, box);
    const auto learned =
        best && best->misfit < worstLevelMisfit ? learnReach(times, *best, given) : std::nullopt;
    if (!learned)
        return std::nullopt;
    FoundSolid solid{shiftedPosition(best->shape, learned->middleM + given.referenceM),
                     best->sigmaTopM * middleHeightM(best->shape) / best->shape.topM,
                     {}};
    const SolidUncertainty uncertainty{
        learned->outlines, best->lastingPx,
        std::hypot(learned->sigmaForwardM, positionAlong * best->shape.lengthM),
        std::hypot(learned->sigmaLeftM, positionAcross * best->shape.lengthM)};
    TrackedBody body{best->shape, given.lengthM && given.widthM};
    body.shapeSigmaRad =
        std::hypot(learned->sigmaForwardM, learned->sigmaLeftM) / (headingArm * best->shape.lengthM);
    body.axes = trackDirection(views, solid.shape, learned->outlines, best->poses, &body.measured);
    solid.seen = positionBody(views, solid.shape, body.axes, uncertainty);
    solid.headings = headingsOfBody(views, solid.seen, body);
    return solid;
}

} // namespace

std::optional<double> misfitOfOutlines(const std::vector<ViewTrack> &views, const RobotShape &given)
{
    if (!haveSupport(views) || !areMostlyWhole(views))
        return std::nullopt;
    const auto guess = estimateShape(views, {});
    const auto levels =
        guess ? bestLevels(levelTimes(views), views, given, positionedSolid(views, *guess)) : std::nullopt;
    return levels ? std::optional(levels->misfit) : std::nullopt;
}

double explainedShare(const std::vector<ViewTrack> &views, const RobotShape &given)
{
    if (given.heightM && isMarkAtTop(views, *given.heightM)) // which goes without a solid
        return 1;
    const auto solid = findSolid(views, given);
    double all = 0, explained = 0;
    for (std::size_t v = 0; solid && v < solid->seen.size(); ++v) {
        for (const Sighting &sighting : solid->seen[v]) {
            all += sighting.seen && !sighting.cut;
            explained += sighting.seen && !sighting.cut && sighting.score > 0;
        }
    }
    return all > 0 ? explained / all : 0;
}

std::optional<FoundSolid> findSolid(const std::vector<ViewTrack> &views, const RobotShape &given)
{
    if (haveSupport(views)) {
        if (!areMostlyWhole(views))
            return std::nullopt;
        // A box that is only where the search begins need not have the size of the robot's whole outline.
        const auto guess = estimateShape(views, {});
        if (auto levels =
                guess ? findSolidOfLevels(views, given, positionedSolid(views, *guess)) : std::nullopt)
            return levels;
    }
    return findPlainSolid(views, given);
}

std::optional<FoundSolid> findPlainSolid(const std::vector<ViewTrack> &views, const RobotShape &given)
{
    const auto box = estimateShape(views, given);
    if (!box || box->misfit > worstShapeMisfit)
        return std::nullopt;
    PositionedSolid placed = positionedSolid(views, *box);
    placed.solid.isPlainAndRight = box->misfit < 1;
    if (box->shape.form == SolidShape::Form::Box)
        placed.solid.headings =
            headingsOfBody(views, placed.solid.seen,
                           {box->shape, given.lengthM && given.widthM, placed.axes, placed.measured, 0});
    if (!given.referenceM.isZero())
        moveToReference(views, given.referenceM, placed);
    return std::move(placed.solid);
}

namespace {

constexpr std::size_t mostTimes = 30, leastShapeTimes = 5;
constexpr double independentTimes =
    4; // the outlines' errors repeat wherever the robot is seen from the same side
constexpr double positionSigmaPx =
    0.7; // of a centroid against the other views', the registration's error being in it
constexpr double goodMisfit = 1.5;
constexpr double impossible = 1e3; // a residual, where the solid would lie behind the camera
constexpr double guessM = 0.2, guessHeightM = 0.1;
// A simpler solid is taken unless another explains the outlines so much better.
constexpr double clearlyBetter = 0.7;
constexpr double firstBaseShare = 0.1; // where the search for a clearance begins
// of most classroom robots; it matters only where one view alone saw the robot, whose size is not given
constexpr double likelyClearanceM = 0.015;
constexpr double clearBaseGain = 2; // of χ²/2, by which a clearance of two of its σ is better than none
constexpr double leastKnownSigmaM = 0.02; // of the top: else the solid is one of many that look alike
constexpr double leastSizeM = 0.01, mostSizeM = 3;
constexpr int startAngles = 18;
constexpr double roundEnough = 1.1; // length over width of a given size up to which it may be a cylinder's

using Pose = std::array<double, 3>; // x, y, angle

/// What is varied: logarithms of length, width and top; the base as a share of the top.
using Form = std::array<double, 4>;
enum : int { LogLength, LogWidth, LogTop, BaseShare };

SolidShape solidOf(const double *form, SolidShape::Form kind)
{
    SolidShape solid;
    solid.form = kind;
    const auto sizeM = [form](int index) { return std::clamp(std::exp(form[index]), leastSizeM, mostSizeM); };
    solid.lengthM = sizeM(LogLength);
    solid.widthM = kind == SolidShape::Form::Cylinder ? solid.lengthM : sizeM(LogWidth);
    solid.topM = sizeM(LogTop);
    solid.baseM = solid.topM * std::min(form[BaseShare], 1.0); // derivatives at the floor look below it
    return solid;
}

/// One view's outline against the solid's silhouette (outlineDifferences).
struct OutlineResidual
{
    const CommonOutlines::Outline &outline;
    SolidShape::Form kind;

    bool operator()(const double *pose, const double *form, double *residual) const
    {
        const auto model = silhouetteMoments(*outline.view, solidOf(form, kind), {pose[0], pose[1]}, pose[2]);
        if (!model || model->areaPx2 < 1) {
            std::fill_n(residual, 6, impossible);
            return true;
        }
        Eigen::Map<OutlineDifferences> differences(residual);
        differences =
            outlineDifferences(outline.moments, *model, sigmaOfOutline(outline.moments), positionSigmaPx);
        return true;
    }
};

/// Keeps what nothing determines near what robots are like.
struct FormPrior
{
    Form expected;
    double likelyClearanceM;
    bool operator()(const double *form, double *residual) const
    {
        for (int i : {LogLength, LogWidth, LogTop})
            residual[i] = form[i] - expected[static_cast<std::size_t>(i)];
        residual[BaseShare] = form[BaseShare] * std::exp(form[LogTop]) / likelyClearanceM;
        return true;
    }
};

struct ShapeCandidate
{
    SolidShape::Form kind = SolidShape::Form::Box;
    Form form{};
    std::vector<int> constant; ///< indices of the form that stay
    double likelyClearanceM = HUGE_VAL;
};

struct ShapeFit
{
    SolidShape solid;
    Form form{};
    double misfit = HUGE_VAL, sigmaTopM = 0, sigmaMiddleM = 0;
    double cost = HUGE_VAL; ///< χ²/2 of the independent information of the outlines
};

/// The size a solid of the guessed height must have for its silhouette's area to be the one seen.
double guessedSizeM(const CommonOutlines::Outline &outline, double heightM)
{
    const SolidShape solid{SolidShape::Form::Box, guessM, guessM, 0, heightM};
    const auto position = outline.view->floorFromPixel(outline.moments.centrePx, heightM / 2);
    const auto model = position ? silhouetteMoments(*outline.view, solid, *position, 0) : std::nullopt;
    return model && model->areaPx2 > 0 ? guessM * std::sqrt(outline.moments.areaPx2 / model->areaPx2)
                                       : guessM;
}

/// Where the first view has the solid, turned as explains all views' outlines best.
Pose firstPose(const CommonOutlines &common, const SolidShape &solid)
{
    std::vector<OutlineMisfit> misfits;
    for (const CommonOutlines::Outline &outline : common.outlines) {
        if (auto misfit = OutlineMisfit::create(*outline.view, solid, outline.moments))
            misfits.push_back(std::move(*misfit));
    }
    const CommonOutlines::Outline &first = common.outlines.front();
    const Eigen::Vector2d position = first.view->floorFromPixel(first.moments.centrePx, middleHeightM(solid))
                                         .value_or(Eigen::Vector2d::Zero());
    Pose pose{position.x(), position.y(), 0};
    double leastCost = HUGE_VAL;
    for (int i = 0; i < startAngles; ++i) {
        const double angle = i * std::numbers::pi / startAngles;
        double cost = 0;
        for (const OutlineMisfit &misfit : misfits) {
            const auto residual = misfit.at(angle);
            cost += residual ? residual->squaredNorm() : impossible;
        }
        if (cost < leastCost) {
            pose[2] = angle;
            leastCost = cost;
        }
    }
    return pose;
}

std::optional<ShapeFit> fitSolid(const std::vector<CommonOutlines> &times, const ShapeCandidate &candidate)
{
    Form form = candidate.form;
    std::vector<Pose> poses;
    for (const CommonOutlines &common : times)
        poses.push_back(firstPose(common, solidOf(form.data(), candidate.kind)));

    ceres::Problem problem;
    std::size_t outlines = 0;
    for (const CommonOutlines &common : times)
        outlines += common.outlines.size();
    const double share = std::min(1.0, independentTimes / static_cast<double>(times.size()));
    std::vector<ceres::ResidualBlockId> blocks;
    for (std::size_t t = 0; t < times.size(); ++t) {
        for (const CommonOutlines::Outline &outline : times[t].outlines) {
            auto *cost = new ceres::NumericDiffCostFunction<OutlineResidual, ceres::CENTRAL, 6, 3, 4>(
                new OutlineResidual{outline, candidate.kind});
            auto *loss = new ceres::ScaledLoss(new ceres::CauchyLoss(5), share, ceres::TAKE_OWNERSHIP);
            blocks.push_back(problem.AddResidualBlock(cost, loss, poses[t].data(), form.data()));
        }
        if (candidate.kind == SolidShape::Form::Cylinder)
            problem.SetManifold(poses[t].data(),
                                new ceres::SubsetManifold(3, {2})); // it looks alike from all sides
    }
    problem.AddResidualBlock(new ceres::NumericDiffCostFunction<FormPrior, ceres::CENTRAL, 4, 4>(
                                 new FormPrior{candidate.form, candidate.likelyClearanceM}),
                             nullptr, form.data());
    if (candidate.constant.size() == form.size())
        problem.SetParameterBlockConstant(form.data());
    else if (!candidate.constant.empty())
        problem.SetManifold(form.data(), new ceres::SubsetManifold(4, candidate.constant));
    if (std::find(candidate.constant.begin(), candidate.constant.end(), int(BaseShare)) ==
        candidate.constant.end()) {
        problem.SetParameterLowerBound(form.data(), BaseShare, 0);
        problem.SetParameterUpperBound(form.data(), BaseShare, 1);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.max_num_iterations = 40;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (!summary.IsSolutionUsable())
        return std::nullopt;

    ShapeFit fit;
    fit.solid = solidOf(form.data(), candidate.kind);
    fit.form = form;
    ceres::Problem::EvaluateOptions evaluated;
    evaluated.residual_blocks = blocks;
    problem.Evaluate(evaluated, &fit.cost, nullptr, nullptr, nullptr);
    const double freedom = 6.0 * static_cast<double>(outlines) - 3.0 * static_cast<double>(times.size());
    fit.misfit = std::sqrt(2 * fit.cost / share / std::max(1.0, freedom));
    if (problem.IsParameterBlockConstant(form.data()))
        return fit;
    quietCeres();
    ceres::Covariance covariance({});
    std::array<double, 16> block{};
    const std::vector<std::pair<const double *, const double *>> wanted{{form.data(), form.data()}};
    if (!covariance.Compute(wanted, &problem) ||
        !covariance.GetCovarianceBlock(form.data(), form.data(), block.data()))
        return std::nullopt;
    const auto variance = [&block](double byTop, double byBase) {
        return byTop * byTop * block[4 * LogTop + LogTop] +
               2 * byTop * byBase * block[4 * LogTop + BaseShare] +
               byBase * byBase * block[4 * BaseShare + BaseShare];
    };
    const double scale = std::max(1.0, fit.misfit);
    fit.sigmaTopM = scale * std::sqrt(std::max(0.0, variance(fit.solid.topM, 0)));
    fit.sigmaMiddleM =
        scale * std::sqrt(std::max(0.0, variance(middleHeightM(fit.solid), fit.solid.topM / 2)));
    return fit;
}

/// The solids that the given sizes allow: first those on the floor, which most robots are.
std::vector<ShapeCandidate> candidatesFor(const std::vector<CommonOutlines> &times, const RobotShape &given)
{
    const bool hasGivenSize = given.lengthM && given.widthM;
    const double heightM = given.heightM.value_or(guessHeightM);
    const double sizeM = guessedSizeM(times.front().outlines.front(), heightM);
    const double lengthM = hasGivenSize ? *given.lengthM : 1.15 * sizeM,
                 widthM = hasGivenSize ? *given.widthM : sizeM / 1.15;
    const bool maybeRound =
        !hasGivenSize || std::max(lengthM, widthM) <= roundEnough * std::min(lengthM, widthM);
    std::vector<ShapeCandidate> candidates;
    for (const double base : {0.0, 1.0, 0.3}) {
        ShapeCandidate box{
            SolidShape::Form::Box, {std::log(lengthM), std::log(widthM), std::log(heightM), base}, {}};
        if (hasGivenSize)
            box.constant = {LogLength, LogWidth};
        if (given.heightM)
            box.constant.push_back(LogTop);
        if (base == 0 || base == 1)
            box.constant.push_back(BaseShare);
        candidates.push_back(box);
        if (!maybeRound)
            continue;
        ShapeCandidate cylinder = box;
        cylinder.kind = SolidShape::Form::Cylinder;
        cylinder.form[LogLength] = std::log(hasGivenSize ? (lengthM + widthM) / 2 : sizeM);
        if (!hasGivenSize)
            cylinder.constant.insert(cylinder.constant.begin(), LogWidth);
        candidates.push_back(cylinder);
    }
    return candidates;
}

/// A solid on the floor, fitted once more with an unknown clearance. If the outlines do not show one clearly,
/// the solid stays, and the shift of its middle by that clearance is added to the uncertainty.
void findClearance(ShapeFit &standing, const std::vector<CommonOutlines> &times, ShapeCandidate candidate)
{
    candidate.form = standing.form;
    candidate.form[BaseShare] = firstBaseShare;
    candidate.likelyClearanceM = likelyClearanceM;
    std::erase(candidate.constant, int(BaseShare));
    const auto raised = fitSolid(times, candidate);
    if (!raised)
        return;
    if (standing.cost - raised->cost > clearBaseGain)
        standing = *raised;
    else
        standing.sigmaMiddleM =
            std::hypot(raised->sigmaMiddleM, middleHeightM(raised->solid) - middleHeightM(standing.solid));
}

} // namespace

std::optional<ShapeEstimate> estimateShape(const std::vector<ViewTrack> &views, const RobotShape &given)
{
    const std::vector<CommonOutlines> times = commonOutlines(views, mostTimes);
    if (times.size() < leastShapeTimes)
        return std::nullopt;
    std::optional<ShapeFit> best;
    ShapeCandidate bestCandidate;
    for (const ShapeCandidate &candidate : candidatesFor(times, given)) {
        if (best && best->misfit < goodMisfit && candidate.form[BaseShare] > 0)
            break;
        const auto fit = fitSolid(times, candidate);
        if (!fit)
            continue;
        const bool stands = candidate.form[BaseShare] == 0;
        if (!stands && fit->sigmaTopM > leastKnownSigmaM)
            continue;
        const double handicap = stands ? 1.0 : clearlyBetter;
        if (!best || fit->misfit < handicap * best->misfit) {
            best = fit;
            bestCandidate = candidate;
        }
    }
    if (!best)
        return std::nullopt;
    if (bestCandidate.form[BaseShare] == 0)
        findClearance(*best, times, bestCandidate);
    return ShapeEstimate{best->solid, best->sigmaTopM, best->sigmaMiddleM, !given.heightM, best->misfit};
}

} // namespace odo
