// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/turned_recordings.h"

#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"

#include <map>

namespace odo {

namespace {

bool wouldBeTurned(const RecordingRecord &recording, const std::filesystem::path &file)
{
    return recording.orientation == 0 && VideoReader::statedOrientation(file) != 1;
}

Message measuredAsStored()
{
    return ODO_TEXT(
        "workflow.measured_as_stored",
        "an earlier version measured its frames as stored, but its file says to turn or mirror them");
}

Message importToTurn()
{
    return ODO_TEXT("workflow.import_to_turn", "import the video again to measure it upright");
}

} // namespace

Message storedFrameWarning(const std::string &trialName, const RecordingRecord &recording,
                           const std::filesystem::path &file)
{
    if (!wouldBeTurned(recording, file))
        return {};
    return wholeMessage(viewInTrialSubject(recording.cameraName, trialName), measuredAsStored(),
                        importToTurn());
}

Message oldRegistrationWarning(const std::string &trialName, const RecordingRecord &recording,
                               const RegistrationRecord &registration)
{
    if (registration.isUpright || recording.orientation <= 1)
        return {};
    return wholeMessage(
        viewInTrialSubject(recording.cameraName, trialName),
        ODO_TEXT("workflow.registered_as_stored",
                 "its frames are turned or mirrored as its file says, but an earlier version registered "
                 "camera '%1', perhaps by frames as stored")(Named::camera(recording.cameraName)),
        ODO_TEXT("workflow.register_upright", "register the camera again"));
}

std::vector<Message> turnedWarnings(const std::string &trialName, const std::vector<RegisteredView> &views)
{
    std::vector<Message> sentences;
    const auto add = [&sentences](Message sentence) {
        if (!sentence.isEmpty())
            sentences.push_back(std::move(sentence));
    };
    for (const RegisteredView &view : views) {
        add(storedFrameWarning(trialName, view.recording, view.file));
        if (view.registration)
            add(oldRegistrationWarning(trialName, view.recording, *view.registration));
    }
    return sentences;
}

Result<std::vector<ProjectProblem>> turnedRecordings(Project &project)
{
    std::map<RecordId, std::string> trials;
    const auto names = ODO_TRY(project.trials().names());
    for (const TrialName &trial : names) {
        if (!trial.binned)
            trials[trial.id] = trial.name;
    }
    std::vector<ProjectProblem> problems;
    const auto recordings = ODO_TRY(project.trials().allRecordings());
    for (const RecordingRecord &recording : recordings) {
        const auto trial = trials.find(recording.trial);
        if (trial != trials.end() && wouldBeTurned(recording, project.resolve(recording)))
            problems.push_back({measuredAsStored(), viewInTrialSubject(recording.cameraName, trial->second),
                                importToTurn()});
    }
    return problems;
}

} // namespace odo
