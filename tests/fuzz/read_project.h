// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

#include <array>

namespace odo::fuzz {

/// What of a project is read one by one.
struct Ids
{
    std::vector<RecordId> cameras, robots, trials, recordings;
};

template <class Repositories>
Ids idsOf(Repositories &project)
{
    Ids ids;
    for (const CameraRecord &camera : project.cameras().all().value_or(std::vector<CameraRecord>()))
        ids.cameras.push_back(camera.id);
    for (const RobotRecord &robot : project.robots().all().value_or(std::vector<RobotRecord>()))
        ids.robots.push_back(robot.id);
    for (const TrialName &trial : project.trials().names().value_or(std::vector<TrialName>())) {
        ids.trials.push_back(trial.id);
        for (const RecordingRecord &recording :
             project.trials().recordings(trial.id).value_or(std::vector<RecordingRecord>()))
            ids.recordings.push_back(recording.id);
    }
    return ids;
}

template <class Each>
void forEachPair(const std::vector<RecordId> &outer, const std::vector<RecordId> &inner, Each &&each)
{
    for (const RecordId a : outer) {
        for (const RecordId b : inner)
            static_cast<void>(each(a, b));
    }
}

template <class Repositories>
using Reader = void (*)(Repositories &, const Ids &);

/// Each way in which the program reads something of a Project, or of the same repositories.
template <class Repositories>
inline constexpr std::array<Reader<Repositories>, 27> readers = {
    [](Repositories &project, const Ids &) { static_cast<void>(project.cameras().all()); },
    [](Repositories &project, const Ids &ids) {
        for (const RecordId camera : ids.cameras)
            static_cast<void>(project.cameras().currentIntrinsics(camera)),
                static_cast<void>(project.cameras().allIntrinsics(camera));
    },
    [](Repositories &project, const Ids &ids) {
        for (const RecordId camera : ids.cameras)
            static_cast<void>(project.cameras().currentRegistration(camera)),
                static_cast<void>(project.cameras().allRegistrations(camera));
    },
    [](Repositories &project, const Ids &) { static_cast<void>(project.analyses().trialsByRegistration()); },
    [](Repositories &project, const Ids &) { static_cast<void>(project.layouts().all()); },
    [](Repositories &project, const Ids &) { static_cast<void>(project.robots().all()); },
    [](Repositories &project, const Ids &) {
        static_cast<void>(project.teams().all()), static_cast<void>(project.teams().classes());
    },
    [](Repositories &project, const Ids &) { static_cast<void>(project.classes().all()); },
    [](Repositories &project, const Ids &) { static_cast<void>(project.tasks().all()); },
    [](Repositories &project, const Ids &) { static_cast<void>(project.tasks().uses()); },
    [](Repositories &project, const Ids &) { static_cast<void>(project.tasks().current()); },
    [](Repositories &project, const Ids &) { static_cast<void>(project.tasks().scorings()); },
    [](Repositories &project, const Ids &) {
        const auto page = project.trials().page(nullptr, 2);
        if (page && !page->empty())
            static_cast<void>(project.trials().page(&page->back(), 2));
    },
    [](Repositories &project, const Ids &) { static_cast<void>(project.trials().all()); },
    [](Repositories &project, const Ids &) {
        static_cast<void>(project.trials().names()), static_cast<void>(project.trials().tags());
    },
    [](Repositories &project, const Ids &) {
        static_cast<void>(project.trials().unhashed()), static_cast<void>(project.trials().binnedBytes());
    },
    [](Repositories &project, const Ids &ids) {
        static_cast<void>(project.trials().allRecordings());
        for (const RecordId camera : ids.cameras)
            static_cast<void>(project.trials().newestRecording(camera));
    },
    [](Repositories &project, const Ids &ids) {
        for (const RecordId trial : ids.trials)
            static_cast<void>(project.trials().recordings(trial));
    },
    [](Repositories &project, const Ids &ids) {
        for (const RecordId recording : ids.recordings)
            static_cast<void>(project.trials().rawTimes(recording));
    },
    [](Repositories &project, const Ids &ids) {
        forEachPair(ids.recordings, ids.robots,
                    [&](RecordId a, RecordId b) { return project.trials().currentObservations(a, b); });
    },
    [](Repositories &project, const Ids &ids) {
        forEachPair(ids.trials, ids.robots,
                    [&](RecordId a, RecordId b) { return project.trials().overrides(a, b); });
    },
    [](Repositories &project, const Ids &ids) {
        forEachPair(ids.trials, ids.robots,
                    [&](RecordId a, RecordId b) { return project.trials().currentImportedTrack(a, b); });
    },
    [](Repositories &project, const Ids &ids) {
        forEachPair(ids.trials, ids.robots,
                    [&](RecordId a, RecordId b) { return project.trials().truth(a, b); });
    },
    [](Repositories &project, const Ids &ids) {
        for (const RecordId trial : ids.trials)
            static_cast<void>(project.analyses().current(trial));
    },
    [](Repositories &project, const Ids &ids) {
        for (const RecordId trial : ids.trials)
            static_cast<void>(project.analyses().currentMetrics(trial));
    },
    [](Repositories &project, const Ids &) {
        for (const std::string &name : project.analyses().metricNames().value_or(std::vector<std::string>()))
            static_cast<void>(project.analyses().trialMetrics(name, Instant::min(), Instant::max()));
    },
    [](Repositories &project, const Ids &) {
        static_cast<void>(project.analyses().scoredMetrics(Instant::min(), Instant::max()));
        static_cast<void>(project.analyses().trialsMeasuredOtherwise());
    },
};

} // namespace odo::fuzz
