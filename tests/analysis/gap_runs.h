// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/imported_track.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace odo::test {

/// The course of a robot: a rectangle with round corners around the origin, anticlockwise, by the distance
/// along it from the middle of its lower side.
struct RoundedRectangle
{
    double lengthM = 1.2, widthM = 0.8, radiusM = 0.2;

    double around() const { return 2 * (straight(0) + straight(1)) + 2 * M_PI * radiusM; }
    Eigen::Vector2d at(double distanceM) const
    {
        double rest = std::fmod(distanceM, around());
        if (rest < 0)
            rest += around();
        Eigen::Vector2d place(0, -widthM / 2), ahead(1, 0);
        rest += straight(0) / 2;
        place.x() = -straight(0) / 2;
        for (int side = 0; side < 5; ++side) {
            const double along = straight(side % 2);
            if (rest <= along)
                return place + rest * ahead;
            rest -= along;
            place += along * ahead;
            const Eigen::Vector2d left(-ahead.y(), ahead.x());
            const double angle = rest / radiusM;
            if (angle <= M_PI / 2)
                return place + radiusM * (std::sin(angle) * ahead + (1 - std::cos(angle)) * left);
            rest -= M_PI / 2 * radiusM;
            place += radiusM * (ahead + left);
            ahead = left;
        }
        return place;
    }
    /// On a corner, or by so much next to one.
    bool isTurning(double distanceM) const
    {
        constexpr double step = 0.01;
        const Eigen::Vector2d before = at(distanceM) - at(distanceM - step),
                              after = at(distanceM + step) - at(distanceM);
        return std::abs(before.x() * after.y() - before.y() * after.x()) > 0.01 * step * step;
    }

private:
    double straight(int side) const { return (side == 0 ? lengthM : widthM) - 2 * radiusM; }
};

/// Where its gaps are.
enum class GapsAt { Standing, Straight, Turning, Starting, Anywhere };
inline constexpr std::array<const char *, 5> gapsAtNames{"standing", "straight", "turning",
                                                         "starting, stopping", "anywhere"};

/// A run with gaps: its true results, and the track of it that was measured.
struct GapRun
{
    RoundedRectangle course;
    std::vector<double> distances; ///< true, one a millisecond
    double startS = 0, endS = 0;
    int stops = 0, laps = 0;
    std::vector<std::pair<double, double>> gapsS;
    std::vector<ImportedPosition> track;

    double pathM() const { return distances.back() - distances.front(); }
    double meanSpeedMps() const { return pathM() / (endS - startS); }
};

/// Draws runs of 20 to 45 s, each from its number: one to five gaps of 0.2 to 4 s, with rows that hold no
/// position or without rows, noise of 0.3 to 3 mm, 30 or 60 positions a second.
class GapRunMaker
{
public:
    explicit GapRunMaker(unsigned number)
        : m_random(number), m_at(static_cast<GapsAt>(number % gapsAtNames.size())),
          m_hasRows(number / gapsAtNames.size() % 2 == 0)
    {
    }

