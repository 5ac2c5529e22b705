// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/trial_scene.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/trajectory/analyser.h"
#include "core/workflow/calibrate/result_axes.h"
#include "core/workflow/track/guidance.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>
#include <cmath>

namespace odo {

std::ptrdiff_t pointIndexAt(const Profile &profile, Nanoseconds time)
{
    const auto after =
        std::upper_bound(profile.samples.begin(), profile.samples.end(), time,
                         [](Nanoseconds wanted, const Sample &sample) { return wanted < sample.time; });
    const std::ptrdiff_t index = (after - profile.samples.begin()) - 1;
    return index >= 0 && profile.points[static_cast<std::size_t>(index)].valid ? index : -1;
}

const Profile &partAt(const AnalysisRecord &analysis, Nanoseconds time)
{
    if (!analysis.range || analysis.range->contains(time))
        return analysis.profile;
    return time < analysis.range->begin ? analysis.outside.before : analysis.outside.after;
}

std::optional<double> drivenHeadingAt(const Profile &profile, std::ptrdiff_t index)
{
    constexpr double standingMps = 0.05;
    for (; index >= 0; --index) {
        const ProfilePoint &point = profile.points[static_cast<std::size_t>(index)];
        if (point.valid && point.body && point.body->isFrontKnown())
            return point.body->radians;
        if (point.valid && point.speedMps > std::max(standingMps, 2 * point.sigmaSpeedMps))
            return std::atan2(point.velocity.y(), point.velocity.x());
    }
    return std::nullopt;
}

namespace {

/// The registration that a view's positions were made with, or else the one in force.
Result<std::optional<RegistrationRecord>> registrationOf(Project &project, std::size_t view, RecordId camera,
                                                         const std::vector<AnalysisRecord> &analyses)
{
    for (const AnalysisRecord &analysis : analyses) {
        if (view >= analysis.registrations.size() || analysis.registrations[view] == 0)
            continue;
        auto used = ODO_TRY(project.cameras().registration(analysis.registrations[view]));
        return std::optional(std::move(used));
    }
    return project.cameras().currentRegistration(camera);
}

/// Untouched where the axes were not changed.
FloorRegistration inAxes(const FloorRegistration &registration, const AxesTransform &newFromOld)
{
    return newFromOld.turnRad == 0 && newFromOld.shiftM.isZero(0) ? registration
                                                                  : transformed(registration, newFromOld);
}

Result<void> loadViews(Project &project, const std::vector<AnalysisRecord> &analyses, TrialScene &scene)
{
    auto recordings = ODO_TRY(project.trials().recordings(scene.trial.id));
    for (RecordingRecord &recording : recordings) {
        SceneView view;
        view.camera = recording.cameraName;
        view.file = project.resolve(recording);
        view.startOffset = fromSeconds(recording.startOffsetS);
        view.clockRate = recording.clockRate;
        auto registration = ODO_TRY(registrationOf(project, scene.views.size(), recording.camera, analyses));
        if (registration) {
            if (const auto axes = ODO_TRY(presentAxesOf(project, *registration)); axes && axes->scale == 1)
                registration->registration = inAxes(registration->registration, *axes);
            view.floorView = ODO_TRY(floorViewAt(project, *registration, recording));
            view.registration = registration->registration;
            if (!scene.layout) {
                auto layout = ODO_TRY(project.layouts().get(registration->layout));
                scene.layout = std::move(layout.layout);
            }
        }
        view.recording = std::move(recording);
        scene.views.push_back(std::move(view));
    }
    return {};
}

/// Takes its analysis out of them.
Result<SceneRobot> loadRobot(Project &project, const TrialScene &scene, RecordId id,
                             std::vector<AnalysisRecord> &analyses)
{
    auto robot = ODO_TRY(project.robots().get(id));
    SceneRobot result;
    result.robot = std::move(robot);
    const auto analysis = std::find_if(analyses.begin(), analyses.end(),
                                       [id](const AnalysisRecord &each) { return each.robot == id; });
    if (analysis != analyses.end())
        result.analysis = std::move(*analysis);
    for (const SceneView &view : scene.views) {
        auto series = ODO_TRY(project.trials().currentObservations(view.recording.id, id));
        result.observations.push_back(series ? std::move(series->observations) : std::vector<Observation>());
    }
    return result;
}

/// The robots that the trial names, and those that an analysis knows besides.
std::vector<RecordId> robotsOf(const TrialRecord &trial, const std::vector<AnalysisRecord> &analyses)
{
    std::vector<RecordId> robots = trial.robots;
    for (const AnalysisRecord &analysis : analyses) {
        if (std::find(robots.begin(), robots.end(), analysis.robot) == robots.end())
            robots.push_back(analysis.robot);
    }
    return robots;
}

void findOcclusionsIn(TrialScene &scene)
{
    std::vector<OcclusionView> views;
    std::vector<OcclusionRobot> robots;
    for (const SceneView &view : scene.views)
        views.push_back({view.camera, view.floorView ? &*view.floorView : nullptr, clockOf(view)});
    for (const SceneRobot &one : scene.robots) {
        OcclusionRobot &robot = robots.emplace_back(
            OcclusionRobot{one.robot.name, one.analysis ? &one.analysis->profile : nullptr, {}});
        robot.observations.assign(one.observations.begin(), one.observations.end());
    }
    auto found = findOcclusions(views, robots);
    for (std::size_t r = 0; r < found.size(); ++r)
        scene.robots[r].occlusions = std::move(found[r]);
}

/// The times of all samples: Sample::frame counts them.
std::vector<Nanoseconds> timesOf(const std::vector<SceneRobot> &robots)
{
    std::vector<Nanoseconds> times;
    for (const SceneRobot &robot : robots) {
        if (!robot.analysis)
            continue;
        const AnalysisRecord &analysis = *robot.analysis;
        for (const Profile *part : {&analysis.outside.before, &analysis.profile, &analysis.outside.after})
            for (const Sample &sample : part->samples)
                times.push_back(sample.time);
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

} // namespace

const std::vector<Nanoseconds> &TrialScene::frameTimes() const
{
    return views.empty() ? importedTimes : views.front().recording.frameTimes;
}

std::optional<std::int64_t> TrialScene::frameAt(std::size_t view, Nanoseconds time) const
{
    const SceneView &seen = views.at(view);
    const std::vector<Nanoseconds> &times = seen.recording.frameTimes;
    if (times.empty())
        return std::nullopt;
    const Nanoseconds own = clockOf(seen).ownTime(time);
    const Nanoseconds interval =
        times.size() < 2 ? Nanoseconds(0)
                         : (times.back() - times.front()) / static_cast<std::int64_t>(times.size() - 1);
    if (own < times.front() - interval || own > times.back() + interval)
        return std::nullopt;
    const auto after = std::lower_bound(times.begin(), times.end(), own);
    if (after == times.begin())
        return 0;
    if (after == times.end() || own - *(after - 1) <= *after - own)
        return (after - times.begin()) - 1;
    return after - times.begin();
}

Nanoseconds TrialScene::timeOf(std::size_t view, std::int64_t frame) const
{
    const SceneView &seen = views.at(view);
    return clockOf(seen).commonTime(seen.recording.frameTimes.at(static_cast<std::size_t>(frame)));
}

const Observation *TrialScene::observationAt(std::size_t view, std::size_t robot, std::int64_t frame) const
{
    const auto &all = robots.at(robot).observations;
    if (view >= all.size())
        return nullptr;
    const auto &list = all[view];
    const auto at =
        std::lower_bound(list.begin(), list.end(), frame,
                         [](const Observation &each, std::int64_t wanted) { return each.frame < wanted; });
    return at != list.end() && at->frame == frame && at->found ? &*at : nullptr;
}

double TrialScene::heightM(std::size_t robot) const
{
    const auto &analysis = robots.at(robot).analysis;
    return analysis ? analysis->profile.heightM : 0.0;
}

Eigen::Vector2d TrialScene::referenceM(std::size_t robot) const
{
    return imported.empty() ? robots[robot].robot.referenceM : Eigen::Vector2d::Zero();
}

Eigen::AlignedBox2d TrialScene::floorBounds() const
{
    Eigen::AlignedBox2d box;
    if (layout) {
        for (const Marker &marker : layout->markers)
            box.extend(marker.pointInWorld);
    }
    if (task) {
        for (const Gate &gate : task->gates)
            box.extend(gate.from).extend(gate.to);
        for (const Eigen::Vector2d &point : task->path.points)
            box.extend(point);
        for (const Zone &zone : task->zones)
            for (const Eigen::Vector2d &corner : zone.corners)
                box.extend(corner);
    }
    for (const SceneRobot &robot : robots) {
        if (!robot.analysis)
            continue;
        for (const ProfilePoint &point : robot.analysis->profile.points) {
            if (point.valid)
                box.extend(point.position);
        }
    }
    if (box.isEmpty() || box.sizes().maxCoeff() <= 0)
        return {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)};
    return box;
}

std::optional<Eigen::Vector2d> TrialScene::marker(const std::string &label) const
{
    if (!layout)
        return std::nullopt;
    for (const Marker &each : layout->markers) {
        if (each.label == label)
            return each.pointInWorld;
    }
    return std::nullopt;
}

Result<TrialScenePtr> loadTrialScene(Project &project, const std::string &trialName)
{
    auto scene = std::make_shared<TrialScene>();
    auto trial = ODO_TRY(project.trials().find(trialName));
    scene->trial = std::move(trial);
    if (!scene->trial.task.empty()) {
        auto task = ODO_TRY(project.tasks().find(scene->trial.task));
        auto scoring = ODO_TRY(project.tasks().scoring(task.id));
        scene->task = std::move(task.task);
        scene->taskId = task.id;
        scene->scoring = std::move(scoring);
    }
    auto analyses = ODO_TRY(project.analyses().current(scene->trial.id));
    ODO_TRY(loadViews(project, analyses, *scene));
    std::vector<const RecordingRecord *> recordings;
    for (const SceneView &view : scene->views)
        recordings.push_back(&view.recording);
    scene->verdict = ODO_TRY(verdictOn(project, scene->trial, recordings, analyses));
    for (AnalysisRecord &analysis : analyses)
        ODO_TRY(bringToPresentAxes(project, scene->trial, analysis));
    for (const RecordId id : robotsOf(scene->trial, analyses)) {
        scene->robots.push_back(ODO_TRY(loadRobot(project, *scene, id, analyses)));
    }
    findOcclusionsIn(*scene);
    auto pointedOut = ODO_TRY(project.trials().pointedOut(scene->trial.id));
    scene->pointedOut = std::move(pointedOut);
    auto guidance = ODO_TRY(project.guidance().of(scene->trial.id));
    scene->guidance = std::move(guidance);
    scene->isGuidanceNew = ODO_TRY(isGuidanceNew(project, scene->trial));
    auto imported = ODO_TRY(importedTracksOf(project, scene->trial));
    scene->imported = std::move(imported);
    if (!scene->imported.empty())
        scene->importedTimes = timesOf(scene->robots);
    return TrialScenePtr(std::move(scene));
}

} // namespace odo
