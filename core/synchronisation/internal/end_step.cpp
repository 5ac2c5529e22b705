// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/end_step.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double farTimes = 4; ///< of the usual squared distance
constexpr double shortestEndS = 0.3, longestShare = 0.4;
constexpr double medianShare = 0.69; ///< of the mean of squares, by Rayleigh's distribution

/// How many values at the end of a list are larger than a limit on the whole (CUSUM).
std::size_t largeAtEnd(const std::vector<double> &values, double limit)
{
    double sum = 0, most = 0;
    std::size_t count = 0;
    for (std::size_t k = values.size(); k-- > 0;) {
        sum += values[k] - limit;
        if (sum > most) {
            most = sum;
            count = values.size() - k;
        }
    }
    return count;
}

/// The mean squared distance of the second view's positions at one end from the first view's at a lag;
/// nullopt: fewer than most have one.
std::optional<double> apartM2(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &end,
                              double lagS, double rate)
{
    double sum = 0;
    std::size_t seen = 0;
    for (const TimedPosition &position : end) {
        if (const auto there = trackAt(first, position.timeS / (1 + rate) + lagS)) {
            sum += (there->point - position.pointInWorld).squaredNorm();
            ++seen;
        }
    }
    return 4 * seen >= 3 * end.size() ? std::optional(sum / double(seen)) : std::nullopt;
}

} // namespace

std::optional<EndStep> stepNearEnd(const std::vector<TimedPosition> &first,
                                   const std::vector<TimedPosition> &second, const SteppedClocks &clocks,
                                   bool withRate)
{
    const double frameS = std::max(medianStepS(first), 1e-3);
    const std::vector<TimedPosition> a = restamped(first, clocks.first), b = restamped(second, clocks.second);
    const Pairs pairs = pairsAt(a, b, clocks.clock, 1);
    if (pairs.size() < fewestPairs)
        return std::nullopt;
    const Agreement agreement =
        agreementOf(pairs, withRate, {}, independentVariance(clocks.variance, frameS));
    std::vector<double> left = agreement.leftM2;
    const double usual = upperMedian(left) / medianShare;
    std::optional<EndStep> found;
    double least = farTimes * usual;
    for (const bool isBegin : {false, true}) {
        if (isBegin)
            std::reverse(left.begin(), left.end());
        const std::size_t count = largeAtEnd(left, farTimes * usual);
        if (double(count) * frameS < shortestEndS || double(count) > longestShare * double(left.size()))
            continue;
        const double atS = pairs.sinceStartS[isBegin ? count - 1 : left.size() - count];
        std::vector<TimedPosition> end;
        for (TimedPosition position : b) {
            const double sinceStartS = position.timeS / (1 + clocks.clock.rate);
            if (isBegin ? sinceStartS > atS : sinceStartS < atS)
                continue;
            position.pointInWorld = agreement.lie.onFirst(position.pointInWorld);
            end.push_back(position);
        }
        const double fromS = a.front().timeS - atS - clocks.clock.offsetS,
                     toS = a.back().timeS - atS - clocks.clock.offsetS;
        for (double changeS = fromS; changeS < toS; changeS += frameS / 2) {
            const auto apart = apartM2(a, end, clocks.clock.offsetS + changeS, clocks.clock.rate);
            if (apart && *apart < least) {
                least = *apart;
                found = EndStep{atS, changeS, isBegin};
            }
        }
    }
    return found;
}

} // namespace odo
