// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/range/run_range.h"

#include "core/analysis/metrics.h"
#include "core/analysis/motion_stretches.h"
#include "core/analysis/task_metrics.h"

#include <algorithm>
#include <iterator>

namespace odo {

namespace {

/// The samples from one to another, with their points and spikes, which count from the first of them.
Profile partOf(const Profile &profile, std::size_t from, std::size_t to)
{
    const auto first = static_cast<std::ptrdiff_t>(from), last = static_cast<std::ptrdiff_t>(to);
    Profile part;
    part.samples.assign(profile.samples.begin() + first, profile.samples.begin() + last);
    part.points.assign(profile.points.begin() + first, profile.points.begin() + last);
    for (Spike spike : profile.spikes) {
        if (spike.sampleIndex < first || spike.sampleIndex >= last)
            continue;
        spike.sampleIndex -= first;
        part.spikes.push_back(std::move(spike));
    }
    return part;
}

void append(Profile &profile, const Profile &part)
{
    const auto first = static_cast<std::int64_t>(profile.samples.size());
    profile.samples.insert(profile.samples.end(), part.samples.begin(), part.samples.end());
    profile.points.insert(profile.points.end(), part.points.begin(), part.points.end());
    for (Spike spike : part.spikes) {
        spike.sampleIndex += first;
        profile.spikes.push_back(std::move(spike));
    }
}

/// What follows from the samples and points alone, and is not stored.
void deriveFromSamples(Profile &profile)
{
    measureGaps(validInstants(profile.samples, profile.points), profile);
    profile.meanViewDisagreementM = meanViewDisagreement(profile.samples);
}

/// Whether more of its metrics are lower bounds than its gaps explain: the robot moved while no view saw it,
/// which the samples alone no longer show.
bool hasOtherLowerBounds(const Profile &profile, const Task *task)
{
    Profile again = profile;
    measureProfile(again, task);
    return std::ranges::any_of(profile.metrics, [&](const Metric &metric) {
        const auto its = std::ranges::find(again.metrics, metric.name, &Metric::name);
        return metric.isAtLeast && its != again.metrics.end() && !its->isAtLeast;
    });
}

} // namespace

OutsideRange cutToRange(Profile &profile, const TimeSpan &range)
{
    const auto indexOf = [&](auto at) { return static_cast<std::size_t>(at - profile.samples.begin()); };
    const std::size_t from =
        indexOf(std::ranges::lower_bound(profile.samples, range.begin, {}, &Sample::time));
    const std::size_t to =
        std::max(from, indexOf(std::ranges::upper_bound(profile.samples, range.end, {}, &Sample::time)));
    OutsideRange outside{partOf(profile, 0, from), partOf(profile, to, profile.samples.size())};
    Profile inside = partOf(profile, from, to);
    profile.samples = std::move(inside.samples);
    profile.points = std::move(inside.points);
    profile.spikes = std::move(inside.spikes);
    deriveFromSamples(profile);
    return outside;
}

Profile wholeRun(Profile part, const OutsideRange &outside)
{
    Profile whole = part;
    whole.samples.clear();
    whole.points.clear();
    whole.spikes.clear();
    for (const Profile *one : {&outside.before, static_cast<const Profile *>(&part), &outside.after})
        append(whole, *one);
    deriveFromSamples(whole);
    return whole;
}

void measureProfile(Profile &profile, const Task *task)
{
    profile.metrics = measureRun(profile.samples, profile.points);
    profile.passages.clear();
    if (task) {
        TaskMetrics byTask = measureTask(*task, profile.samples, profile.points);
        profile.passages = std::move(byTask.passages);
        std::ranges::move(byTask.metrics, std::back_inserter(profile.metrics));
    }
    markLowerBounds(profile.metrics, profile.gaps);
}

void changeRange(Profile &profile, OutsideRange &outside, const std::optional<TimeSpan> &range,
                 const Task *task)
{
    const bool wasUnseen = hasOtherLowerBounds(profile, task);
    profile = wholeRun(std::move(profile), outside);
    outside = range ? cutToRange(profile, *range) : OutsideRange();
    measureProfile(profile, task);
    if (!wasUnseen || profile.metrics.empty())
        return;
    markLowerBounds(profile.metrics, {TimeSpan()});
    std::ranges::find(profile.metrics, "duration", &Metric::name)->isAtLeast = true;
}

bool hasValidPoint(const Profile &profile)
{
    return std::ranges::any_of(profile.points, &ProfilePoint::valid);
}

std::optional<TimeSpan> motionSpan(const Profile &profile)
{
    constexpr std::ptrdiff_t fewestUsed = 3;
    const std::vector<RunInstant> instants = validInstants(profile.samples, profile.points);
    std::vector<MotionStretch> motions = findMotions(instants);
    std::erase_if(motions, [&](const MotionStretch &motion) {
        const auto indexOf = [&](std::size_t at) { return instants[at].point - profile.points.data(); };
        const auto first = profile.samples.begin() + indexOf(motion.first),
                   behind = profile.samples.begin() + indexOf(motion.last) + 1;
        return std::count_if(first, behind, isUsed) < fewestUsed;
    });
    if (motions.empty())
        return std::nullopt;
    const auto timeOf = [&](std::size_t at) {
        return profile.samples[static_cast<std::size_t>(instants[at].point - profile.points.data())].time;
    };
    return TimeSpan{timeOf(motions.front().first), timeOf(motions.back().last)};
}

double meanViewDisagreement(const std::vector<Sample> &samples)
{
    double sum = 0, count = 0;
    for (const Sample &sample : samples) {
        if (sample.viewDisagreementM && !isRejected(sample.flags)) {
            sum += *sample.viewDisagreementM;
            count += 1;
        }
    }
    return count > 0 ? sum / count : 0;
}

} // namespace odo
