// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/frame_continuity.h"

#include "tests/trajectory/synthetic_trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace odo::test {

/// What becomes of the frames of one view, all stamped evenly; or what the robot does that looks like it.
enum class FrameFault {
    None,
    Lost,
    Doubled,
    SameImage, ///< doubled, and not coded once more
    Frozen,
    Pause,
    LongFrozen,
    Converted,
    StopAndGo,
    Struck,
    Hidden
};

/// A view's observations of a robot, with the truth.
struct FaultyView
{
    std::vector<Observation> observations;
    std::vector<Nanoseconds> frameTimes;
    std::vector<double> takenS; ///< of each frame
    /// a frame, and how many were lost (or doubled: negative) before it; the robot's speed there
    struct Step
    {
        std::int64_t frame = 0, lost = 0;
        double speedMps = 0;
    };
    std::vector<Step> steps;
    double topSpeedMps = 0, rate = 30;
    int every = 6; ///< of a converted video: one frame in so many repeats the one before
};

/// A robot's way in steps of a millisecond: it turns and changes its speed, or stops, starts and is struck,
/// with at most 8 m/s².
class DrawnWay
{
public:
    DrawnWay(FrameFault fault, std::mt19937 &random)
    {
        std::uniform_real_distribution<double> unit(0, 1);
        const double phases[4] = {6 * unit(random), 6 * unit(random), 6 * unit(random), 6 * unit(random)};
        const double pace = 0.85 + 0.3 * unit(random), accel = 1 + 7 * unit(random),
                     fastest = 0.2 + 0.8 * unit(random);
        const bool isAbrupt = fault == FrameFault::StopAndGo || fault == FrameFault::Struck;
        Eigen::Vector2d place(0, 0);
        double heading = 6 * unit(random), speed = 0, wanted = fastest, nextS = 0;
        for (int ms = 0; ms < 16000; ++ms) {
            const double t = 20 + pace * ms / 1000.0;
            if (!isAbrupt) {
                m_places.emplace_back(
                    0.55 * std::sin(0.61 * t + phases[0]) + 0.25 * std::sin(1.4 * t + phases[1]),
                    0.45 * std::cos(0.53 * t + phases[2]) + 0.2 * std::sin(1.1 * t + phases[3]));
                continue;
            }
            if (ms >= 1000 * nextS) {
                nextS += 0.05 + unit(random);
                if (fault == FrameFault::StopAndGo) {
                    wanted = wanted > 0 ? 0 : fastest * (0.3 + 0.7 * unit(random));
                } else {
                    heading += 6 * (unit(random) - 0.5);
                    speed *= unit(random);
                }
            }
            if (place.norm() > 0.8) // back to the middle
                heading = std::atan2(-place.y(), -place.x());
            speed += std::clamp(wanted - speed, -accel / 1000, accel / 1000);
            place += speed / 1000 * Eigen::Vector2d(std::cos(heading), std::sin(heading));
            m_places.push_back(place);
        }
    }
    Eigen::Vector2d at(double timeS) const
    {
        const double ms = std::clamp(1000 * timeS, 0.0, double(m_places.size()) - 2);
        const auto before = std::size_t(ms);
        return m_places[before] + (ms - double(before)) * (m_places[before + 1] - m_places[before]);
    }
    double speedAt(double timeS) const { return (at(timeS + 0.005) - at(timeS - 0.005)).norm() / 0.01; }

private:
    std::vector<Eigen::Vector2d> m_places;
};

class FrameFaultDrawer
{
public:
    FrameFaultDrawer(FrameFault fault, unsigned seed) : m_fault(fault), m_random(seed), m_way(fault, m_random)
    {
        m_view.rate = std::array{15.0, 25.0, 30.0, 30.0, 60.0}[m_random() % 5];
        m_noisePx = 0.03 + 0.12 * unit();
        m_view.every = 5 + int(seed % 2);
    }
    /// Once: it draws on.
    FaultyView draw()
    {
        const double takenRate = m_fault == FrameFault::Converted
                                     ? m_view.rate * double(m_view.every - 1) / double(m_view.every)
                                     : m_view.rate;
        const auto count = std::size_t(10 * takenRate);
        const std::vector<int> repeats = repeatsOf(count);
        const double hiddenFromS = 2 + 5 * unit();
        int before = 1; // frames since the last that was shown
        for (std::size_t i = 0; i < count; ++i, ++before) {
            const double takenS = double(i) / takenRate;
            for (int again = 0; again < repeats[i]; ++again) {
                const std::int64_t lost = again > 0 ? 0 : before - 1;
                if (lost > 0)
                    note(lost, takenS);
                addFrame(takenS, again > 0, hiddenFromS);
            }
            if (repeats[i] > 1 && isDoubled())
                note(1 - repeats[i], takenS);
            if (repeats[i] > 0)
                before = 0;
            m_view.topSpeedMps = std::max(m_view.topSpeedMps, m_way.speedAt(takenS));
        }
        return m_view;
    }

private:
    bool isDoubled() const { return m_fault == FrameFault::Doubled || m_fault == FrameFault::SameImage; }
    double unit() { return std::uniform_real_distribution<double>(0, 1)(m_random); }
    double normal() { return std::normal_distribution<double>(0, 1)(m_random); }
    void note(std::int64_t lost, double takenS)
    {
        m_view.steps.push_back({std::int64_t(m_view.observations.size()), lost, m_way.speedAt(takenS)});
    }

