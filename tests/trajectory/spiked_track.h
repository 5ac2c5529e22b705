// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/trajectory/synthetic_trial.h"

#include <set>

namespace odo::test {

/// Runs at even speed, but turns back or aside within no time wherever it meets a wall of a box.
inline Course billiard(Eigen::Vector2d half, Eigen::Vector2d velocity)
{
    const auto axis = [](double halfWidth, double speed, double t) {
        const double phase = std::fmod(halfWidth + speed * t, 4 * halfWidth);
        const double folded = phase < 0 ? phase + 4 * halfWidth : phase;
        return folded < 2 * halfWidth ? folded - halfWidth : 3 * halfWidth - folded;
    };
    return [=](double t) {
        Truth truth;
        truth.position = {axis(half.x(), velocity.x(), t), axis(half.y(), velocity.y(), t)};
        return truth;
    };
}

/// Legs along a square with even acceleration and braking, and a rest at each corner.
inline Course hardStopAndGo(double sideM, double accelMps2, double restS)
{
    return [=](double t) {
        const double ramp = std::sqrt(sideM / accelMps2), leg = 2 * ramp + restS;
        const auto corners = std::array<Eigen::Vector2d, 4>{{{0, 0}, {sideM, 0}, {sideM, sideM}, {0, sideM}}};
        const auto number = static_cast<std::size_t>(std::max(0.0, t) / leg);
        const double run = std::min(std::max(0.0, t) - static_cast<double>(number) * leg, 2 * ramp);
        const double part =
            run < ramp ? accelMps2 * run * run / 2 : sideM - accelMps2 * std::pow(2 * ramp - run, 2) / 2;
        Truth truth;
        truth.position =
            corners[number % 4] + (corners[(number + 1) % 4] - corners[number % 4]) * (part / sideM);
        return truth;
    };
}

/// Meets a wall at full speed and comes back slower.
inline Course collision(double atS, double speedMps, double reboundMps)
{
    return [=](double t) {
        Truth truth;
        truth.position.x() = t < atS ? -1 + speedMps * t : -1 + speedMps * atS - reboundMps * (t - atS);
        return truth;
    };
}

inline Course evenLine(double speedMps)
{
    return [=](double t) { return Truth{{-1 + 0.8 * speedMps * t, 0.6 * speedMps * t}, {}, {}}; };
}

inline Course circle(double radiusM, double speedMps)
{
    return [=](double t) {
        const double w = speedMps / radiusM;
        return Truth{{radiusM * std::cos(w * t), radiusM * std::sin(w * t)}, {}, {}};
    };
}

/// A track with faults of which is known where they are.
struct SpikedTrack
{
    std::vector<Sample> samples;
    std::set<std::size_t> spikes;    ///< must be flagged
    std::set<std::size_t> uncertain; ///< displaced by less than is called a spike: either is right
};

/// Even frames of a course with white noise of a stated σ.
inline SpikedTrack sampled(const Course &course, double framesPerSecond, double durationS, double sigmaM,
                           std::mt19937 &random)
{
    SpikedTrack track;
    std::normal_distribution<double> noise(0, sigmaM);
    const auto count = static_cast<std::int64_t>(durationS * framesPerSecond);
    for (std::int64_t i = 0; i < count; ++i) {
        Sample sample;
        sample.frame = i;
        sample.time = fromSeconds(static_cast<double>(i) / framesPerSecond);
        sample.position =
            course(toSeconds(sample.time)).position + Eigen::Vector2d(noise(random), noise(random));
        sample.covariance = Eigen::Matrix2d::Identity() * sigmaM * sigmaM;
        sample.views = 1;
        track.samples.push_back(sample);
    }
    return track;
}

/// What is called a spike: 20 mm, or eight σ where that is more.
inline double leastSpikeM(const SpikedTrack &track)
{
    return std::max(0.02, 8 * std::sqrt(track.samples.front().covariance(0, 0)));
}

inline void displace(SpikedTrack &track, std::size_t index, const Eigen::Vector2d &by)
{
    if (index >= track.samples.size() || !track.samples[index].position)
        return;
    *track.samples[index].position += by;
    (by.norm() >= 0.999 * leastSpikeM(track) ? track.spikes : track.uncertain).insert(index);
}

/// True when nothing was displaced within some frames of [first, first + length). Faults stay further apart
/// than they are long: nobody could tell the true course between two that are not.
inline bool isFree(const SpikedTrack &track, std::size_t first, std::size_t length, std::size_t distance)
{
    for (std::size_t i = first > distance ? first - distance : 0; i < first + length + distance; ++i) {
        if (track.spikes.contains(i) || track.uncertain.contains(i))
            return false;
    }
    return true;
}

inline Eigen::Vector2d anyDirection(std::mt19937 &random)
{
    const double angle = std::uniform_real_distribution<double>(0, 2 * M_PI)(random);
    return {std::cos(angle), std::sin(angle)};
}

/// Stretches of `length` frames that are displaced evenly by `size` metres.
inline void addBursts(SpikedTrack &track, int count, std::pair<int, int> length,
                      std::pair<double, double> size, std::mt19937 &random)
{
    std::uniform_int_distribution<std::size_t> start(10, track.samples.size() - 30);
    std::uniform_int_distribution<int> frames(length.first, length.second);
    std::uniform_real_distribution<double> metres(size.first, size.second);
    for (int i = 0; i < count; ++i) {
        const std::size_t first = start(random);
        const auto run = static_cast<std::size_t>(frames(random));
        const Eigen::Vector2d by = metres(random) * anyDirection(random);
        if (!isFree(track, first, run, 12))
            continue;
        for (std::size_t k = 0; k < run; ++k)
            displace(track, first + k, by);
    }
}

/// The first or the last frames are displaced.
inline void addAtEnds(SpikedTrack &track, int longest, std::mt19937 &random)
{
    std::uniform_int_distribution<int> frames(1, longest);
    std::uniform_real_distribution<double> metres(0.08, 0.4);
    const Eigen::Vector2d early = metres(random) * anyDirection(random);
    const Eigen::Vector2d late = metres(random) * anyDirection(random);
    const int atStart = frames(random), atEnd = frames(random);
    for (int k = 0; k < atStart; ++k)
        displace(track, static_cast<std::size_t>(k), early);
    for (int k = 0; k < atEnd; ++k)
        displace(track, track.samples.size() - 1 - static_cast<std::size_t>(k), late);
}

/// The tracker is drawn away evenly over some time, and comes back at once or as evenly as it went.
inline void addDrifts(SpikedTrack &track, int count, bool atOnce, std::mt19937 &random)
{
    const double interval = toSeconds(track.samples[1].time - track.samples[0].time);
    std::uniform_int_distribution<std::size_t> start(15, track.samples.size() * 3 / 4);
    std::uniform_real_distribution<double> metres(0.1, 0.25), seconds(0.25, 0.5);
    for (int i = 0; i < count; ++i) {
        const std::size_t first = start(random);
        const auto run = static_cast<std::size_t>(seconds(random) / interval);
        const Eigen::Vector2d by = metres(random) * anyDirection(random);
        if (first < run + 12 || !isFree(track, first, run, run + 12))
            continue;
        for (std::size_t k = 0; k < run; ++k) {
            const double part = static_cast<double>(k + 1) / static_cast<double>(run);
            displace(track, first + k, (atOnce ? part : std::min(1.0, 2 * std::min(part, 1 - part))) * by);
        }
    }
}

/// The tracker stays on something where the robot passed, and snaps back.
inline void addCaptures(SpikedTrack &track, int count, std::mt19937 &random)
{
    const double interval = toSeconds(track.samples[1].time - track.samples[0].time);
    std::uniform_int_distribution<std::size_t> start(15, track.samples.size() * 3 / 4);
    std::uniform_real_distribution<double> seconds(0.15, 0.45);
    for (int i = 0; i < count; ++i) {
        const std::size_t first = start(random);
        const auto run = static_cast<std::size_t>(seconds(random) / interval);
        if (first < run + 12 || !isFree(track, first, run, run + 12))
            continue;
        const Eigen::Vector2d held = *track.samples[first - 1].position;
        std::normal_distribution<double> noise(0, std::sqrt(track.samples[0].covariance(0, 0)));
        for (std::size_t k = 0; k < run; ++k)
            displace(track, first + k,
                     held + Eigen::Vector2d(noise(random), noise(random)) -
                         *track.samples[first + k].position);
    }
}

/// Frames without a position, alone and in runs; a displaced one that goes is no spike any more.
inline void addGaps(SpikedTrack &track, double share, int longest, std::mt19937 &random)
{
    std::uniform_int_distribution<std::size_t> start(0, track.samples.size() - 1);
    std::uniform_int_distribution<int> frames(1, longest);
    const auto wanted = static_cast<std::size_t>(share * static_cast<double>(track.samples.size()));
    for (std::size_t lost = 0; lost < wanted;) {
        const std::size_t first = start(random);
        for (int k = frames(random); k > 0; --k, ++lost) {
            const std::size_t index = first + static_cast<std::size_t>(k);
            if (index >= track.samples.size())
                continue;
            track.samples[index].position.reset();
            track.samples[index].flags = flagBit(SampleFlag::Lost);
            track.spikes.erase(index);
            track.uncertain.erase(index);
        }
    }
}

} // namespace odo::test
