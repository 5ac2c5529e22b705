// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/step_search.h"

#include "core/base/percentile.h"
#include "core/synchronisation/internal/clip_synchronisation.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>

namespace odo {

namespace {

constexpr double leastFrames = 0.6; ///< of a step
constexpr double shortestPieceS = 0.4;
constexpr double aroundS = 0.7;    ///< a jump, within which its moment is sought
constexpr double heldShare = 0.35; ///< of the way that a robot would go at its speed: it is held
constexpr double clearM = 0.008;   ///< of that way: less tells nothing
constexpr double gapS = 0.3;
constexpr int mostRounds = 12;
constexpr std::size_t mostAdded = 8;
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

/// A step of one of the views.
struct FoundStep
{
    bool inFirst = false;
    ClockStep step;
    double sinceStartS = 0; ///< of the repaired second clip, by the first's pace

    /// What the lag changes by with each second that the step is longer.
    double sign() const { return inFirst ? -1 : 1; }
};

class StepFinder
{
public:
    StepFinder(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second, double rate,
               double noiseM)
        : m_first(first), m_second(second), m_rate(rate), m_noiseM(noiseM)
    {
    }

    /// shift: of the first view's positions against the second's.
    FoundStep between(const LagPiece &before, const LagPiece &after) const
    {
        const double changeS = after.lagS - before.lagS;
        const Eigen::Vector2d shift = shiftOf(before, after);
        FoundStep found;
        if (changeS > 0) {
            const double ownS = splitSecond(before, after, shift),
                         commonS = before.lagS + ownS / (1 + m_rate);
            found.inFirst = isGap(m_first, commonS, changeS) || isHeld(m_first, commonS, changeS, 1);
            found.step = found.inFirst ? taken(commonS + changeS, changeS, m_first)
                                       : ClockStep{ownS, changeS * (1 + m_rate), 0, 0};
        } else {
            const double commonS = splitFirst(before, after, shift),
                         ownS = (commonS - before.lagS) * (1 + m_rate), lengthS = -changeS * (1 + m_rate);
            found.inFirst = !isGap(m_second, ownS, lengthS) && !isHeld(m_second, ownS, lengthS, 1 + m_rate);
            found.step =
                found.inFirst ? ClockStep{commonS, -changeS, 0, 0} : taken(ownS + lengthS, lengthS, m_second);
        }
        return found;
    }

private:
    /// A step that takes time off: the end of a gap is where the stamps are off.
    static ClockStep taken(double afterS, double lengthS, const std::vector<TimedPosition> &track)
    {
        if (!isGap(track, afterS - lengthS, lengthS))
            return {afterS - 1e-6, -lengthS, 0, lengthS};
        const auto next = positionFrom(track, afterS - 0.8 * lengthS);
        return {next == track.end() ? afterS : next->timeS - 1e-3, -lengthS, 0, 0};
    }

    static std::vector<TimedPosition>::const_iterator positionFrom(const std::vector<TimedPosition> &track,
                                                                   double timeS)
    {
        return std::lower_bound(track.begin(), track.end(), timeS,
                                [](const TimedPosition &p, double t) { return p.timeS < t; });
    }

    Eigen::Vector2d shiftOf(const LagPiece &before, const LagPiece &after) const
    {
        std::vector<double> x, y;
        for (const TimedPosition &position : m_first) {
            for (const LagPiece *piece : {&before, &after}) {
                if (position.timeS < piece->fromS || position.timeS > piece->toS)
                    continue;
                if (const auto other = trackAt(m_second, (position.timeS - piece->lagS) * (1 + m_rate))) {
                    x.push_back(position.pointInWorld.x() - other->point.x());
                    y.push_back(position.pointInWorld.y() - other->point.y());
                }
            }
        }
        if (x.empty())
            return Eigen::Vector2d::Zero();
        return {upperMedian(std::move(x)), upperMedian(std::move(y))};
    }

