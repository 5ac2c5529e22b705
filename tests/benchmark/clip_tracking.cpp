// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/clip_tracking.h"

#include "core/video/video_reader.h"
#include "tests/benchmark/cpu_clock.h"

#include <algorithm>

namespace odo::test {

TrackedClip trackClip(const BenchmarkClip &clip, std::size_t robots, bool shown)
{
    TrackedClip result;
    const auto reader = VideoReader::open(clip.file);
    const auto tracker = ColourTracker::create(clip.targets(robots));
    if (!reader || !tracker)
        return result;
    const std::vector<Nanoseconds> &times = (*reader)->info().frameTimes;
    for (const Nanoseconds time : times) {
        const double begin = threadCpuS();
        const auto region = shown ? std::nullopt : (*tracker)->neededRegion(time);
        const auto frame = (*reader)->next(region);
        if (!frame || !*frame)
            break;
        const double decoded = threadCpuS();
        const std::vector<Observation> seen = (*tracker)->track(**frame);
        result.afterS += workS(decoded, threadCpuS());
        result.decodeS += workS(begin, decoded);
        auto &centres = result.centres.emplace_back();
        for (const Observation &observation : seen)
            centres.push_back(observation.found ? std::optional(observation.ellipse.centrePx) : std::nullopt);
        ++result.frames;
    }
    return result;
}

CentreErrors centreErrors(const BenchmarkClip &clip, const TrackedClip &tracked)
{
    CentreErrors errors;
    std::vector<double> distances;
    for (std::size_t frame = 0; frame < tracked.centres.size(); ++frame) {
        for (std::size_t robot = 0; robot < tracked.centres[frame].size(); ++robot) {
            const auto &centre = tracked.centres[frame][robot];
            if (centre)
                distances.push_back(
                    (*centre - clip.trueCentre(robot, static_cast<std::int64_t>(frame))).norm());
            else
                ++errors.notFound;
        }
    }
    errors.places = static_cast<std::int64_t>(distances.size());
    if (distances.empty())
        return errors;
    std::sort(distances.begin(), distances.end());
    for (const double distance : distances)
        errors.meanPx += distance / static_cast<double>(distances.size());
    errors.p95Px = distances[static_cast<std::size_t>(0.95 * static_cast<double>(distances.size() - 1))];
    return errors;
}

} // namespace odo::test
