// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/step_search.h"

#include "core/synchronisation/internal/clip_synchronisation.h"
#include "core/synchronisation/internal/end_step.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double leastFrames = 0.6; ///< of a step
constexpr double shortestPieceS = 0.4;
constexpr std::size_t mostAdded = 8, mostUnpaid = 2;
constexpr double mostScanned = 100;
constexpr double scanStepS = 0.1, fromEndS = 0.5;
constexpr double leastVariance = 1e-6; ///< m²: never surer than 1 mm of disagreement
constexpr double shortestCorrelationS = 0.1, longestCorrelationS = 0.5;
// what speaks against a relation beforehand, as logarithms
constexpr double againstRate = 1, againstFastRate = 3, againstLabel = 4, againstStep = 10;
constexpr double clockUsualRate = 0.001;

/// The pieces of a course that last, neighbours of the same lag together.
std::vector<LagPiece> lastingPieces(const LagCourse &course, double frameS)
{
    std::vector<LagPiece> pieces;
    for (const LagPiece &piece : course.pieces) {
        if (piece.toS - piece.fromS < shortestPieceS)
            continue;
        if (!pieces.empty() && std::abs(pieces.back().lagS - piece.lagS) < leastFrames * frameS)
            pieces.back().toS = piece.toS;
        else
            pieces.push_back(piece);
    }
    return pieces;
}

/// Leaves out the steps of less than a frame, each with the piece behind it.
bool withoutSmallSteps(std::vector<FoundStep> &steps, std::vector<LagPiece> &pieces, double frameS)
{
    const std::size_t before = steps.size();
    for (std::size_t k = steps.size(); k-- > 0;) {
        if (std::abs(steps[k].step.lengthS) >= leastFrames * frameS)
            continue;
        steps.erase(steps.begin() + std::ptrdiff_t(k));
        pieces[k].toS = pieces[k + 1].toS;
        pieces.erase(pieces.begin() + std::ptrdiff_t(k) + 1);
    }
    return steps.size() < before;
}

/// The relation whose lag goes by pieces.
SteppedClocks clocksByPieces(const std::vector<TimedPosition> &first,
                             const std::vector<TimedPosition> &second, std::vector<LagPiece> pieces,
                             double rate, double noiseM, bool withRate)
{
    SteppedClocks clocks;
    // Only fitted lags show the moment of a step to the frame.
    for (int round = 0; round < 2; ++round) {
        const double frameS = std::max({medianStepS(first), medianStepS(second) / (1 + rate), 1e-3});
        std::vector<FoundStep> steps;
        for (std::size_t i = 1; i < pieces.size(); ++i)
            steps.push_back(stepBetween(first, second, pieces[i - 1], pieces[i], rate, noiseM));
        clocks = fittedSteps(first, second, {pieces.front().lagS, rate}, steps, withRate);
        if (withoutSmallSteps(steps, pieces, frameS))
            clocks = fittedSteps(first, second, clocks.clock, steps, withRate);
        rate = clocks.clock.rate;
        pieces.front().lagS = clocks.clock.offsetS;
        for (std::size_t k = 0; k < steps.size(); ++k)
            pieces[k + 1].lagS =
                pieces[k].lagS + steps[k].sign() * steps[k].step.lengthS / (steps[k].inFirst ? 1 : 1 + rate);
        if (steps.empty())
            break;
    }
    clocks.pieces = std::move(pieces);
    return clocks;
}

/// A further step that what remains shows.
struct FurtherStep
{
    double atS = 0;               ///< of the second clip, by the first's pace
    double offsetS = 0, lagS = 0; ///< by which the offset changes, and the lag from then on
};

FurtherStep likeliestStep(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                          const SteppedClocks &clocks, bool withRate)
{
    const double frameS = std::max(medianStepS(first), 1e-3),
                 noise = independentVariance(clocks.variance, frameS);
    const Pairs pairs =
        pairsAt(restamped(first, clocks.first), restamped(second, clocks.second), clocks.clock, 1);
    std::vector<LagChange> changes;
    for (std::size_t k = 1; k < clocks.pieces.size(); ++k)
        changes.push_back({clocks.first.timeS(clocks.pieces[k].fromS) - clocks.clock.offsetS});
    changes.push_back({0});
    FurtherStep best;
    const double stepS = std::max(scanStepS, double(pairs.size()) * frameS / mostScanned);
    double least = HUGE_VAL;
    if (pairs.size() < fewestPairs)
        return best;
    for (double atS = pairs.sinceStartS.front() + fromEndS; atS < pairs.sinceStartS.back() - fromEndS;
         atS += stepS) {
        changes.back().fromS = atS;
        const Agreement agreement = agreementOf(pairs, withRate, changes, noise);
        if (agreement.predicted < least) {
            least = agreement.predicted;
            best = {atS, agreement.step[0], agreement.step[Eigen::Index(1 + changes.size())]};
        }
    }
    return best;
}

/// The pieces of a relation with one of them split at a moment of the first view's repaired clock; empty:
/// none is there. behind: of its later part.
std::vector<LagPiece> split(const std::vector<TimedPosition> &first, const SteppedClocks &clocks, double atS,
                            std::size_t &behind)
{
    std::vector<LagPiece> pieces = clocks.pieces;
    pieces.back().toS = std::max(pieces.back().toS, first.back().timeS);
    const auto at = std::find_if(pieces.begin(), pieces.end(),
                                 [&](const LagPiece &piece) { return clocks.first.timeS(piece.toS) > atS; });
    if (at == pieces.end())
        return {};
    const double stampedS = atS - (clocks.first.timeS(at->toS) - at->toS);
    LagPiece later = *at;
    later.fromS = stampedS;
    at->toS = stampedS;
    behind = std::size_t(at - pieces.begin()) + 1;
    pieces.insert(at + 1, later);
    return pieces;
}

