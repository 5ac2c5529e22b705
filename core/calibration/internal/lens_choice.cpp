// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/lens_choice.h"

#include "core/calibration/internal/calibration_checks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace odo {

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
        auto fit = fitIntrinsics(views, start, {}, control);
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
