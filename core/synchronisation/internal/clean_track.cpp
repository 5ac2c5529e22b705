// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/clean_track.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

// of a robot that repeats itself
constexpr double stillPx = 0.06, stillShare = 0.06, leastStepPx = 0.4;
constexpr std::size_t mostStill = 6;

/// White noise of a coordinate, from third differences, which no robot's motion reaches.
double whiteNoisePx(const FrameTrack &track)
{
    constexpr double leastPx = 0.02, sigmaOfThird = 4.472, halfNormal = 0.6745; // √(1 + 9 + 9 + 1)
    std::vector<double> thirds;
    for (std::size_t i = 3; i < track.size(); ++i) {
        if (track[i].frame - track[i - 3].frame != 3)
            continue;
        const Eigen::Vector2d third =
            track[i].px - 3 * track[i - 1].px + 3 * track[i - 2].px - track[i - 3].px;
        thirds.push_back(std::abs(third.x()));
        thirds.push_back(std::abs(third.y()));
    }
    return thirds.empty() ? leastPx
                          : std::max(leastPx, median(std::move(thirds)) / (halfNormal * sigmaOfThird));
}

/// How many positions from index on repeat the one before it, or lie where it does, while the robot moves
/// before and after.
std::size_t stillAt(const FrameTrack &track, std::size_t index)
{
    std::size_t repeats = 0;
    while (index + repeats < track.size() && track[index + repeats].isRepeat)
        ++repeats;
    if (repeats > 0 || index < 2)
        return repeats;
    const Eigen::Vector2d in = track[index - 1].px - track[index - 2].px;
    for (std::size_t count = 1; count <= mostStill && index + count + 1 < track.size(); ++count) {
        const std::size_t last = index + count - 1;
        if (track[last + 2].frame - track[index - 2].frame != std::int64_t(count) + 3)
            return 0;
        const Eigen::Vector2d out = track[last + 2].px - track[last + 1].px, usual = (in + out) / 2;
        const double mostPx = std::max(stillPx, stillShare * usual.norm());
        if ((track[last].px - track[index - 1].px).norm() > mostPx)
            return 0;
        if ((track[last + 1].px - track[index - 1].px).norm() > mostPx)
            return usual.norm() >= leastStepPx && (in - out).norm() <= usual.norm() ? count : 0;
    }
    return 0;
}

std::int64_t countBetween(const std::vector<std::int64_t> &frames, std::int64_t after, std::int64_t before)
{
    return std::max<std::int64_t>(0, std::ranges::lower_bound(frames, before) -
                                         std::ranges::upper_bound(frames, after));
}

} // namespace

std::int64_t CleanTrack::repeatsBefore(std::size_t index) const
{
    return countBetween(repeats, positions[index - 1].frame, positions[index].frame);
}

bool CleanTrack::isSameImageBefore(std::size_t index) const
{
    const std::int64_t all = repeatsBefore(index);
    return all > 0 && countBetween(marked, positions[index - 1].frame, positions[index].frame) == all;
}

CleanTrack cleaned(const FrameTrack &track)
{
    CleanTrack clean;
    clean.noisePx = whiteNoisePx(track);
    for (std::size_t i = 0; i < track.size(); ++i) {
        const std::size_t still = stillAt(track, i);
        if (still == 0) {
            clean.positions.push_back(track[i]);
            continue;
        }
        for (const std::size_t end = i + still; i < end; ++i) {
            clean.repeats.push_back(track[i].frame);
            if (track[i].isRepeat)
                clean.marked.push_back(track[i].frame);
        }
        --i;
    }
    return clean;
}

} // namespace odo
