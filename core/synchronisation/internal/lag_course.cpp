// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/lag_course.h"

#include "core/base/percentile.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace odo {

namespace {

constexpr double independentS = 0.25; ///< what is left at moments further apart differs
constexpr float jumpCost = 12;
constexpr float apartCost = 8;  ///< of an independent moment at which the tracks don't match at all
constexpr float unseenCost = 5; ///< of one that the second view didn't see
constexpr double finestM = 0.0015, coarsestM = 0.03;
constexpr double velocityShare = 0.1; ///< of the usual speed, by which views differ
constexpr std::size_t mostMoments = 400;
constexpr int positionRounds = 2;
constexpr double mostScale = 0.05;

/// The second track at even times, backwards, so that it goes on as the lag does.
struct Backwards
{
    std::vector<std::optional<PositionAndVelocity>> at;
    std::vector<float> seen, x, y, variance; ///< of what is compared: positions or velocities
};

/// What the second track is compared with at a moment.
struct Target
{
    float x = 0, y = 0, variance = 0;
};

struct Grid
{
    double stepS = 0;       ///< between lags
    std::size_t stride = 1; ///< lag steps between the moments compared
    double fromS = 0;       ///< first moment
    std::size_t moments = 0;
    long lowest = 0, lags = 0; ///< in steps
    double weight = 0;         ///< of a moment among independent ones

    double momentS(std::size_t i) const { return fromS + double(i * stride) * stepS; }
    double lagS(std::size_t lag) const { return double(lowest + long(lag)) * stepS; }
};

class Course
{
public:
    Course(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
           const LagRange &range, double rate)
        : m_rate(rate)
    {
        m_grid.stepS = std::max(medianStepS(first), 1e-3) / 2;
        m_grid.fromS = first.front().timeS;
        const double spanS = first.back().timeS - m_grid.fromS;
        m_grid.stride = 1 + static_cast<std::size_t>(spanS / m_grid.stepS / double(mostMoments));
        m_grid.moments = 1 + static_cast<std::size_t>(spanS / m_grid.stepS / double(m_grid.stride));
        m_grid.lowest = std::lround(range.fromS / m_grid.stepS);
        m_grid.lags = std::lround(range.toS / m_grid.stepS) - m_grid.lowest + 1;
        m_grid.weight = std::min(1.0, double(m_grid.stride) * m_grid.stepS / independentS);
        for (std::size_t i = 0; i < m_grid.moments; ++i)
            m_first.push_back(trackAt(first, m_grid.momentS(i)));
        const auto count = long((m_grid.moments - 1) * m_grid.stride) + m_grid.lags;
        for (long k = count - 1; k >= 0; --k) {
            const double sinceStartS =
                m_grid.fromS + double(k - (m_grid.lags - 1) - m_grid.lowest) * m_grid.stepS;
            auto there = trackAt(second, sinceStartS * (1 + rate));
            if (there) {
                there->velocity *= 1 + rate;
                there->velocityVariance *= (1 + rate) * (1 + rate);
            }
            m_second.seen.push_back(there ? 1 : 0);
            m_second.at.push_back(std::move(there));
        }
        m_second.x.resize(m_second.at.size());
        m_second.y.resize(m_second.at.size());
        m_second.variance.resize(m_second.at.size());
    }

    LagCourse find(double noiseM)
    {
        double squares = 0, number = 0;
        for (const auto &one : m_first) {
            if (one) {
                squares += one->velocity.squaredNorm();
                ++number;
            }
        }
        const double usual = velocityShare * velocityShare * squares / std::max(1.0, number);
        compare([&](const PositionAndVelocity &b) {
            return Target{float(b.velocity.x()), float(b.velocity.y()), float(b.velocityVariance)};
        });
        walk([&](const PositionAndVelocity &a) {
            return Target{float(a.velocity.x()), float(a.velocity.y()),
                          float(std::max(a.velocityVariance + usual, 1e-8))};
        });
        for (int again = 0; again < positionRounds; ++again) {
            lieDown();
            if (noiseM > 0)
                m_noiseM = noiseM;
            compare([&](const PositionAndVelocity &b) {
                const Eigen::Vector2d point = m_lie.onFirst(b.point);
                return Target{float(point.x()), float(point.y()), 0};
            });
            walk([&](const PositionAndVelocity &a) {
                const double lagM2 = a.velocity.squaredNorm() * m_grid.stepS * m_grid.stepS / 12,
                             variance = 2 * m_noiseM * m_noiseM + lagM2;
                return Target{float(a.point.x()), float(a.point.y()), float(variance)};
            });
        }
        return course();
    }

private:
    std::size_t backwards(std::size_t moment, std::size_t lag) const
    {
        return (m_grid.moments - 1 - moment) * m_grid.stride + lag;
    }
    const std::optional<PositionAndVelocity> &secondAt(std::size_t moment, std::size_t lag) const
    {
        return m_second.at[backwards(moment, lag)];
    }

    template <class Compared>
    void compare(Compared compared)
    {
        for (std::size_t k = 0; k < m_second.at.size(); ++k) {
            if (!m_second.at[k])
                continue;
            const Target target = compared(*m_second.at[k]);
            m_second.x[k] = target.x;
            m_second.y[k] = target.y;
            m_second.variance[k] = target.variance;
        }
    }

