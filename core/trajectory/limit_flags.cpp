// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/limit_flags.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double sigmasBeyond = 4;
constexpr int mostLimitPasses = 8;

/// Three samples in order of time and the motion between them.
struct Triple
{
    const Sample &before, &at, &behind;

    double in() const { return toSeconds(at.time - before.time); }
    double out() const { return toSeconds(behind.time - at.time); }
    Eigen::Vector2d speedIn() const { return (*at.position - *before.position) / in(); }
    Eigen::Vector2d speedOut() const { return (*behind.position - *at.position) / out(); }
    double accelMps2() const { return (speedOut() - speedIn()).norm() / ((in() + out()) / 2); }
    double sigmaAccelMps2() const
    {
        const auto variance = [](const Sample &sample) { return sample.covariance.trace() / 2; };
        const double rates = variance(before) / (in() * in()) + variance(behind) / (out() * out()) +
                             variance(at) * std::pow(1 / in() + 1 / out(), 2);
        return std::sqrt(rates) / ((in() + out()) / 2);
    }
};

/// By how much each of the used samples is beyond the limit; not above zero where it keeps it.
std::vector<double> excesses(const std::vector<Sample *> &used, const AnalysisOptions &options, double noiseScale)
{
    std::vector<double> beyond(used.size());
    for (std::size_t i = 1; i + 1 < used.size(); ++i) {
        const Triple triple{*used[i - 1], *used[i], *used[i + 1]};
        const Nanoseconds longest = options.longestBridgedGap;
        if (triple.in() <= 0 || triple.out() <= 0 || triple.at.time - triple.before.time > longest ||
            triple.behind.time - triple.at.time > longest)
            continue;
        beyond[i] = triple.accelMps2() - sigmasBeyond * std::sqrt(noiseScale) * triple.sigmaAccelMps2() -
                    *options.task->limits.maxAccelMps2;
    }
    return beyond;
}

} // namespace

void nameLimits(std::vector<Sample> &samples, const AnalysisOptions &options)
{
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!samples[i].position || !hasFlag(samples[i].flags, SampleFlag::Jump) ||
            hasFlag(samples[i].flags, SampleFlag::ByHand))
            continue;
        // The nearest used neighbours stand for the motion.
        std::optional<std::size_t> before, behind;
        for (std::size_t j = i; j-- > 0 && !before;) {
            if (isUsed(samples[j]))
                before = j;
        }
        for (std::size_t j = i + 1; j < samples.size() && !behind; ++j) {
            if (isUsed(samples[j]))
                behind = j;
        }
        if (!before || !behind)
            continue;
        const Triple triple{samples[*before], samples[i], samples[*behind]};
        if (std::min(triple.speedIn().norm(), triple.speedOut().norm()) > options.maxSpeedMps)
            samples[i].flags |= flagBit(SampleFlag::SpeedLimit);
        if (triple.accelMps2() > options.maxAccelMps2)
            samples[i].flags |= flagBit(SampleFlag::AccelerationLimit);
    }
}

void refuseBeyondTask(std::vector<Sample> &samples, const AnalysisOptions &options, double noiseScale)
{
    if (!options.task || !options.task->limits.maxAccelMps2)
        return;
    bool any = true;
    for (int pass = 0; any && pass < mostLimitPasses; ++pass) {
        std::vector<Sample *> used;
        for (Sample &sample : samples) {
            if (isUsed(sample))
                used.push_back(&sample);
        }
        const std::vector<double> beyond = excesses(used, options, noiseScale);
        any = false;
        for (std::size_t i = 1; i + 1 < used.size(); ++i) {
            if (beyond[i] <= 0 || beyond[i] < beyond[i - 1] || beyond[i] <= beyond[i + 1] ||
                hasFlag(used[i]->flags, SampleFlag::ByHand))
                continue;
            used[i]->flags |= flagBit(SampleFlag::AccelerationLimit);
            any = true;
        }
    }
}

} // namespace odo
