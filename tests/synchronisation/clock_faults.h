// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/clip_synchronisation.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace odo::test {

/// What is wrong with the time stamps of a pair of clips.
enum class ClockFault { None, LostInSecond, LostInFirst, LostInBoth, Doubled, Pause, Restart, Label, Drift };

/// Tracks of one robot in two views, of which one at least may have wrong time stamps, with the truth.
struct FaultyClips
{
    std::vector<TimedPosition> first, second;
    /// for each position when it was taken, by the first view's first frame
    std::vector<double> firstTakenS, secondTakenS;
    double offsetS = 0;
};

struct FaultSettings
{
    ClockFault fault = ClockFault::None;
    double durationS = 10, rate = 30, noiseM = 0.003, slowNoiseM = 0.002;
    double drift = 0;           ///< of the second clock
    bool isSlowedDrawn = false; ///< the drift is drawn
};

/// A robot that turns and changes its speed, never twice alike.
class DrawnCourse
{
public:
    explicit DrawnCourse(std::mt19937 &random)
    {
        std::uniform_real_distribution<double> phase(0, 2 * M_PI), pace(0.85, 1.15);
        for (double &one : m_phase)
            one = phase(random);
        m_pace = pace(random);
    }
    Eigen::Vector2d at(double t) const
    {
        t *= m_pace;
        return {0.55 * std::sin(0.61 * t + m_phase[0]) + 0.25 * std::sin(1.4 * t + m_phase[1]),
                0.45 * std::cos(0.53 * t + m_phase[2]) + 0.2 * std::sin(1.1 * t + m_phase[3])};
    }

private:
    double m_phase[4], m_pace = 1;
};

inline FaultyClips drawClips(const FaultSettings &settings, unsigned seed)
{
    std::mt19937 random(seed);
    const DrawnCourse course(random);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> noise(0, 1);
    FaultyClips clips;
    clips.offsetS = 2 * unit(random) - 1;
    const auto count = static_cast<int>(settings.durationS * settings.rate);
    const auto isIn = [&](ClockFault a, ClockFault b) { return settings.fault == a || settings.fault == b; };
    for (int view = 0; view < 2; ++view) {
        std::vector<int> repeats(std::size_t(count), 1);
        const bool loses = view == 1 ? isIn(ClockFault::LostInSecond, ClockFault::LostInBoth)
                                     : isIn(ClockFault::LostInFirst, ClockFault::LostInBoth);
        const auto changed = [&](int frames, int times) {
            const int at = int((0.15 + 0.7 * unit(random)) * count);
            for (int i = at; i < std::min(count, at + frames); ++i)
                repeats[std::size_t(i)] = times;
        };
        if (loses) {
            const int places = 1 + int(3 * unit(random));
            for (int i = 0; i < places; ++i)
                changed(1 + int(10 * unit(random) / places), 0);
        }
        if (settings.fault == ClockFault::Pause && view == 1)
            changed(int((0.3 + 1.7 * unit(random)) * settings.rate), 0);
        if (settings.fault == ClockFault::Doubled && view == 1)
            changed(1, 2 + int(6 * unit(random)));
        const int restartAt = int((0.2 + 0.6 * unit(random)) * count);
        const double restartS = (unit(random) < 0.5 ? -1 : 1) * (0.4 + 6 * unit(random));
        const Eigen::Vector2d shift = view * Eigen::Vector2d(0.03 * noise(random), 0.03 * noise(random));
        const double slowPhase = 6 * unit(random);
        const double startS = view == 1 ? clips.offsetS : 0;
        double pace = 1;
        if (view == 1 && settings.fault == ClockFault::Label)
            pace = 1.2;
        if (view == 1 && settings.fault == ClockFault::Drift)
            pace = 1 + settings.drift;
        int stamped = 0;
        for (int i = 0; i < count; ++i) {
            const double takenS = startS + i / settings.rate;
            const Eigen::Vector2d point = course.at(20 + takenS);
            const Eigen::Vector2d slow(std::sin(3 * point.x() + 2 * point.y() + slowPhase),
                                       std::cos(2.5 * point.x() - 3 * point.y() + slowPhase));
            const Eigen::Vector2d seen = point * (1 + 0.003 * view) + shift + settings.slowNoiseM * slow +
                                         settings.noiseM * Eigen::Vector2d(noise(random), noise(random));
            for (int again = 0; again < repeats[std::size_t(i)]; ++again) {
                double stampS = stamped++ * pace / settings.rate;
                if (settings.fault == ClockFault::Restart && view == 1 && i >= restartAt)
                    stampS += std::max(0.05, restartS); // readers never let times go back
                (view == 0 ? clips.first : clips.second).push_back({stampS, seen});
                (view == 0 ? clips.firstTakenS : clips.secondTakenS).push_back(takenS);
            }
        }
    }
    return clips;
}

/// How far the views' positions are apart in time where an answer brings them together: of the second view's
/// the largest error but for one in twenty, relative to the first view's clock as repaired. Both views lose
/// time of their own, so what counts is their relation.
inline double relationErrorS(const FaultyClips &clips, const ClipOffset &answer)
{
    // the repaired first stamps as a function of the moment of taking
    std::vector<double> errors;
    for (std::size_t i = 0; i < clips.second.size(); ++i) {
        const double commonS =
            answer.offsetS + answer.second.timeS(clips.second[i].timeS) / (1 + answer.rate);
        const double takenS = clips.secondTakenS[i];
        const auto at = std::lower_bound(clips.firstTakenS.begin(), clips.firstTakenS.end(), takenS);
        if (at == clips.firstTakenS.begin() || at == clips.firstTakenS.end())
            continue;
        const auto k = static_cast<std::size_t>(at - clips.firstTakenS.begin());
        if (clips.firstTakenS[k] - clips.firstTakenS[k - 1] > 0.06)
            continue; // the first view has no frame there
        const double shareOfStep =
            clips.firstTakenS[k] > clips.firstTakenS[k - 1]
                ? (takenS - clips.firstTakenS[k - 1]) / (clips.firstTakenS[k] - clips.firstTakenS[k - 1])
                : 0;
        const double beforeS = answer.first.timeS(clips.first[k - 1].timeS),
                     behindS = answer.first.timeS(clips.first[k].timeS);
        errors.push_back(std::abs(beforeS + shareOfStep * (behindS - beforeS) - commonS));
    }
    std::sort(errors.begin(), errors.end());
    return errors.empty() ? 0 : errors[errors.size() * 95 / 100];
}

} // namespace odo::test
