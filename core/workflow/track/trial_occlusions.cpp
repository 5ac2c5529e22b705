// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/trial_occlusions.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>

namespace odo {

namespace {

/// A view as the analyses used it; without a floor view where none did.
Result<std::optional<FloorView>> floorViewUsed(Project &project, const RecordingRecord &recording,
                                               std::size_t view, const std::vector<AnalysisRecord> &analyses)
{
    const auto user = std::ranges::find_if(analyses, [view](const AnalysisRecord &one) {
        return view < one.registrations.size() && one.registrations[view] != 0;
    });
    if (user == analyses.end())
        return std::nullopt;
    const auto registration = ODO_TRY(project.cameras().registration(user->registrations[view]));
    return floorViewAt(project, registration, recording);
}

} // namespace

Result<std::vector<std::vector<Occlusion>>> trialOcclusions(Project &project, RecordId trial,
                                                            const std::vector<AnalysisRecord> &analyses)
{
    const auto recordings = ODO_TRY(project.trials().recordings(trial));
    std::vector<std::optional<FloorView>> floorViews;
    // of each view, a series for each analysis
    std::vector<std::vector<ObservationSeries>> seen(recordings.size());
    for (std::size_t v = 0; v < recordings.size(); ++v) {
        floorViews.push_back(ODO_TRY(floorViewUsed(project, recordings[v], v, analyses)));
        for (const AnalysisRecord &analysis : analyses) {
            auto series = ODO_TRY(project.trials().currentObservations(recordings[v].id, analysis.robot));
            seen[v].push_back(std::move(series).value_or(ObservationSeries()));
        }
    }
    std::vector<OcclusionView> views;
    std::vector<OcclusionRobot> robots;
    for (std::size_t v = 0; v < recordings.size(); ++v)
        views.push_back(
            {recordings[v].cameraName, floorViews[v] ? &*floorViews[v] : nullptr, clockOf(recordings[v])});
    for (std::size_t r = 0; r < analyses.size(); ++r) {
        OcclusionRobot &robot =
            robots.emplace_back(OcclusionRobot{analyses[r].robotName, &analyses[r].profile, {}});
        for (const std::vector<ObservationSeries> &view : seen)
            robot.observations.emplace_back(view[r].observations);
    }
    return findOcclusions(views, robots);
}

Result<std::vector<StoredRobot>> otherRobots(Project &project, RecordId trial,
                                             const std::vector<RegisteredView> &views,
                                             const std::vector<RobotRecord> &but)
{
    const auto isOther = [&but](const AnalysisRecord &one) {
        return std::ranges::find(but, one.robot, &RobotRecord::id) == but.end();
    };
    std::vector<StoredRobot> others;
    const auto known = project.analyses().currentMetrics(trial); // cheap, and mostly there is no other
    if (!known)
        return tl::unexpected(known.error());
    if (std::ranges::none_of(*known, isOther))
        return others;
    auto analyses = ODO_TRY(project.analyses().current(trial));
    for (AnalysisRecord &analysis : analyses) {
        if (!isOther(analysis))
            continue;
        StoredRobot &robot = others.emplace_back();
        for (const RegisteredView &view : views) {
            auto series = ODO_TRY(project.trials().currentObservations(view.recording.id, analysis.robot));
            robot.observations.push_back(std::move(series).value_or(ObservationSeries()).observations);
        }
        robot.analysis = std::move(analysis);
        robot.analysis.profile = wholeRun(std::move(robot.analysis.profile), robot.analysis.outside);
    }
    return others;
}

std::vector<std::vector<Occlusion>> trackedOcclusions(const std::vector<RegisteredView> &views,
                                                      const std::vector<TrackedView> &tracked,
                                                      const std::vector<const AnalysisRecord *> &robots,
                                                      const std::vector<StoredRobot> &others)
{
    std::vector<OcclusionView> watched;
    std::vector<OcclusionRobot> watchedRobots;
    for (const RegisteredView &view : views)
        watched.push_back({view.recording.cameraName, view.floorView ? &*view.floorView : nullptr,
                           clockOf(view.recording)});
    for (std::size_t r = 0; r < robots.size(); ++r) {
        OcclusionRobot &robot =
            watchedRobots.emplace_back(OcclusionRobot{robots[r]->robotName, &robots[r]->profile, {}});
        for (const TrackedView &view : tracked)
            robot.observations.emplace_back(view.series[r].observations);
    }
    for (const StoredRobot &other : others) {
        OcclusionRobot &robot =
            watchedRobots.emplace_back(OcclusionRobot{other.analysis.robotName, &other.analysis.profile, {}});
        robot.observations.assign(other.observations.begin(), other.observations.end());
    }
    auto all = findOcclusions(watched, watchedRobots);
    all.resize(robots.size());
    return all;
}

void removeSpikesOfPassing(const std::vector<Occlusion> &occlusions, std::vector<Spike> &spikes)
{
    std::erase_if(spikes, [&](const Spike &spike) {
        return (spike.flags & ~flagBit(SampleFlag::Interpolated)) == flagBit(SampleFlag::LowScore) &&
               std::ranges::any_of(occlusions, [&](const Occlusion &one) {
                   return !one.other.empty() && one.span.contains(spike.time);
               });
    });
}

} // namespace odo
