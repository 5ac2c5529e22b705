// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/step_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

namespace {

constexpr int mostRounds = 12, mostSweeps = 3;
constexpr double togetherTimes = 2; ///< the variance
/// Shorter ones are for the step finder, since here positions of both sides of a step are smoothed together.
constexpr std::array<double, 3> movesInFrames{16, 8, 4};

SteppedClocks clocksOf(const ClockGuess &clock, const std::vector<FoundStep> &steps)
{
    SteppedClocks clocks;
    clocks.clock = clock;
    for (const FoundStep &found : steps)
        (found.inFirst ? clocks.first : clocks.second).steps.push_back(found.step);
    return clocks;
}

/// When a step of a relation is, of the repaired second clip by the first's pace.
LagChange changeAt(const SteppedClocks &clocks, bool inFirst, const ClockStep &step)
{
    const double justBehindS = step.afterS + 1e-9;
    const double sinceStartS = inFirst ? clocks.first.timeS(justBehindS) - clocks.clock.offsetS
                                       : clocks.second.timeS(justBehindS) / (1 + clocks.clock.rate);
    return {sinceStartS - 1e-9};
}

/// What fitted lengths would leave of all moments that a relation brings together. A moment that it brings
/// together counts for it, or bad ones would best be lost.
double costOf(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
              const SteppedClocks &clocks, bool withRate)
{
    const double frameS = std::max(medianStepS(first), 1e-3);
    const Pairs pairs =
        pairsAt(restamped(first, clocks.first), restamped(second, clocks.second), clocks.clock, 1);
    std::vector<LagChange> changes;
    for (const ClockStep &step : clocks.first.steps)
        changes.push_back(changeAt(clocks, true, step));
    for (const ClockStep &step : clocks.second.steps)
        changes.push_back(changeAt(clocks, false, step));
    const double left =
        agreementOf(pairs, withRate, changes, independentVariance(clocks.variance, frameS)).predicted;
    return double(pairs.size()) * (left - togetherTimes * clocks.variance);
}

} // namespace

SteppedClocks fittedSteps(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                          ClockGuess clock, std::vector<FoundStep> &steps, bool withRate)
{
    const double frameS = std::max(medianStepS(first), 1e-3);
    SteppedClocks clocks;
    double noise = independentVariance(0, frameS);
    for (int round = 0; round < mostRounds; ++round) {
        clocks = clocksOf(clock, steps);
        const std::vector<TimedPosition> a = restamped(first, clocks.first),
                                         b = restamped(second, clocks.second);
        std::vector<LagChange> changes;
        for (const FoundStep &found : steps)
            changes.push_back(changeAt(clocks, found.inFirst, found.step));
        const Pairs pairs = pairsAt(a, b, clock, 1);
        const Agreement agreement = agreementOf(pairs, withRate, changes, noise);
        clocks.variance = agreement.variance;
        clocks.correlatedS = agreement.correlatedS;
        clocks.pairs = pairs.size();
        noise = independentVariance(agreement.variance, frameS);
        Eigen::MatrixXd information = agreement.information;
        if (!withRate)
            information(1, 1) = 1e12;
        const Eigen::MatrixXd covariance = noise * information.inverse();
        clocks.lagSigmaS = covariance.allFinite() && covariance(0, 0) > 0 ? std::sqrt(covariance(0, 0)) : 1e9;
        for (std::size_t k = 0; k < steps.size(); ++k) {
            const auto at = Eigen::Index(2 + k);
            steps[k].step.sigmaS = covariance(at, at) > 0 ? std::sqrt(covariance(at, at)) : 1e9;
        }
        if (round + 1 == mostRounds || (round > 1 && agreement.step.cwiseAbs().maxCoeff() < 1e-6))
            break;
        clock.offsetS += std::clamp(agreement.step[0], -frameS, frameS);
        clock.rate += std::clamp(agreement.step[1], -0.002, 0.002);
        for (std::size_t k = 0; k < steps.size(); ++k) {
            ClockStep &step = steps[k].step;
            const double by =
                std::clamp(steps[k].sign() * agreement.step[Eigen::Index(2 + k)], -frameS, frameS);
            if (step.squeezedS > 0)
                step.squeezedS = std::max(0.0, step.squeezedS - by);
            step.lengthS += by;
        }
    }
    // with the steps' σ, which the last round gave
    const SteppedClocks withSigmas = clocksOf(clocks.clock, steps);
    clocks.first = withSigmas.first;
    clocks.second = withSigmas.second;
    return clocks;
}

bool moveSteps(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
               SteppedClocks &clocks, bool withRate)
{
    SteppedClocks best = clocks;
    const double frameS = std::max({medianStepS(first), medianStepS(second), 1e-3});
    double least = costOf(first, second, best, withRate);
    bool isAnyMoved = false, isMoved = true;
    const auto move = [&](ClockRepair SteppedClocks::*view, std::size_t k, double byS) {
        SteppedClocks moved = best;
        std::vector<ClockStep> &steps = (moved.*view).steps;
        steps[k].afterS += byS;
        if (!std::ranges::is_sorted(steps, {}, &ClockStep::afterS))
            return;
        const double left = costOf(first, second, moved, withRate);
        if (left >= least)
            return;
        least = left;
        best = std::move(moved);
        isMoved = isAnyMoved = true;
    };
    for (int sweep = 0; sweep < mostSweeps && isMoved; ++sweep) {
        isMoved = false;
        for (ClockRepair SteppedClocks::*view : {&SteppedClocks::first, &SteppedClocks::second})
            for (std::size_t k = 0; k < (best.*view).steps.size(); ++k)
                for (const double frames : movesInFrames)
                    for (const double byS : {-frames * frameS, frames * frameS})
                        move(view, k, byS);
    }
    if (!isAnyMoved)
        return false;
    std::vector<FoundStep> steps;
    for (const ClockStep &step : best.first.steps)
        steps.push_back({true, step});
    for (const ClockStep &step : best.second.steps)
        steps.push_back({false, step});
    best = fittedSteps(first, second, best.clock, steps, withRate);
    best.pieces = std::move(clocks.pieces);
    clocks = std::move(best);
    return true;
}

} // namespace odo