    /// How often each frame is shown.
    std::vector<int> repeatsOf(std::size_t count)
    {
        std::vector<int> repeats(count, 1);
        if (m_fault == FrameFault::Converted) {
            for (std::size_t i = 3; i < count; i += std::size_t(m_view.every - 1))
                repeats[i] = 2;
            return repeats;
        }
        const bool isLong = m_fault == FrameFault::Pause || m_fault == FrameFault::LongFrozen;
        const int places = isLong ? 1 : 1 + int(3 * unit());
        for (int place = 0; place < places; ++place) {
            // one in each third, so that none spoils another
            const auto at = std::size_t((0.1 + (place + 0.8 * unit()) * 0.8 / places) * double(count));
            if (m_fault == FrameFault::Lost)
                std::fill_n(repeats.begin() + std::ptrdiff_t(at), 1 + int(10 * unit()), 0);
            if (m_fault == FrameFault::Pause)
                std::fill_n(repeats.begin() + std::ptrdiff_t(at), int((0.6 + 1.4 * unit()) * m_view.rate), 0);
            if (isDoubled())
                repeats[at] = 2 + int(4 * unit());
            if (m_fault == FrameFault::LongFrozen && place == 0) {
                const int frozen = int((0.3 + 0.9 * unit()) * m_view.rate);
                repeats[at] = 1 + frozen;
                std::fill_n(repeats.begin() + std::ptrdiff_t(at) + 1, frozen, 0);
            }
            if (m_fault == FrameFault::Frozen) { // and the frames after it are not shown
                const int frozen = 1 + int(4 * unit());
                repeats[at] = 1 + frozen;
                std::fill_n(repeats.begin() + std::ptrdiff_t(at) + 1, frozen, 0);
            }
        }
        return repeats;
    }

    void addFrame(double takenS, bool isAgain, double hiddenFromS)
    {
        Observation seen = isAgain ? m_view.observations.back() : seenAt(takenS, hiddenFromS);
        seen.duplicateFrame = isAgain && m_fault == FrameFault::SameImage;
        if (isAgain && !seen.duplicateFrame) // coded once more
            seen.ellipse.centrePx += 0.01 * Eigen::Vector2d(normal(), normal());
        seen.frame = std::int64_t(m_view.observations.size());
        seen.time = fromSeconds(double(seen.frame) / m_view.rate);
        m_view.observations.push_back(seen);
        m_view.frameTimes.push_back(seen.time);
        m_view.takenS.push_back(takenS);
    }

    Observation seenAt(double takenS, double hiddenFromS)
    {
        constexpr double lengthM = 0.2, hiddenM = 0.5;
        const FloorView view = cameraA();
        Eigen::Vector2d place = m_way.at(takenS);
        const double alike = std::exp(-(place - m_last).norm() / 0.1);
        m_last = place;
        m_slow =
            alike * m_slow + std::sqrt(1 - alike * alike) * m_noisePx * Eigen::Vector2d(normal(), normal());
        double share = 1;
        if (m_fault == FrameFault::Hidden) { // by a board across its way, half a metre wide
            const Eigen::Vector2d from = m_way.at(hiddenFromS), along = m_way.at(hiddenFromS + 0.01) - from;
            const double beyond = (place - from).dot(along.normalized());
            const double rear = std::clamp(beyond + lengthM / 2, 0.0, lengthM),
                         front = std::clamp(hiddenM - (beyond - lengthM / 2), 0.0, lengthM);
            if (beyond > -lengthM / 2 && beyond < hiddenM + lengthM / 2) {
                const double rearSeen = lengthM - rear, frontSeen = lengthM - front;
                share = std::max(rearSeen, frontSeen) / lengthM;
                place += along.normalized() * (1 - share) * lengthM / 2 * (rearSeen > frontSeen ? -1 : 1);
            }
        }
        const auto pixel = view.pixelFromWorld({place.x(), place.y(), 0.03});
        Observation seen;
        seen.found = pixel && share > 0.05;
        if (!seen.found)
            return seen;
        const double depth = (view.worldFromCamera().translation.head<2>() - place).norm();
        seen.ellipse.centrePx = *pixel + m_slow + m_noisePx * Eigen::Vector2d(normal(), normal());
        seen.ellipse.semiMajorPx = 40;
        seen.ellipse.semiMinorPx = 25;
        seen.areaPx = 3000 * share * std::pow(3.4 / depth, 2) * (1 + 0.005 * normal());
        seen.centreCovariancePx2 = Eigen::Matrix2d::Identity() * 2 * m_noisePx * m_noisePx;
        seen.score = 0.9;
        return seen;
    }

    FrameFault m_fault;
    std::mt19937 m_random;
    DrawnWay m_way;
    double m_noisePx = 0;
    Eigen::Vector2d m_last = Eigen::Vector2d::Zero(), m_slow = Eigen::Vector2d::Zero();
    FaultyView m_view;
};

} // namespace odo::test
