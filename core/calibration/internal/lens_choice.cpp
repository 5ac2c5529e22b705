// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/lens_choice.h"

#include "core/base/percentile.h"
#include "core/calibration/internal/calibration_checks.h"
#include "core/calibration/internal/plane_pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace odo {

namespace {

constexpr double cornerOutliers = 5, leastPx = 0.1;
constexpr double medianOfRayleigh = 1.17741; // sqrt(2 ln 2): of distances whose coordinates have σ 1
constexpr std::size_t leastTogether = 3;
constexpr double manyOfRow = 1.0 / 3;
constexpr double restTimes = 1.5; // the usual distance, of the rest of an image with misread corners

CornerMarks beyond(const LensFit &fit, double limitPx)
{
    CornerMarks marks(fit.residualsPx.size());
    for (std::size_t view = 0; view < marks.size(); ++view) {
        for (std::size_t i = 0; i < fit.residualsPx[view].size(); ++i) {
            if (fit.residualsPx[view][i].norm() > limitPx)
                marks[view].push_back(i);
        }
    }
    return marks;
}

/// The smallest distance between two corners of a board.
double spacingM(const BoardView &view)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < view.pointsOnBoard.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, (view.pointsOnBoard[i] - view.pointsOnBoard[j]).norm());
    }
    return least;
}