    /// The time between two positions of a track before which one cost is paid and behind which the other.
    static double split(const std::vector<TimedPosition> &track, double fromS, double toS,
                        const std::function<double(const TimedPosition &)> &before,
                        const std::function<double(const TimedPosition &)> &after)
    {
        double sum = 0, least = 0, bestS = (fromS + toS) / 2;
        bool isFirst = true;
        for (std::size_t i = 0; i < track.size(); ++i) {
            if (track[i].timeS < fromS || track[i].timeS > toS)
                continue;
            const double nextS = i + 1 < track.size() ? track[i + 1].timeS : track[i].timeS;
            sum += before(track[i]) - after(track[i]);
            if (isFirst || sum < least) {
                least = sum;
                bestS = (track[i].timeS + nextS) / 2;
                isFirst = false;
            }
        }
        return bestS;
    }

    double costAt(const std::optional<PositionAndVelocity> &there, const Eigen::Vector2d &apart) const
    {
        const double most = 25;
        return there ? std::min(most, apart.squaredNorm() / (2 * m_noiseM * m_noiseM)) : most / 4;
    }

    double splitSecond(const LagPiece &before, const LagPiece &after, const Eigen::Vector2d &shift) const
    {
        const auto cost = [&](double lagS) {
            return [this, lagS, shift](const TimedPosition &position) {
                const auto there = trackAt(m_first, lagS + position.timeS / (1 + m_rate));
                return costAt(there, there ? Eigen::Vector2d(there->point - position.pointInWorld - shift)
                                           : Eigen::Vector2d::Zero());
            };
        };
        return split(m_second, (before.toS - before.lagS - aroundS) * (1 + m_rate),
                     (after.fromS - after.lagS + aroundS) * (1 + m_rate), cost(before.lagS),
                     cost(after.lagS));
    }

    double splitFirst(const LagPiece &before, const LagPiece &after, const Eigen::Vector2d &shift) const
    {
        const auto cost = [&](double lagS) {
            return [this, lagS, shift](const TimedPosition &position) {
                const auto there = trackAt(m_second, (position.timeS - lagS) * (1 + m_rate));
                return costAt(there, there ? Eigen::Vector2d(position.pointInWorld - there->point - shift)
                                           : Eigen::Vector2d::Zero());
            };
        };
        return split(m_first, before.toS - aroundS, after.fromS + aroundS, cost(before.lagS),
                     cost(after.lagS));
    }

    /// Whether a track has no position there for most of a time.
    static bool isGap(const std::vector<TimedPosition> &track, double fromS, double lengthS)
    {
        if (lengthS < gapS)
            return false;
        const auto begin = positionFrom(track, fromS + 0.2 * lengthS);
        return begin == track.end() || begin->timeS > fromS + 0.8 * lengthS;
    }

    /// Whether a view's robot stays for a time where it would go on at its speed. pace: of the view's clock.
    bool isHeld(const std::vector<TimedPosition> &track, double fromS, double lengthS, double pace) const
    {
        const auto velocityBy = [&](double timeS) -> std::optional<double> {
            const auto there = trackAt(track, timeS);
            return there ? std::optional(there->velocity.norm()) : std::nullopt;
        };
        const auto before = velocityBy(fromS - 0.25 * pace),
                   after = velocityBy(fromS + lengthS + 0.25 * pace);
        if (!before || !after)
            return false;
        const double wayM = std::min(*before, *after) * lengthS;
        const Eigen::Vector2d from = pointFrom(track, fromS), to = pointFrom(track, fromS + lengthS);
        return wayM > std::max(clearM, 4 * m_noiseM) && (to - from).norm() < heldShare * wayM;
    }

    static Eigen::Vector2d pointFrom(const std::vector<TimedPosition> &track, double timeS)
    {
        const auto at = positionFrom(track, timeS);
        return (at == track.end() ? track.back() : *at).pointInWorld;
    }

