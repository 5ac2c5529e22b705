// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/driven_way.h"

#include <algorithm>

namespace odo {

std::vector<double> waysOf(const MotionStretch &motion, const std::vector<RunInstant> &instants)
{
    const auto speed = [&](std::size_t i) { return instants[i].point->speedMps; };
    const RunInstant &first = instants[motion.first];
    double way = (first.thresholdMps + speed(motion.first)) / 2 * (first.timeS - motion.startS);
    std::vector<double> ways{way};
    for (std::size_t i = motion.first; i < motion.last; ++i) {
        way += (speed(i) + speed(i + 1)) / 2 * (instants[i + 1].timeS - instants[i].timeS);
        ways.push_back(way);
    }
    return ways;
}

double lengthOf(const MotionStretch &motion, const std::vector<RunInstant> &instants)
{
    const RunInstant &last = instants[motion.last];
    return waysOf(motion, instants).back() +
           (last.thresholdMps + last.point->speedMps) / 2 * (motion.stopS - last.timeS);
}

std::vector<double> drivenWay(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points)
{
    std::vector<double> ways(samples.size(), 0);
    const std::vector<RunInstant> instants = validInstants(samples, points);
    const auto sampleOf = [&](std::size_t instant) {
        return static_cast<std::size_t>(instants[instant].point - points.data());
    };
    double before = 0;
    std::size_t next = 0; // first sample whose way is not set
    for (const MotionStretch &motion : findMotions(instants)) {
        const std::vector<double> own = waysOf(motion, instants);
        for (std::size_t i = motion.first; i <= motion.last; ++i) {
            const std::size_t sample = sampleOf(i);
            // A point that is not valid has the way of the one before it.
            std::fill(ways.begin() + static_cast<std::ptrdiff_t>(next),
                      ways.begin() + static_cast<std::ptrdiff_t>(sample),
                      i > motion.first ? before + own[i - 1 - motion.first] : before);
            ways[sample] = before + own[i - motion.first];
            next = sample + 1;
        }
        before += lengthOf(motion, instants);
    }
    std::fill(ways.begin() + static_cast<std::ptrdiff_t>(next), ways.end(), before);
    return ways;
}

} // namespace odo