    template <class Targeted>
    void walk(Targeted targeted)
    {
        const auto lags = static_cast<std::size_t>(m_grid.lags);
        const auto weight = static_cast<float>(m_grid.weight);
        std::vector<float> soFar(lags, 0);
        m_from.assign(m_grid.moments * lags, -1);
        for (std::size_t i = 0; i < m_grid.moments; ++i) {
            const auto least = std::min_element(soFar.begin(), soFar.end());
            const float jumped = i > 0 ? *least + jumpCost : HUGE_VALF;
            const auto from = static_cast<std::int32_t>(least - soFar.begin());
            std::int32_t *into = &m_from[i * lags];
            for (std::size_t lag = 0; lag < lags; ++lag) {
                into[lag] = jumped < soFar[lag] ? from : std::int32_t(lag);
                soFar[lag] = std::min(jumped, soFar[lag]);
            }
            if (!m_first[i])
                continue;
            const Target target = targeted(*m_first[i]);
            const std::size_t begin = backwards(i, 0);
            const float *seen = &m_second.seen[begin], *x = &m_second.x[begin], *y = &m_second.y[begin],
                        *variance = &m_second.variance[begin];
            for (std::size_t lag = 0; lag < lags; ++lag) {
                const float dx = target.x - x[lag], dy = target.y - y[lag];
                const float apart = (dx * dx + dy * dy) / (target.variance + variance[lag]);
                const float cost = std::min(apartCost, apart);
                soFar[lag] += weight * (unseenCost + seen[lag] * (cost - unseenCost));
            }
        }
        const auto least = std::min_element(soFar.begin(), soFar.end());
        m_cost = *least;
        m_lags.assign(m_grid.moments, 0);
        auto lag = static_cast<std::size_t>(least - soFar.begin());
        for (std::size_t i = m_grid.moments; i-- > 0;) {
            m_lags[i] = lag;
            lag = static_cast<std::size_t>(m_from[i * lags + lag]);
        }
    }

    double apartM(std::size_t moment, const PositionAndVelocity &second) const
    {
        return (m_first[moment]->point - m_lie.onFirst(second.point)).norm();
    }

    /// Shift, scale and noise of what lies on the path, without what lies far off.
    void lieDown()
    {
        m_lie = {};
        m_noiseM = 0;
        double farM = HUGE_VAL;
        for (int again = 0; again < 4; ++again) {
            Eigen::Vector2d first = Eigen::Vector2d::Zero(), second = Eigen::Vector2d::Zero();
            std::vector<std::size_t> taken;
            std::vector<double> apart;
            for (std::size_t i = 0; i < m_grid.moments; ++i) {
                const auto &other = secondAt(i, m_lags[i]);
                if (!m_first[i] || !other)
                    continue;
                const double thereM = apartM(i, *other);
                if (thereM > farM)
                    continue;
                apart.push_back(thereM);
                taken.push_back(i);
                first += m_first[i]->point;
                second += other->point;
            }
            if (taken.size() < 3)
                return;
            first /= double(taken.size());
            second /= double(taken.size());
            double across = 0, along = 0;
            for (const std::size_t i : taken) {
                const Eigen::Vector2d point = secondAt(i, m_lags[i])->point - second;
                along += point.dot(m_first[i]->point - first);
                across += point.squaredNorm();
            }
            m_lie.middle = second;
            m_lie.shift = first - second;
            m_lie.scale = across > 0 ? std::clamp(along / across - 1, -mostScale, mostScale) : 0;
            std::vector<double> left;
            for (const std::size_t i : taken)
                left.push_back(apartM(i, *secondAt(i, m_lags[i])));
            const double median = upperMedian(std::move(left));
            farM = 3 * std::max(median, finestM);
            m_noiseM = std::clamp(median / 1.1774, finestM, coarsestM); // of Rayleigh's distribution
        }
    }

    LagCourse course() const
    {
        LagCourse found;
        found.rate = m_rate;
        found.noiseM = m_noiseM;
        found.cost = m_cost;
        for (std::size_t i = 0; i < m_grid.moments; ++i) {
            if (!m_first[i] || !secondAt(i, m_lags[i]))
                continue;
            const double lagS = m_grid.lagS(m_lags[i]);
            if (found.pieces.empty() || found.pieces.back().lagS != lagS)
                found.pieces.push_back({m_grid.momentS(i), m_grid.momentS(i), lagS});
            found.pieces.back().toS = m_grid.momentS(i);
        }
        return found;
    }

    double m_rate;
    Grid m_grid;
    std::vector<std::optional<PositionAndVelocity>> m_first;
    Backwards m_second;
    Lie m_lie;
    double m_noiseM = 0;              ///< in a coordinate
    std::vector<std::int32_t> m_from; ///< for each moment and lag, the lag before
    std::vector<std::size_t> m_lags;  ///< of the path
    double m_cost = 0;
};

} // namespace

LagSearch::LagSearch(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                     const LagRange &range)
    : m_first(first), m_second(second), m_range(range)
{
}

LagCourse LagSearch::courseAt(double rate, double noiseM) const
{
    return Course(m_first, m_second, m_range, rate).find(noiseM);
}

} // namespace odo
