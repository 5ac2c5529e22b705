// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/clip_synchronisation.h"

#include "core/synchronisation/internal/clock_hypotheses.h"
#include "core/synchronisation/internal/constant_lag.h"
#include "core/synchronisation/internal/unsynchronised_cause.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace odo {

namespace {

constexpr double comparedRate = 0.001; ///< a larger one is compared with other relations
constexpr double leastSteppedScore = 0.97;
constexpr std::size_t mostClockSteps = 8;
constexpr double nearlyAsLikely = 12, alike = 3, tempered = 3; ///< by the logarithm of the likelihood
constexpr double farOffFrames = 3;
constexpr std::size_t manySteps = 3; ///< among which one may be hidden
constexpr double manyStepsFactor = 2;
constexpr double likelyTimes = 1.5, explainedTimes = 3,
                 explainedM = 0.005; ///< in a coordinate: less is no sign of another relation
constexpr double nearLagS = 2;

LagRange lagsOf(const OffsetRange &range, const std::vector<TimedPosition> &first,
                const std::vector<TimedPosition> &second)
{
    constexpr double gapS = 1, mostGapsS = 60; // a clock may jump in a gap
    double gapsS = 0;
    for (const auto *track : {&first, &second}) {
        for (std::size_t i = 1; i < track->size(); ++i) {
            const double stepS = (*track)[i].timeS - (*track)[i - 1].timeS;
            gapsS += stepS > gapS ? stepS : 0;
        }
    }
    const double halfS = range.halfWidthS + std::min(gapsS, mostGapsS);
    return {range.middleS - halfS, range.middleS + halfS};
}

/// When the first view stamps what the second one stamps at a time.
double stampedByFirst(const SteppedClocks &clocks, double secondS)
{
    const double repairedS = clocks.clock.offsetS + clocks.second.timeS(secondS) / (1 + clocks.clock.rate);
    double lowS = repairedS - 200, highS = repairedS + 200;
    for (int i = 0; i < 50; ++i) {
        const double middleS = (lowS + highS) / 2;
        (clocks.first.timeS(middleS) < repairedS ? lowS : highS) = middleS;
    }
    return (lowS + highS) / 2;
}

/// How far apart two relations are nearly everywhere in a track of the second view.
double apartS(const SteppedClocks &a, const SteppedClocks &b, const std::vector<TimedPosition> &second)
{
    std::vector<double> all;
    for (std::size_t i = 0; i < second.size(); i += 5)
        all.push_back(std::abs(stampedByFirst(a, second[i].timeS) - stampedByFirst(b, second[i].timeS)));
    std::sort(all.begin(), all.end());
    return all.empty() ? 0 : all[all.size() * 19 / 20];
}

/// How far a constant lag is from those relations that are nearly as likely as the likeliest.
double farthestS(const Fit &fit, const std::vector<ClockHypothesis> &hypotheses,
                 const std::vector<TimedPosition> &second)
{
    SteppedClocks constant;
    constant.clock = fit.clock;
    double farthest = 0;
    for (const ClockHypothesis &one : hypotheses)
        if (hypotheses.front().likelihood - one.likelihood < nearlyAsLikely)
            farthest = std::max(farthest, apartS(constant, one.clocks, second));
    return farthest;
}

/// In a coordinate: what two tracks are apart by that say the same.
double toleratedM(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                  double times)
{
    return std::max(explainedM, times * std::hypot(whiteNoiseM(first), whiteNoiseM(second)));
}

/// The error of the lag that would leave what a fit does not explain, by the robot's mean speed.
double unexplainedS(const Fit &fit, double mostM)
{
    const double speedSquared = fit.agreement.information(0, 0) / double(std::max<std::size_t>(fit.pairs, 1)),
                 leftM2 = fit.agreement.variance - 2 * mostM * mostM;
    return leftM2 > 0 && speedSquared > 0 ? std::sqrt(leftM2 / speedSquared) : 0;
}

std::vector<TimedPosition> atPace(std::vector<TimedPosition> track, double rate)
{
    for (TimedPosition &position : track)
        position.timeS /= 1 + rate;
    return track;
}

/// What other relations that are nearly as likely add to the variance of the lag; nullopt: one that is as
/// likely is far off.
std::optional<double> varianceOfChoice(const std::vector<ClockHypothesis> &hypotheses,
                                       const std::vector<TimedPosition> &second, double frameS)
{
    double variance = 0;
    const SteppedClocks &best = hypotheses.front().clocks;
    for (std::size_t i = 1; i < hypotheses.size(); ++i) {
        const double behind = hypotheses.front().likelihood - hypotheses[i].likelihood;
        if (behind > nearlyAsLikely)
            break;
        const double otherS = apartS(best, hypotheses[i].clocks, second);
        if (behind < alike && otherS > farOffFrames * frameS)
            return std::nullopt;
        variance = std::max(variance, otherS * otherS / (1 + std::exp(behind / tempered)));
    }
    return variance;
}

/// The relation that explains the tracks best among all that are tried; nullopt: none does, or it leaves
/// the lag open.
std::optional<ClipOffset> offsetOf(const std::vector<ClockHypothesis> &hypotheses,
                                   const std::vector<TimedPosition> &first,
                                   const std::vector<TimedPosition> &second)
{
    const double frameS = std::max(medianStepS(first), 1e-3);
    if (hypotheses.empty())
        return std::nullopt;
    const SteppedClocks &best = hypotheses.front().clocks;
    if (best.steps() > mostClockSteps || best.lagSigmaS > frameS)
        return std::nullopt;
    const double pace = best.clock.rate;
    const ConstantLag lag =
        findConstantLag(restamped(first, best.first), atPace(restamped(second, best.second), pace),
                        {best.clock.offsetS, nearLagS});
    const auto ofChoice = varianceOfChoice(hypotheses, second, frameS);
    if (lag.failure != NoLag::None || lag.isRateBeyond || lag.offset.score < leastSteppedScore || !ofChoice)
        return std::nullopt;
    ClipOffset offset = lag.offset;
    offset.rate = (1 + pace) * (1 + lag.offset.rate) - 1;
    offset.first = best.first;
    offset.second = best.second;
    double variance = *ofChoice + std::max(offset.sigmaS * offset.sigmaS, best.lagSigmaS * best.lagSigmaS);
    for (const ClockRepair *repair : {&best.first, &best.second})
        for (const ClockStep &step : repair->steps)
            variance += step.sigmaS * step.sigmaS;
    variance += std::pow(unexplainedS(lag.fit, toleratedM(first, second, likelyTimes)), 2);
    offset.sigmaS = std::sqrt(variance) * (best.steps() >= manySteps ? manyStepsFactor : 1);
    return offset.sigmaS < farOffFrames * frameS ? std::optional(offset) : std::nullopt;
}

} // namespace

