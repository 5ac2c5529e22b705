// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/step_finder.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace odo {

namespace {

constexpr double aroundS = 0.7;    ///< a jump, within which its moment is sought
constexpr double heldShare = 0.35; ///< of the way that a robot would go at its speed: it is held
constexpr double clearM = 0.008;   ///< of that way: less tells nothing
constexpr double gapS = 0.3;

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
    /// In a gap it is the beginning: a robot that leaps is lost there.
    static double split(const std::vector<TimedPosition> &track, double fromS, double toS,
                        const std::function<double(const TimedPosition &)> &before,
                        const std::function<double(const TimedPosition &)> &after)
    {
        const double frameS = medianStepS(track);
        double sum = 0, least = 0, bestS = (fromS + toS) / 2;
        bool isFirst = true;
        for (std::size_t i = 0; i < track.size(); ++i) {
            if (track[i].timeS < fromS || track[i].timeS > toS)
                continue;
            const double stepS = i + 1 < track.size() ? track[i + 1].timeS - track[i].timeS : 0;
            sum += before(track[i]) - after(track[i]);
            if (isFirst || sum < least) {
                least = sum;
                bestS = track[i].timeS + std::min(stepS, frameS) / 2;
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

} // namespace

FoundStep stepBetween(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                      const LagPiece &before, const LagPiece &after, double rate, double noiseM)
{
    return StepFinder(first, second, rate, noiseM).between(before, after);
}

} // namespace odo
