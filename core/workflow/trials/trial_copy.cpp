// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/trials/trial_copy.h"

#include "core/project/guidance_repository.h"
#include "core/project/names.h"
#include "core/project/project.h"
#include "core/project/project_words.h"
#include "core/project/repositories.h"
#include "core/workflow/trials/trial_changes.h"

#include <algorithm>
#include <map>

namespace odo {

namespace {

/// "NAME copy", "NAME copy 2"…, within the length of a name.
Result<std::string> freeName(Project &project, const std::string &name)
{
    constexpr int numberLength = 20;
    const std::string stem =
        normalName(QString::fromStdString(name).left(maxNameLength - numberLength).toStdString()) + " copy";
    const auto names = ODO_TRY(project.trials().names());
    std::string free = stem;
    for (int number = 2; std::ranges::find(names, free, &TrialName::name) != names.end(); ++number)
        free = stem + ' ' + std::to_string(number);
    return free;
}

Result<void> copyObservations(TrialRepository &trials, const std::map<RecordId, RecordId> &copies,
                              const std::vector<RobotRecord> &robots)
{
    for (const auto &[recording, copy] : copies) {
        for (const RobotRecord &robot : robots) {
            auto tracked = ODO_TRY(trials.currentObservations(recording, robot.id, true));
            auto inForce = ODO_TRY(trials.currentObservations(recording, robot.id));
            if (!inForce)
                continue;
            if (tracked && tracked->algorithm != inForce->algorithm) { // it was corrected by hand
                tracked->recording = copy;
                ODO_TRY(trials.addObservations(*tracked));
            }
            inForce->recording = copy;
            ODO_TRY(trials.addObservations(*inForce));
        }
    }
    return {};
}

Result<void> copyGuidance(Project &project, RecordId from, RecordId to,
                          const std::map<RecordId, RecordId> &copies)
{
    const auto items = ODO_TRY(project.guidance().of(from));
    for (GuidanceItem item : items) {
        item.recording = copies.at(item.recording);
        ODO_TRY(project.guidance().add(item));
    }
    TrialRepository &trials = project.trials();
    auto pointers = ODO_TRY(trials.pointedOut(from));
    for (PointedOutRobot &pointer : pointers)
        pointer.recording = copies.at(pointer.recording);
    return trials.setPointedOut(to, pointers);
}

/// What a trial has once a robot, besides observations.
Result<void> copyOfRobot(TrialRepository &trials, RecordId from, RecordId to, RecordId robot)
{
    const auto overrides = ODO_TRY(trials.overrides(from, robot));
    if (!overrides.empty())
        ODO_TRY(trials.setManualOverrides(to, robot, overrides));
    auto track = ODO_TRY(trials.currentImportedTrack(from, robot));
    if (track) {
        track->trial = to;
        ODO_TRY(trials.addImportedTrack(*track));
    }
    auto truth = ODO_TRY(trials.truth(from, robot));
    if (!truth)
        return {};
    truth->trial = to;
    return trials.setTruth(*truth);
}

Result<TrialRecord> addCopy(Project &project, const TrialRecord &original, const std::string &name)
{
    TrialRepository &trials = project.trials();
    TrialRecord record = original;
    record.name = name;
    const auto recordings = ODO_TRY(trials.recordings(original.id));
    auto copy = ODO_TRY(trials.add(record, recordings));
    const auto copied = ODO_TRY(trials.recordings(copy.id));
    std::map<RecordId, RecordId> copies;
    for (std::size_t i = 0; i < recordings.size(); ++i)
        copies.emplace(recordings[i].id, copied[i].id);
    const auto robots = ODO_TRY(project.robots().all());
    ODO_TRY(copyObservations(trials, copies, robots));
    ODO_TRY(copyGuidance(project, original.id, copy.id, copies));
    for (const RobotRecord &robot : robots)
        ODO_TRY(copyOfRobot(trials, original.id, copy.id, robot.id));
    ODO_TRY(trials.setTags(copy.id, original.tags));
    ODO_TRY(trials.setVariables(copy.id, original.variables));
    return trials.get(copy.id);
}

} // namespace

Result<TrialRecord> copyTrial(Project &project, const std::string &trial, const std::string &name)
{
    const auto original = ODO_TRY(project.trials().find(trial));
    if (original.unfinished)
        return fail(ErrorCode::InvalidInput, trialSubject(original.name),
                    ODO_TEXT("workflow.copied_while_recorded", "its recording has not ended"),
                    endRecordingFirst());
    const std::string free = name.empty() ? ODO_TRY(freeName(project, original.name)) : name;
    TrialRecord copy;
    const auto add = [&]() -> Result<RecordId> {
        copy = ODO_TRY(addCopy(project, original, free));
        return copy.id;
    };
    ODO_TRY(addTrial(project,
                     ODO_TEXT("workflow.copy_trial", "copy trial %1 to %2")(Named::trial(original.name),
                                                                            Named::trial(free)),
                     add));
    return copy;
}

} // namespace odo
