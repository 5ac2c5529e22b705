// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/internal/slow_motion.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double sigmasOfChord = 10, sigmasOfSpeed = 6;

double meanSpeed(const std::vector<RunInstant> &instants, const MotionStretch &motion)
{
    return lengthOf(motion, instants) / std::max(1e-9, motion.stopS - motion.startS);
}

bool hasGap(const std::vector<RunInstant> &instants, std::size_t first, std::size_t last)
{
    return std::any_of(instants.begin() + static_cast<std::ptrdiff_t>(first + 1),
                       instants.begin() + static_cast<std::ptrdiff_t>(last + 1),
                       [](const RunInstant &instant) { return !instant.joined; });
}

/// The first from one instant on (step −1 or 1) that is clear of noise from where that was.
std::size_t leaves(const std::vector<RunInstant> &instants, std::size_t from, std::size_t end, int step)
{
    constexpr double sigmas = 2;
    std::size_t at = from;
    while (at != end && distanceBetween(instants[from], instants[at]) <=
                            sigmas * sigmaOfDistance(instants[from], instants[at]))
        at = step < 0 ? at - 1 : at + 1;
    return at;
}

bool getsOnSteadily(const std::vector<RunInstant> &instants, std::size_t first, std::size_t last)
{
    constexpr std::size_t parts = 4;
    constexpr double leastShare = 0.3; // of the mean progress
    if (last - first < parts)
        return false;
    const Eigen::Vector2d whole = instants[last].point->position - instants[first].point->position;
    for (std::size_t part = 0; part < parts; ++part) {
        const Eigen::Vector2d step = instants[first + (last - first) * (part + 1) / parts].point->position -
                                     instants[first + (last - first) * part / parts].point->position;
        if (step.dot(whole) * parts < leastShare * whole.squaredNorm())
            return false;
    }
    return true;
}

/// In a rest without a gap.
std::optional<MotionStretch> motionInRest(const std::vector<RunInstant> &instants, std::size_t first,
                                          std::size_t last)
{
    constexpr double leastTimeS = 2; // within less a robot that brakes comes to rest
    if (!isApart(instants[first], instants[last]))
        return std::nullopt;
    const std::size_t from = leaves(instants, first, last, 1), to = leaves(instants, last, first, -1);
    if (from >= to || instants[to].timeS - instants[from].timeS < leastTimeS ||
        !getsOnSteadily(instants, from, to))
        return std::nullopt;
    // What it did until it was clear of noise belongs to it, by the same speed.
    const double speed =
        distanceBetween(instants[from], instants[to]) / (instants[to].timeS - instants[from].timeS);
    const double before = distanceBetween(instants[first], instants[from]) / speed,
                 behind = distanceBetween(instants[to], instants[last]) / speed;
    std::size_t begin = from, end = to;
    while (begin > first && instants[from].timeS - instants[begin].timeS < before)
        --begin;
    while (end < last && instants[end].timeS - instants[to].timeS < behind)
        ++end;
    return MotionStretch{begin, end, instants[begin].timeS, instants[end].timeS, speed, speed};
}

bool isSlow(const std::vector<RunInstant> &instants, const MotionStretch &motion)
{
    double speeds = 0, sigmas = 0;
    for (std::size_t i = motion.first; i <= motion.last; ++i) {
        speeds += instants[i].point->speedMps;
        sigmas += instants[i].point->sigmaSpeedMps;
    }
    return speeds <= sigmasOfSpeed * sigmas;
}

/// The outermost instant from one end of a slow motion on (step −1 or 1) up to which the robot got on by more
/// than half as far as with its speed.
std::size_t outermost(const std::vector<RunInstant> &instants, std::size_t from, int step, std::size_t end,
                      double speedMps)
{
    std::size_t found = from;
    for (std::size_t at = from; at != end && instants[step < 0 ? at : at + 1].joined;) {
        at = step < 0 ? at - 1 : at + 1;
        const double timeS = std::abs(instants[at].timeS - instants[from].timeS);
        if (distanceBetween(instants[from], instants[at]) > speedMps * timeS / 2)
            found = at;
    }
    return found;
}

