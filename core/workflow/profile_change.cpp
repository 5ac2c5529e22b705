// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/profile_change.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace odo {

namespace {

void comparePlaces(const Profile &before, const Profile &after, ProfileChange &change)
{
    std::map<std::int64_t, std::size_t> byFrame;
    for (std::size_t i = 0; i < before.samples.size(); ++i)
        byFrame[before.samples[i].frame] = i;
    double squares = 0;
    for (std::size_t i = 0; i < after.samples.size(); ++i) {
        const auto same = byFrame.find(after.samples[i].frame);
        if (same == byFrame.end() || !before.points[same->second].valid || !after.points[i].valid)
            continue;
        const double shiftM = (after.points[i].position - before.points[same->second].position).norm();
        ++change.compared;
        squares += shiftM * shiftM;
        if (shiftM > change.largestShiftM) {
            change.largestShiftM = shiftM;
            change.largestAt = after.samples[i].time;
        }
    }
    if (change.compared > 0)
        change.rmsShiftM = std::sqrt(squares / static_cast<double>(change.compared));
}

void compareMetrics(const Profile &before, const Profile &after, ProfileChange &change)
{
    const auto find = [](const Profile &profile, const std::string &name) {
        const auto found = std::ranges::find(profile.metrics, name, &Metric::name);
        return found == profile.metrics.end() ? nullptr : &*found;
    };
    for (const Metric &metric : before.metrics) {
        const Metric *later = find(after, metric.name);
        change.metrics.push_back({metric.name, metric.unit, metric.value, later ? std::optional(later->value) : std::nullopt,
                                  later && later->sigma ? later->sigma : metric.sigma});
    }
    for (const Metric &metric : after.metrics)
        if (!find(before, metric.name))
            change.metrics.push_back({metric.name, metric.unit, std::nullopt, metric.value, metric.sigma});
}

std::string wordsOf(const ProfileChange &change)
{
    if (change.compared == 0)
        return "No place was measured by both analyses.";
    std::string words = "Positions change by " + formatNumber(toMillimetres(change.rmsShiftM), 1) + " mm RMS, at most by " +
                        formatNumber(toMillimetres(change.largestShiftM), 1) + " mm (at " + formatNumber(toSeconds(change.largestAt), 2) + " s).";
    if (change.spikesBefore != change.spikesAfter)
        words += " Spikes: " + std::to_string(change.spikesAfter) + " instead of " + std::to_string(change.spikesBefore) + ".";
    return words;
}

} // namespace

ProfileChange changeBetween(const Profile &before, const Profile &after)
{
    ProfileChange change;
    change.spikesBefore = before.spikes.size();
    change.spikesAfter = after.spikes.size();
    comparePlaces(before, after, change);
    compareMetrics(before, after, change);
    change.words = wordsOf(change);
    return change;
}

} // namespace odo
