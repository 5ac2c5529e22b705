// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/trajectory/synthetic_trial.h"

#include <numbers>
#include <vector>

namespace odo::test {

/// A part of a drive, at rest at both ends: speed and turn rate rise to their largest value in its middle and
/// fall again, by (1 − cos)/2. A negative speed is backwards; one of 0 turns on the spot, or rests.
struct Drive
{
    double durationS = 1, largestMps = 0, largestRadps = 0;
};

/// The state of a robot on wheels at one time, from drives one after another; its body points along its path
/// or against it.
struct DrivenState
{
    Truth truth;
    double turnRateRadps = 0;
};

/// Positions are integrated in steps of 0.1 ms, the rest is in closed form.
class DrivenCourse
{
public:
    DrivenCourse(std::vector<Drive> drives, Eigen::Vector2d start, double headingRad)
        : m_drives(std::move(drives))
    {
        Eigen::Vector2d position = start;
        for (double t = 0; t < durationS(); t += stepS) {
            m_positions.push_back(position);
            const auto [speed, turned, rate] = motionAt(t + stepS / 2);
            position += stepS * speed * direction(headingRad + turned);
        }
        m_positions.push_back(position);
        m_headingRad = headingRad;
    }

    double durationS() const
    {
        double whole = 0;
        for (const Drive &drive : m_drives)
            whole += drive.durationS;
        return whole;
    }
    DrivenState at(double timeS) const
    {
        const auto [speed, turned, rate] = motionAt(timeS);
        DrivenState state;
        const auto index = static_cast<std::size_t>(std::max(0.0, timeS) / stepS + 0.5);
        state.truth.position = m_positions[std::min(index, m_positions.size() - 1)];
        state.truth.headingRad = m_headingRad + turned;
        state.truth.velocity = speed * direction(*state.truth.headingRad);
        state.turnRateRadps = rate;
        return state;
    }
    Course course() const
    {
        return [*this](double timeS) { return at(timeS).truth; };
    }

private:
    static constexpr double stepS = 1e-4;
    struct Moment
    {
        double speedMps = 0, turnedRad = 0, turnRateRadps = 0;
    };

    static Eigen::Vector2d direction(double angleRad) { return {std::cos(angleRad), std::sin(angleRad)}; }
    Moment motionAt(double timeS) const
    {
        Moment moment;
        for (const Drive &drive : m_drives) {
            const double share = std::clamp(timeS / drive.durationS, 0.0, 1.0),
                         phase = 2 * std::numbers::pi * share, part = (1 - std::cos(phase)) / 2;
            moment.turnedRad +=
                drive.largestRadps * drive.durationS * (share / 2 - std::sin(phase) / (4 * std::numbers::pi));
            if (timeS > 0 && timeS < drive.durationS) {
                moment.speedMps = drive.largestMps * part;
                moment.turnRateRadps = drive.largestRadps * part;
            }
            timeS -= drive.durationS;
        }
        return moment;
    }

    std::vector<Drive> m_drives;
    std::vector<Eigen::Vector2d> m_positions;
    double m_headingRad = 0;
};

/// Forward, a spin on the spot to the left, backwards in a curve, a spin to the right, a rest,
/// and forward in a curve: 10 s.
inline DrivenCourse spinsAndReverses()
{
    return DrivenCourse(
        {{2, 0.8, 0}, {1.5, 0, 2.5}, {2.5, -0.6, 0.5}, {1.5, 0, -4}, {0.5, 0, 0}, {2, 0.7, -0.6}},
        {-0.3, 0.1}, 0.4);
}

} // namespace odo::test
