// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/lens_choice.h"

#include "core/base/units.h"
#include "core/calibration/held_out.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace odo {

namespace {

constexpr double marginErrors = 2;    // standard errors of the mean difference
constexpr double marginPart = 0.01;   // of the RMS: less is nothing that anybody would notice
constexpr int decimals = 3;

struct LensCandidate
{
    LensFit fit;
    CornerMarks outliers;
    std::optional<HeldOut> heldOut;

    LensModel model() const { return fit.intrinsics.model; }
    double heldOutPx() const
    {
        return heldOut && heldOut->unforetold == 0 ? heldOut->rmsPx : std::numeric_limits<double>::infinity();
    }
};

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

/// The simpler model foretells clearly worse: by more than chance among the pictures explains, and by enough to matter.
bool isClearlyWorse(const LensCandidate &simpler, const LensCandidate &best)
{
    if (!(simpler.heldOutPx() > (1 + marginPart) * best.heldOutPx()))
        return false;
    if (!std::isfinite(simpler.heldOutPx()))
        return true;
    const auto &worse = simpler.heldOut->pictureMeanSquares, &better = best.heldOut->pictureMeanSquares;
    const auto count = static_cast<double>(worse.size());
    // Of each picture's RMS, since squares would let one picture drown the others.
    const auto gain = [&](std::size_t i) { return std::sqrt(worse[i]) - std::sqrt(better[i]); };
    double mean = 0, squares = 0;
    for (std::size_t i = 0; i < worse.size(); ++i)
        mean += gain(i) / count;
    for (std::size_t i = 0; i < worse.size(); ++i)
        squares += std::pow(gain(i) - mean, 2);
    return mean > marginErrors * std::sqrt(squares / (count - 1) / count);
}

std::string pixelsOf(const LensCandidate &candidate)
{
    return std::isfinite(candidate.heldOutPx()) ? formatNumber(candidate.heldOutPx(), decimals) + " px" : "not all";
}

std::string reasonOf(const LensCandidate &chosen, const std::vector<LensCandidate> &candidates)
{
    const auto other = std::ranges::min_element(candidates, {}, [&](const LensCandidate &candidate) {
        return &candidate == &chosen ? std::numeric_limits<double>::infinity() : candidate.heldOutPx();
    });
    if (&*other == &chosen)
        return "no other model fits";
    const std::string own = "it foretells pictures held out to " + pixelsOf(chosen) + ", the ";
    const bool simplest = &chosen == &candidates.front();
    const LensCandidate &against = simplest ? *other : candidates.front();
    const std::string name = lensModelName(against.model());
    if (simplest && against.heldOutPx() < chosen.heldOutPx())
        return own + name + " one to " + pixelsOf(against) + ", which may be chance";
    return own + name + " one " + (simplest ? "no better (" : "only to ") + pixelsOf(against) + (simplest ? ")" : "");
}

} // namespace

std::string lensModelName(LensModel model)
{
    return model == LensModel::Standard ? "standard" : model == LensModel::Rational ? "rational" : "fisheye";
}

std::optional<LensChoice> chooseLens(const std::vector<BoardView> &views, const std::vector<LensStart> &starts,
                                     const JobControl &control)
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
    if (starts.size() == 1)
        return LensChoice{std::move(candidates.front().fit), std::move(candidates.front().outliers), {}, "told"};

    const std::vector<BoardView> sound = withoutCorners(views, singleCorners(views, candidates.front().fit, common(candidates)));
    std::vector<LensTrial> trials;
    for (LensCandidate &candidate : candidates) {
        candidate.heldOut = holdOut(sound, candidate.fit, control);
        trials.push_back({candidate.model(), candidate.heldOutPx()});
    }
    if (control.isCancelled())
        return std::nullopt;
    const LensCandidate &best = *std::ranges::min_element(candidates, {}, &LensCandidate::heldOutPx);
    LensCandidate &chosen = *std::ranges::find_if(
        candidates, [&](const LensCandidate &candidate) { return !isClearlyWorse(candidate, best); });
    std::string reason = reasonOf(chosen, candidates);
    return LensChoice{std::move(chosen.fit), std::move(chosen.outliers), std::move(trials), std::move(reason)};
}

} // namespace odo