/// The pieces of a relation with the further step that what remains shows; empty: it shows none.
std::vector<LagPiece> withAnotherStep(const std::vector<TimedPosition> &first,
                                      const std::vector<TimedPosition> &second, const SteppedClocks &clocks,
                                      bool withRate)
{
    const double frameS = std::max(medianStepS(first), 1e-3);
    const auto [sinceStartS, offsetS, changeS] = likeliestStep(first, second, clocks, withRate);
    if (std::abs(changeS) < leastFrames * frameS / 2)
        return {};
    std::size_t behind = 0;
    std::vector<LagPiece> pieces = split(first, clocks, sinceStartS + clocks.clock.offsetS, behind);
    for (std::size_t k = behind; k < pieces.size(); ++k)
        pieces[k].lagS += changeS;
    if (!withRate) // the offset is that at the clip's start, and goes with the rate
        for (LagPiece &piece : pieces)
            piece.lagS += offsetS;
    return pieces;
}

/// The pieces of a relation with the step that one end of the tracks shows; empty: none does.
std::vector<LagPiece> withStepNearEnd(const std::vector<TimedPosition> &first,
                                      const std::vector<TimedPosition> &second, const SteppedClocks &clocks,
                                      bool withRate)
{
    const auto end = stepNearEnd(first, second, clocks, withRate);
    if (!end)
        return {};
    std::size_t behind = 0;
    std::vector<LagPiece> pieces = split(first, clocks, end->atS + clocks.clock.offsetS, behind);
    if (pieces.empty())
        return {};
    for (std::size_t k = end->isBegin ? 0 : behind; k < (end->isBegin ? behind : pieces.size()); ++k) {
        pieces[k].lagS += end->changeS;
        pieces[k].fromS += end->changeS; // the second view's moments stay
        pieces[k].toS += end->changeS;
    }
    return pieces;
}

} // namespace

double independentMoments(const SteppedClocks &clocks, double frameS)
{
    return double(clocks.pairs) *
           std::min(1.0, frameS / std::clamp(clocks.correlatedS, shortestCorrelationS, longestCorrelationS));
}

double clockLikelihood(const SteppedClocks &clocks, double independent)
{
    const double rate = std::abs(clocks.clock.rate);
    const double against = againstStep * double(clocks.steps()) + (rate == 0                 ? 0
                                                                   : rate < clockUsualRate   ? againstRate
                                                                   : rate < largestClockRate ? againstFastRate
                                                                                             : againstLabel);
    return -independent * std::log(std::max(clocks.variance, leastVariance)) - against;
}

std::optional<SteppedClocks> steppedClocks(const std::vector<TimedPosition> &first,
                                           const std::vector<TimedPosition> &second, const LagCourse &course,
                                           bool withRate)
{
    const double frameS = std::max({medianStepS(first), medianStepS(second) / (1 + course.rate), 1e-3});
    std::vector<LagPiece> pieces = lastingPieces(course, frameS);
    if (pieces.empty())
        return std::nullopt;
    return clocksByPieces(first, second, std::move(pieces), course.rate, course.noiseM, withRate);
}

std::vector<SteppedClocks> withBetterSteps(const std::vector<TimedPosition> &first,
                                           const std::vector<TimedPosition> &second, SteppedClocks clocks,
                                           double noiseM, bool withRate)
{
    const double frameS = std::max(medianStepS(first), 1e-3);
    const auto isBetter = [frameS](const SteppedClocks &a, const SteppedClocks &b) {
        const double independent = independentMoments(a.variance < b.variance ? a : b, frameS);
        const double seenS = frameS * (double(a.pairs) - double(b.pairs));
        return clockLikelihood(a, independent) + againstUnseenS * seenS > clockLikelihood(b, independent);
    };
    const auto made = [&](std::vector<LagPiece> pieces) {
        return clocksByPieces(first, second, std::move(pieces), clocks.clock.rate, noiseM, withRate);
    };
    std::vector<SteppedClocks> others;
    if (auto pieces = withStepNearEnd(first, second, clocks, withRate); !pieces.empty()) {
        others.push_back(made(std::move(pieces)));
        if (isBetter(others.back(), clocks))
            std::swap(others.back(), clocks);
    }
    // Two steps that cancel out explain little each, so one that does not pay is followed further.
    SteppedClocks tried = clocks;
    for (std::size_t since = 0, added = 0; added < mostAdded && since <= mostUnpaid; ++added, ++since) {
        auto pieces = withAnotherStep(first, second, tried, withRate);
        if (pieces.empty())
            break;
        SteppedClocks more = made(std::move(pieces));
        if (more.steps() <= tried.steps())
            break;
        tried = std::move(more);
        others.push_back(tried);
        if (isBetter(tried, clocks)) {
            std::swap(others.back(), clocks);
            since = 0;
        }
    }
    for (std::size_t k = clocks.pieces.size(); k-- > 1;) {
        std::vector<LagPiece> pieces = clocks.pieces;
        pieces[k - 1].toS = pieces[k].toS;
        pieces.erase(pieces.begin() + std::ptrdiff_t(k));
        others.push_back(made(std::move(pieces)));
        if (isBetter(others.back(), clocks))
            std::swap(others.back(), clocks);
        k = std::min(k, clocks.pieces.size());
    }
    others.insert(others.begin(), std::move(clocks));
    return others;
}

} // namespace odo