Message clipsSubject()
{
    return ODO_TEXT("synchronisation.of_clips", "synchronisation of the clips");
}

tl::unexpected<Error> undeterminedOffset(Message why)
{
    return fail(ErrorCode::Undetermined, clipsSubject(), std::move(why),
                ODO_TEXT("synchronisation.flash_lights",
                         "flash the room lights once while both cameras record, or give --sync SECONDS"));
}

Result<ClipOffset> estimateClipOffset(const std::vector<TimedPosition> &firstTrack,
                                      const std::vector<TimedPosition> &secondTrack, const OffsetRange &range)
{
    if (firstTrack.size() < fewestPairs || secondTrack.size() < fewestPairs)
        return undeterminedOffset(ODO_TEXT("synchronisation.seldom_seen",
                                           "one view saw the robot in fewer than %1 frames")(fewestPairs));
    const std::vector<TimedPosition> first = thinned(firstTrack), second = thinned(secondTrack);
    for (const auto *track : {&first, &second})
        if (Message uniform = uniformMotion(*track); !uniform.isEmpty())
            return undeterminedOffset(std::move(uniform));
    const double frameS = std::max(medianStepS(first), 1e-3);
    const ConstantLag constant = findConstantLag(first, second, range);
    if (constant.failure == NoLag::Repeats)
        return undeterminedOffset(unsynchronisedCause(first, second, constant, range));
    std::vector<ClockHypothesis> near; // the constant lag
    const bool isFound = constant.failure == NoLag::None && !constant.isRateBeyond;
    if (isFound && std::abs(constant.offset.rate) < comparedRate) {
        near = hypothesesAbout(first, second, lagsOf(range, first, second), constant.fit);
        const auto ofChoice = varianceOfChoice(near, second, frameS);
        const double mostM = toleratedM(first, second, explainedTimes);
        const bool isExplained = constant.fit.agreement.variance < 2 * mostM * mostM;
        if (ofChoice && isExplained && near.front().clocks.steps() == 0) {
            ClipOffset offset = constant.offset;
            offset.sigmaS = std::hypot(offset.sigmaS, std::sqrt(*ofChoice),
                                       unexplainedS(constant.fit, toleratedM(first, second, likelyTimes)));
            const double spanS = first.back().timeS - first.front().timeS;
            offset.sigmaS = std::hypot(offset.sigmaS, constant.rateLeft * spanS / 2);
            if (offset.sigmaS < farOffFrames * frameS)
                return offset;
        }
    }
    const auto hypotheses = clockHypotheses(first, second, lagsOf(range, first, second), std::move(near));
    if (auto offset = offsetOf(hypotheses, first, second))
        return *offset;
    if (isFound) { // no other relation explains the tracks; those as likely make it doubtful
        ClipOffset offset = constant.offset;
        offset.sigmaS = std::hypot(offset.sigmaS, farthestS(constant.fit, hypotheses, second),
                                   unexplainedS(constant.fit, toleratedM(first, second, likelyTimes)));
        if (offset.sigmaS < farOffFrames * frameS)
            return offset;
        return undeterminedOffset(ODO_TEXT("synchronisation.clocks_ambiguous",
                                           "several time offsets, pauses or missing frames "
                                           "explain the views' tracks about equally well"));
    }
    return undeterminedOffset(unsynchronisedCause(first, second, constant, range));
}

} // namespace odo