    GapRun make()
    {
        m_run.course = {between(1.2, 2.2), between(0.9, 1.6), between(0.1, 0.4)};
        drive();
        for (int i = 0, count = 1 + static_cast<int>(between(0, 5)); i < count; ++i)
            addGap();
        measure();
        return m_run;
    }
    GapsAt gapsAt() const { return m_at; }

private:
    static constexpr double stepS = 1e-3;

    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(m_random);
    }
    double nowS() const { return stepS * static_cast<double>(m_run.distances.size()); }
    void stay(double forS)
    {
        for (const double end = nowS() + forS; nowS() < end;) {
            m_distance += m_speed * stepS;
            m_run.distances.push_back(m_distance);
        }
    }
    void changeSpeed(double to, double accel)
    {
        m_changes.push_back(nowS());
        const double step = std::copysign(accel * stepS, to - m_speed);
        while (std::abs(to - m_speed) > std::abs(step)) {
            m_speed += step;
            stay(stepS / 2);
        }
        m_speed = to;
    }
    void stand(double forS)
    {
        m_rests.push_back(nowS() + forS / 2);
        stay(forS);
    }
    void drive()
    {
        constexpr double sidewaysMps2 = 1.5;
        const double fastest = std::min(0.8, std::sqrt(sidewaysMps2 * m_run.course.radiusM));
        m_distance = -between(0.1, 0.5);
        stand(1.5);
        m_run.startS = nowS();
        for (const double until = between(16, 38); nowS() < until;) {
            changeSpeed(between(0.25, 1) * fastest, between(0.4, 2));
            stay(between(0.8, 4));
            if (between(0, 1) < 0.3) {
                changeSpeed(0, between(0.4, 2));
                stand(between(0.8, 2.5));
                m_run.stops += 1;
            }
        }
        changeSpeed(0.8 * fastest, 1);
        stay(1);
        changeSpeed(0, 1);
        m_run.endS = nowS();
        stand(1.5);
        const double around = m_run.course.around();
        // It passes the line at 0 first, which begins a lap.
        m_run.laps = static_cast<int>(std::floor(m_distance / around));
    }
    double momentForGap()
    {
        for (;;) {
            const double at = between(1, nowS() - 1);
            const double distance = m_run.distances[static_cast<std::size_t>(at / stepS)];
            const bool isTurning = m_run.course.isTurning(distance);
            switch (m_at) {
            case GapsAt::Standing:
                return m_rests[static_cast<std::size_t>(between(0, double(m_rests.size())))] + between(-1, 1);
            case GapsAt::Starting:
                return m_changes[static_cast<std::size_t>(between(0, double(m_changes.size())))] +
                       between(-1, 1);
            case GapsAt::Straight:
            case GapsAt::Turning:
                if (isTurning != (m_at == GapsAt::Turning))
                    continue;
                return at;
            case GapsAt::Anywhere:
                return at;
            }
        }
    }
    void addGap()
    {
        constexpr double apartS = 0.3;
        for (int tries = 0; tries < 100; ++tries) {
            const double length = between(0, 1) < 0.5 ? between(0.2, 1.5) : between(1.5, 4);
            const double from = momentForGap() - length / 2, to = from + length;
            const bool isFree =
                std::ranges::none_of(m_run.gapsS, [&](const std::pair<double, double> &other) {
                    return from < other.second + apartS && other.first - apartS < to;
                });
            if (from < apartS || to > nowS() - apartS || !isFree)
                continue;
            m_run.gapsS.emplace_back(from, to);
            return;
        }
    }
    void measure()
    {
        const double perSecond = between(0, 1) < 0.5 ? 30 : 60;
        std::normal_distribution<double> noise(0, std::pow(10, between(-3.523, -2.523)));
        for (int i = 0; i / perSecond < nowS(); ++i) {
            const double timeS = i / perSecond;
            const bool isHidden =
                std::ranges::any_of(m_run.gapsS, [timeS](const std::pair<double, double> &gap) {
                    return gap.first < timeS && timeS < gap.second;
                });
            ImportedPosition row;
            row.time = fromSeconds(timeS);
            const auto at = std::min(static_cast<std::size_t>(timeS / stepS), m_run.distances.size() - 1);
            const Eigen::Vector2d place =
                m_run.course.at(m_run.distances[at]) + Eigen::Vector2d(noise(m_random), noise(m_random));
            if (!isHidden)
                row.position = place;
            if (!isHidden || m_hasRows)
                m_run.track.push_back(row);
        }
    }

    std::mt19937 m_random;
    GapsAt m_at;
    bool m_hasRows;
    GapRun m_run;
    double m_distance = 0, m_speed = 0;
    std::vector<double> m_rests, m_changes;
};

} // namespace odo::test
