// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/constant_lag.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double closestRivalS = 0.5;       // nearer ones are the same
constexpr std::size_t searchedPairs = 1000; // on the grid
constexpr double leastScore = 0.8;

struct Candidate
{
    double offsetS = 0;
    double variance = 0;
};

/// The best offset on the grid, and the best one of those away from it to which every way leads uphill.
struct GridSearch
{
    std::optional<Candidate> best, rival;
};

GridSearch searchGrid(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                      double frameS, const OffsetRange &range)
{
    const std::size_t stride = 1 + first.size() / searchedPairs;
    const std::size_t enough = std::max(fewestPairs, std::min(first.size(), second.size()) / 2) / stride;
    const double stepS = frameS / 2;
    std::vector<Candidate> candidates;
    const int steps = int(std::ceil(range.halfWidthS / stepS));
    for (int i = -steps; i <= steps; ++i) {
        const double offsetS = range.middleS + i * stepS;
        const Pairs pairs = pairsAt(first, second, {offsetS, 0}, stride);
        if (pairs.size() >= enough)
            candidates.push_back(
                {offsetS, agreementOf(pairs, false, {}, independentVariance(0, frameS)).variance});
    }
    GridSearch found;
    for (const Candidate &c : candidates) {
        if (!found.best || c.variance < found.best->variance)
            found.best = c;
    }
    for (std::size_t i = 1; i + 1 < candidates.size(); ++i) {
        const Candidate &c = candidates[i];
        const bool lowest =
            c.variance <= candidates[i - 1].variance && c.variance <= candidates[i + 1].variance;
        if (lowest && std::abs(c.offsetS - found.best->offsetS) > closestRivalS &&
            (!found.rival || c.variance < found.rival->variance))
            found.rival = c;
    }
    return found;
}

ClipOffset offsetFrom(const Fit &fit, double frameS)
{
    const double noise = independentVariance(fit.agreement.variance, frameS),
                 given = fit.agreement.information(0, 0);
    ClipOffset result;
    result.offsetS = fit.clock.offsetS;
    result.sigmaS = given > 0 ? std::sqrt(noise / given) : 1e9;
    result.score =
        fit.motionVariance > 0 ? std::clamp(1 - fit.agreement.variance / fit.motionVariance, 0.0, 1.0) : 0;
    return result;
}

/// What may be left of a rate that is fitted so, where 0 is taken: by Bayes' rule, from a mixture of clocks
/// as most are (29.97 frames/s stated as 30 among them) and of all that are searched.
double rateLeftOf(double rate, double sigma)
{
    constexpr double usual = 0.001, oddsOfAny = 0.5;
    const double both = std::hypot(usual, sigma), part = usual * usual / (both * both),
                 density =
                     std::exp(-rate * rate / (2 * both * both)) / (std::sqrt(2 * std::numbers::pi) * both),
                 odds = oddsOfAny / (2 * largestClockRate) / density, share = 1 / (1 + 1 / odds);
    const double ofAny = rate * rate + sigma * sigma,
                 ofUsual = part * part * rate * rate + part * sigma * sigma;
    return std::sqrt(share * ofAny + (1 - share) * ofUsual);
}

/// Takes the rate as well, if the motion determines it.
void takeRate(ConstantLag &found, const Fit &fit, double frameS)
{
    const Eigen::Matrix2d given = fit.agreement.information.topLeftCorner<2, 2>();
    if (given(0, 0) <= 0 || given(1, 1) <= 0 || given.determinant() <= 0)
        return;
    const Eigen::Matrix2d covariance = independentVariance(fit.agreement.variance, frameS) * given.inverse();
    found.offset.rateSigma = std::sqrt(covariance(1, 1));
    found.rateLeft = rateLeftOf(fit.clock.rate, found.offset.rateSigma);
    if (std::abs(fit.clock.rate) <= 3 * found.offset.rateSigma ||
        fit.agreement.variance >= found.fit.agreement.variance)
        return;
    found.isRateBeyond = std::abs(fit.clock.rate) > largestClockRate;
    if (found.isRateBeyond)
        return;
    const double rateSigma = found.offset.rateSigma;
    found.rateLeft = 0;
    found.fit = fit;
    found.offset = offsetFrom(fit, frameS);
    found.offset.sigmaS = std::sqrt(covariance(0, 0));
    found.offset.rate = fit.clock.rate;
    found.offset.rateSigma = rateSigma;
}

} // namespace

ConstantLag findConstantLag(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                            const OffsetRange &range)
{
    ConstantLag found;
    const double frameS = std::max(medianStepS(first), 1e-3);
    const GridSearch grid = searchGrid(first, second, frameS, range);
    if (!grid.best) {
        found.failure = NoLag::RarelyTogether;
        return found;
    }
    found.fit = refine(first, second, {grid.best->offsetS, 0}, false, frameS);
    found.offset = offsetFrom(found.fit, frameS);
    if (found.offset.sigmaS > frameS)
        found.failure = NoLag::EveryOffset;
    else if (found.offset.score < leastScore)
        found.failure = NoLag::TracksDiffer;
    else if (std::abs(found.offset.offsetS - range.middleS) > range.halfWidthS + frameS)
        found.failure = NoLag::BeyondRange;
    else if (grid.rival) {
        const Fit rival = refine(first, second, {grid.rival->offsetS, 0}, false, frameS);
        if (std::abs(rival.clock.offsetS - found.offset.offsetS) > closestRivalS / 2 &&
            rival.agreement.variance < 2 * std::max(found.fit.agreement.variance, 1e-6)) {
            found.failure = NoLag::Repeats;
            found.rivalS = rival.clock.offsetS;
        }
    }
    if (found.failure == NoLag::None)
        takeRate(found, refine(first, second, found.fit.clock, true, frameS), frameS);
    return found;
}

} // namespace odo
