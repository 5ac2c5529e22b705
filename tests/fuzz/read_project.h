// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

namespace odo::fuzz {

/// Reads all that one part of the program would, of a Project or of the same repositories.
template <class Repositories>
void readCameras(Repositories &project)
{
    const auto cameras = project.cameras().all();
    for (const CameraRecord &camera : cameras.value_or(std::vector<CameraRecord>())) {
        static_cast<void>(project.cameras().currentIntrinsics(camera.id));
        static_cast<void>(project.cameras().allIntrinsics(camera.id));
        static_cast<void>(project.cameras().currentRegistration(camera.id));
        static_cast<void>(project.cameras().allRegistrations(camera.id));
        static_cast<void>(project.trials().newestRecording(camera.id));
    }
    static_cast<void>(project.analyses().trialsByRegistration());
}

template <class Repositories>
void readLists(Repositories &project)
{
    static_cast<void>(project.layouts().all());
    static_cast<void>(project.robots().all());
    static_cast<void>(project.teams().all());
    static_cast<void>(project.teams().classes());
    static_cast<void>(project.classes().all());
    static_cast<void>(project.tasks().all());
    static_cast<void>(project.tasks().uses());
    static_cast<void>(project.tasks().current());
    static_cast<void>(project.tasks().scorings());
}

template <class Repositories>
void readTrials(Repositories &project)
{
    const auto page = project.trials().page(nullptr, 2);
    if (page && !page->empty())
        static_cast<void>(project.trials().page(&page->back(), 2));
    static_cast<void>(project.trials().all());
    static_cast<void>(project.trials().names());
    static_cast<void>(project.trials().tags());
    static_cast<void>(project.trials().unhashed());
    static_cast<void>(project.trials().binnedBytes());
    static_cast<void>(project.trials().allRecordings());
}

template <class Repositories>
void readSeries(Repositories &project)
{
    const auto trials = project.trials().names();
    const auto robots = project.robots().all();
    for (const TrialName &trial : trials.value_or(std::vector<TrialName>())) {
        const auto recordings = project.trials().recordings(trial.id);
        for (const RecordingRecord &recording : recordings.value_or(std::vector<RecordingRecord>())) {
            static_cast<void>(project.trials().rawTimes(recording.id));
            for (const RobotRecord &robot : robots.value_or(std::vector<RobotRecord>()))
                static_cast<void>(project.trials().currentObservations(recording.id, robot.id));
        }
        for (const RobotRecord &robot : robots.value_or(std::vector<RobotRecord>())) {
            static_cast<void>(project.trials().overrules(trial.id, robot.id));
            static_cast<void>(project.trials().currentImportedTrack(trial.id, robot.id));
            static_cast<void>(project.trials().truth(trial.id, robot.id));
        }
    }
}

template <class Repositories>
void readAnalyses(Repositories &project)
{
    const auto trials = project.trials().names();
    for (const TrialName &trial : trials.value_or(std::vector<TrialName>())) {
        static_cast<void>(project.analyses().current(trial.id));
        static_cast<void>(project.analyses().currentMetrics(trial.id));
    }
    const auto names = project.analyses().metricNames();
    for (const std::string &name : names.value_or(std::vector<std::string>()))
        static_cast<void>(project.analyses().figures(name, Instant::min(), Instant::max()));
    static_cast<void>(project.analyses().scoredFigures(Instant::min(), Instant::max()));
    static_cast<void>(project.analyses().trialsMeasuredOtherwise());
}

template <class Repositories>
void readEverything(Repositories &project)
{
    readCameras(project);
    readLists(project);
    readTrials(project);
    readSeries(project);
    readAnalyses(project);
}

} // namespace odo::fuzz