/// Splits marked corners into groups connected by steps of two squares at most.
std::vector<std::vector<std::size_t>> groupsOf(const BoardView &view, std::vector<std::size_t> marks)
{
    const double reachM = 2.1 * spacingM(view);
    std::vector<std::vector<std::size_t>> groups;
    while (!marks.empty()) {
        std::vector<std::size_t> group{marks.back()};
        marks.pop_back();
        for (std::size_t next = 0; next < group.size(); ++next) {
            const auto near = std::partition(marks.begin(), marks.end(), [&](std::size_t mark) {
                return (view.pointsOnBoard[mark] - view.pointsOnBoard[group[next]]).norm() > reachM;
            });
            group.insert(group.end(), near, marks.end());
            marks.erase(near, marks.end());
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

/// RMS of the corners that are not marked, the pose fitted to them; infinite where they have none.
double restPx(const BoardView &view, const std::vector<std::size_t> &marks, const LensFit &fit,
              const RigidTransform &cameraFromBoard)
{
    const auto pose = fitPose(withoutCorners({view}, {marks}).front(), fit, cameraFromBoard);
    return pose ? pose->rmsPx() : std::numeric_limits<double>::infinity();
}

/// The marks with all corners of those outer rows and columns of which many are marked: what moves some of
/// them, such as a narrower outer square, moves the others by less.
std::vector<std::size_t> withOuterRows(const BoardView &view, const std::vector<std::size_t> &marks)
{
    Eigen::AlignedBox2d board;
    for (const Eigen::Vector2d &point : view.pointsOnBoard)
        board.extend(point);
    std::vector<std::size_t> all = marks;
    for (const Eigen::Index axis : {0, 1}) {
        for (const double edge : {board.min()[axis], board.max()[axis]}) {
            std::vector<std::size_t> row;
            for (std::size_t i = 0; i < view.pointsOnBoard.size(); ++i)
                if (std::abs(view.pointsOnBoard[i][axis] - edge) < 1e-6)
                    row.push_back(i);
            const auto marked = std::ranges::count_if(
                row, [&](std::size_t i) { return std::ranges::binary_search(marks, i); });
            if (double(marked) >= manyOfRow * double(row.size()))
                all.insert(all.end(), row.begin(), row.end());
        }
    }
    std::ranges::sort(all);
    const auto twice = std::ranges::unique(all);
    all.erase(twice.begin(), twice.end());
    return all;
}

double limitOf(const LensFit &fit)
{
    return std::max(leastPx, cornerOutliers * robustSigmaPx(fit));
}

} // namespace

double robustSigmaPx(const LensFit &fit)
{
    std::vector<double> distances;
    for (const auto &residuals : fit.residualsPx) {
        for (const Eigen::Vector2d &residual : residuals)
            distances.push_back(residual.norm());
    }
    if (distances.empty())
        return 0;
    const double values = 2.0 * static_cast<double>(distances.size());
    const double fitted =
        4.0 + static_cast<double>(fit.intrinsics.distortion.size() + 6 * fit.residualsPx.size());
    return upperMedian(std::move(distances)) / medianOfRayleigh *
           std::sqrt(values / std::max(1.0, values - fitted));
}

CornerMarks outlyingCorners(const std::vector<BoardView> &views, const LensFit &fit,
                            const JobControl &control)
{
    const double limitPx = limitOf(fit);
    CornerMarks marks = beyond(fit, limitPx);
    if (countOf(marks) == 0)
        return marks;
    const auto robust =
        fitLens(views, {fit.intrinsics, fit.cameraFromBoard, fit.print},
                {.cauchyPx = 2 * limitPx / cornerOutliers, .freePrint = fit.estimatesPrint()}, control);
    return robust ? beyond(*robust, limitOf(*robust)) : marks;
}

CornerMarks misreadCorners(const std::vector<BoardView> &views, const LensFit &fit, const CornerMarks &marks)
{
    CornerMarks misread(marks.size());
    const double mostPx = restTimes * std::sqrt(2.0) * std::max(robustSigmaPx(fit), leastPx / cornerOutliers);
    for (std::size_t view = 0; view < marks.size(); ++view) {
        if (views[view].pixels.size() < marks[view].size() + leastCornersOfView)
            continue;
        const bool isRestFlat = 2 * marks[view].size() < views[view].pixels.size() &&
                                restPx(views[view], marks[view], fit, fit.cameraFromBoard[view]) < mostPx;
        if (isRestFlat) {
            misread[view] = withOuterRows(views[view], marks[view]);
            continue;
        }
        for (const auto &group : groupsOf(views[view], marks[view])) {
            if (group.size() < leastTogether)
                misread[view].insert(misread[view].end(), group.begin(), group.end());
        }
        std::ranges::sort(misread[view]);
    }
    return misread;
}

std::size_t countOf(const CornerMarks &marks)
{
    std::size_t count = 0;
    for (const auto &list : marks)
        count += list.size();
    return count;
}

std::vector<BoardView> withoutCorners(const std::vector<BoardView> &views, const CornerMarks &marks)
{
    std::vector<BoardView> kept = views;
    for (std::size_t view = 0; view < views.size(); ++view) {
        for (auto index = marks[view].rbegin(); index != marks[view].rend(); ++index) {
            kept[view].pixels.erase(kept[view].pixels.begin() + static_cast<std::ptrdiff_t>(*index));
            kept[view].pointsOnBoard.erase(kept[view].pointsOnBoard.begin() +
                                           static_cast<std::ptrdiff_t>(*index));
        }
    }
    return kept;
}

namespace {

constexpr int decimals = 3;
constexpr double wideDegrees = 60; // between the axis and the outermost corner

struct LensCandidate
{
    LensFit fit;
    CornerMarks outliers;
    std::optional<HeldOut> heldOut;

    LensModel model() const { return fit.intrinsics.model; }
    /// Infinite also where the images do not determine it.
    double heldOutPx() const
    {
        return heldOut && isDetermined(fit) ? heldOut->predictionPx()
                                            : std::numeric_limits<double>::infinity();
    }
};

/// The largest angle between the axis and a corner, as the lens sees it.
double halfAngleDegrees(const std::vector<BoardView> &views, const LensFit &fit)
{
    double angle = 0;
    for (std::size_t view = 0; view < views.size(); ++view) {
        for (const Eigen::Vector2d &point : views[view].pointsOnBoard) {
            const Eigen::Vector3d seen = fit.cameraFromBoard[view] * fit.print.at(point);
            angle = std::max(angle, std::atan2(seen.head<2>().norm(), seen.z()));
        }
    }
    return angle * 180 / EIGEN_PI;
}

/// The plainest model first; of a wide lens that is the fisheye's, which a polynomial of the radius suits
/// worse and worse.
void sortByPlainness(std::vector<LensCandidate> &candidates, const std::vector<BoardView> &views)
{
    const auto fisheye = std::ranges::find(candidates, LensModel::Fisheye, &LensCandidate::model);
    if (fisheye != candidates.end() && halfAngleDegrees(views, fisheye->fit) > wideDegrees)
        std::rotate(candidates.begin(), fisheye, fisheye + 1);
}

CornerMarks common(const std::vector<LensCandidate> &candidates)
{
    CornerMarks marks = candidates.front().outliers;
    for (const LensCandidate &candidate : candidates) {
        for (std::size_t view = 0; view < marks.size(); ++view) {
            std::vector<std::size_t> both;
            std::ranges::set_intersection(marks[view], candidate.outliers[view], std::back_inserter(both));
            marks[view] = std::move(both);
        }
    }
    return marks;
}

/// No model predicts better than the best by chance, and one that is not determined not at all.
bool isClearlyWorse(const LensCandidate &simpler, const LensCandidate &best)
{
    if (!std::isfinite(simpler.heldOutPx()))
        return std::isfinite(best.heldOutPx());
    return predictsClearlyWorse(*simpler.heldOut, *best.heldOut);
}

MessageArgument pixelsOf(const LensCandidate &candidate)
{
    if (!std::isfinite(candidate.heldOutPx()))
        return Message(ODO_TEXT("calibration.not_all_foretold", "not all"));
    return quantity(candidate.heldOutPx(), decimals, "px");
}

Message reasonOf(const LensCandidate &chosen, const std::vector<LensCandidate> &candidates)
{
    const auto other = std::ranges::min_element(candidates, {}, [&](const LensCandidate &candidate) {
        return &candidate == &chosen ? std::numeric_limits<double>::infinity() : candidate.heldOutPx();
    });
    if (&*other == &chosen)
        return ODO_TEXT("calibration.no_other_lens", "no other model fits");
    const bool simplest = &chosen == &candidates.front();
    const LensCandidate &against = simplest ? *other : candidates.front();
    const MessageText &words =
        !simplest ? ODO_TEXT("calibration.foretells_better",
                             "it predicts held-out images to %1, the %2 model only to %3")
        : against.heldOutPx() < chosen.heldOutPx()
            ? ODO_TEXT("calibration.foretells_by_chance",
                       "it predicts held-out images to %1, the %2 model to %3; the difference may be chance")
            : ODO_TEXT("calibration.foretells_as_well",
                       "it predicts held-out images to %1, the %2 model no better (%3)");
    return words(pixelsOf(chosen), lensModelName(against.model()), pixelsOf(against));
}

} // namespace

Message lensModelName(LensModel model)
{
    return model == LensModel::Standard   ? ODO_TEXT("calibration.standard", "standard")
           : model == LensModel::Rational ? ODO_TEXT("calibration.rational", "rational")
                                          : ODO_TEXT("calibration.fisheye", "fisheye");
}

std::optional<LensChoice> chooseLens(const std::vector<BoardView> &views,
                                     const std::vector<LensStart> &starts, const JobControl &control)
{
    std::vector<LensCandidate> candidates;
    for (const LensStart &start : starts) {
        auto fit = fitLens(views, start, {}, control);
        if (!fit)
            continue;
        CornerMarks outliers = outlyingCorners(views, *fit, control);
        candidates.push_back({std::move(*fit), std::move(outliers), std::nullopt});
    }
    if (candidates.empty() || control.isCancelled())
        return std::nullopt;
    sortByPlainness(candidates, views);
    if (starts.size() == 1)
        return LensChoice{std::move(candidates.front().fit),
                          std::move(candidates.front().outliers),
                          {},
                          ODO_TEXT("calibration.lens_told", "as specified")};

    const std::vector<BoardView> sound =
        withoutCorners(views, misreadCorners(views, candidates.front().fit, common(candidates)));
    std::vector<ModelTrial> trials;
    for (LensCandidate &candidate : candidates) {
        candidate.heldOut = holdOut(sound, candidate.fit, {}, control);
        trials.push_back({candidate.model(), candidate.heldOutPx()});
    }
    if (control.isCancelled())
        return std::nullopt;
    const LensCandidate &best = *std::ranges::min_element(candidates, {}, &LensCandidate::heldOutPx);
    LensCandidate &chosen = *std::ranges::find_if(
        candidates, [&](const LensCandidate &candidate) { return !isClearlyWorse(candidate, best); });
    Message reason = reasonOf(chosen, candidates);
    return LensChoice{std::move(chosen.fit), std::move(chosen.outliers), std::move(trials),
                      std::move(reason)};
}

} // namespace odo