/// Slow motions begin and end where they are clear of noise, and have gone on for some time then.
void extendSlow(const std::vector<RunInstant> &instants, std::vector<MotionStretch> &motions)
{
    for (std::size_t i = 0; i < motions.size(); ++i) {
        MotionStretch &motion = motions[i];
        if (!isSlow(instants, motion))
            continue;
        const double speed = meanSpeed(instants, motion);
        const std::size_t first =
                              outermost(instants, motion.first, -1, i > 0 ? motions[i - 1].last : 0, speed),
                          last = outermost(
                              instants, motion.last, 1,
                              i + 1 < motions.size() ? motions[i + 1].first : instants.size() - 1, speed);
        if (first != motion.first) {
            motion.first = first;
            motion.startS = instants[first].timeS;
            motion.startMps = speed;
        }
        if (last != motion.last) {
            motion.last = last;
            motion.stopS = instants[last].timeS;
            motion.stopMps = speed;
        }
    }
}

bool goesOn(const std::vector<RunInstant> &instants, const MotionStretch &a, const MotionStretch &b)
{
    if (hasGap(instants, a.last, b.first))
        return false;
    const double speed = std::min(meanSpeed(instants, a), meanSpeed(instants, b)),
                 timeS = instants[b.first].timeS - instants[a.last].timeS;
    return distanceBetween(instants[a.last], instants[b.first]) > speed * timeS / 2;
}

} // namespace

std::vector<MotionStretch> withSlowMotions(const std::vector<RunInstant> &instants,
                                           const std::vector<MotionStretch> &motions)
{
    std::vector<MotionStretch> all;
    MotionStretch before; // the last one that was added, before it became part of another
    const auto add = [&](const MotionStretch &motion) {
        if (!all.empty() && goesOn(instants, before, motion)) {
            all.back().last = motion.last;
            all.back().stopS = motion.stopS;
            all.back().stopMps = motion.stopMps;
        } else {
            all.push_back(motion);
        }
        before = motion;
    };
    const auto addRest = [&](std::size_t first, std::size_t end) {
        while (first < end) { // parts without a gap
            std::size_t last = first;
            while (last + 1 < end && instants[last + 1].joined)
                ++last;
            if (const auto motion = motionInRest(instants, first, last))
                add(*motion);
            first = last + 1;
        }
    };
    std::size_t next = 0; // the first instant behind the last motion
    for (const MotionStretch &motion : motions) {
        addRest(next, motion.first);
        add(motion);
        next = motion.last + 1;
    }
    addRest(next, instants.size());
    extendSlow(instants, all);
    return all;
}

std::optional<std::vector<double>> slowDistances(const std::vector<RunInstant> &instants,
                                                 const MotionStretch &motion)
{
    if (!isSlow(instants, motion))
        return std::nullopt;
    std::vector<std::size_t> corners{motion.first};
    for (std::size_t i = motion.first + 1; i <= motion.last; ++i) {
        const RunInstant &corner = instants[corners.back()];
        if (distanceBetween(corner, instants[i]) > sigmasOfChord * sigmaOfDistance(corner, instants[i]))
            corners.push_back(i);
    }
    if (corners.size() > 1)
        corners.back() = motion.last; // what is left over is too short by itself
    else
        corners.push_back(motion.last);
    std::vector<double> distances{0};
    for (std::size_t c = 1; c < corners.size(); ++c) {
        const RunInstant &from = instants[corners[c - 1]], &to = instants[corners[c]];
        const double before = distances.back(), chord = distanceBetween(from, to),
                     timeS = std::max(1e-9, to.timeS - from.timeS);
        for (std::size_t i = corners[c - 1] + 1; i <= corners[c]; ++i)
            distances.push_back(before + chord * (instants[i].timeS - from.timeS) / timeS);
    }
    return distances;
}

} // namespace odo