    const std::vector<TimedPosition> &m_first, &m_second;
    double m_rate, m_noiseM;
};

SteppedClocks clocksOf(const ClockGuess &clock, const std::vector<FoundStep> &steps)
{
    SteppedClocks clocks;
    clocks.clock = clock;
    for (const FoundStep &found : steps)
        (found.inFirst ? clocks.first : clocks.second).steps.push_back(found.step);
    return clocks;
}

/// Gauss–Newton of offset, rate and the steps' lengths.
SteppedClocks fitted(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
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
        for (FoundStep &found : steps) {
            const double atS = found.step.afterS + 1e-9;
            found.sinceStartS = found.inFirst ? clocks.first.timeS(atS) - clock.offsetS
                                              : clocks.second.timeS(atS) / (1 + clock.rate);
            changes.push_back({found.sinceStartS - 1e-9});
        }
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

/// The relation whose lag goes by pieces.
SteppedClocks clocksByPieces(const std::vector<TimedPosition> &first,
                             const std::vector<TimedPosition> &second, std::vector<LagPiece> pieces,
                             double rate, double noiseM, bool withRate)
{
    const double frameS = std::max({medianStepS(first), medianStepS(second) / (1 + rate), 1e-3});
    const StepFinder finder(first, second, rate, noiseM);
    std::vector<FoundStep> steps;
    for (std::size_t i = 1; i < pieces.size(); ++i)
        steps.push_back(finder.between(pieces[i - 1], pieces[i]));
    SteppedClocks clocks = fitted(first, second, {pieces.front().lagS, rate}, steps, withRate);
    for (std::size_t k = steps.size(); k-- > 0;) {
        if (std::abs(steps[k].step.lengthS) >= leastFrames * frameS)
            continue;
        steps.erase(steps.begin() + std::ptrdiff_t(k));
        pieces[k].toS = pieces[k + 1].toS;
        pieces.erase(pieces.begin() + std::ptrdiff_t(k) + 1);
    }
    if (steps.size() < clocks.steps())
        clocks = fitted(first, second, clocks.clock, steps, withRate);
    pieces.front().lagS = clocks.clock.offsetS;
    for (std::size_t k = 0; k < steps.size(); ++k)
        pieces[k + 1].lagS = pieces[k].lagS + steps[k].sign() * steps[k].step.lengthS /
                                                  (steps[k].inFirst ? 1 : 1 + clocks.clock.rate);
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

SteppedClocks withBetterSteps(const std::vector<TimedPosition> &first,
                              const std::vector<TimedPosition> &second, SteppedClocks clocks, double noiseM,
                              bool withRate)
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
    for (std::size_t added = 0; added < mostAdded; ++added) {
        const auto [sinceStartS, offsetS, changeS] = likeliestStep(first, second, clocks, withRate);
        const double atS = sinceStartS + clocks.clock.offsetS; // of the first's repaired clock
        std::vector<LagPiece> pieces = clocks.pieces;
        const auto at = std::find_if(pieces.begin(), pieces.end(), [&](const LagPiece &piece) {
            return clocks.first.timeS(piece.toS) > atS;
        });
        if (std::abs(changeS) < leastFrames * frameS / 2 || at == pieces.end())
            break;
        const double stampedS = atS - (clocks.first.timeS(at->toS) - at->toS);
        LagPiece behind = *at;
        behind.fromS = stampedS;
        behind.lagS += changeS;
        at->toS = stampedS;
        for (auto later = at + 1; later != pieces.end(); ++later)
            later->lagS += changeS;
        pieces.insert(at + 1, behind);
        if (!withRate) // the offset is that at the clip's start, and goes with the rate
            for (LagPiece &piece : pieces)
                piece.lagS += offsetS;
        SteppedClocks more = made(std::move(pieces));
        if (more.steps() <= clocks.steps() || !isBetter(more, clocks))
            break;
        clocks = std::move(more);
    }
    for (std::size_t k = clocks.pieces.size(); k-- > 1;) {
        std::vector<LagPiece> pieces = clocks.pieces;
        pieces[k - 1].toS = pieces[k].toS;
        pieces.erase(pieces.begin() + std::ptrdiff_t(k));
        SteppedClocks fewer = made(std::move(pieces));
        if (isBetter(fewer, clocks))
            clocks = std::move(fewer);
        k = std::min(k, clocks.pieces.size());
    }
    return clocks;
}

} // namespace odo
