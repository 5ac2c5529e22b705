// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/turned_recordings.h"

#include "core/project/repositories.h"
#include "core/video/frame_turn.h"
#include "core/video/image_reader.h"
#include "core/workflow/shared_words.h"

#include <Eigen/Core>

#include <map>

namespace odo {

namespace {

bool wouldBeShownOtherwise(const RecordingRecord &recording, const std::filesystem::path &file, Opened which)
{
    return (which == Opened::All || recording.orientation == 0) &&
           VideoReader::isShownOtherwise(file, knownRecording(recording));
}

Message measuredAsStored()
{
    return ODO_TEXT("workflow.measured_as_stored", "an earlier version measured its frames as stored, but "
                                                   "its file says to turn, mirror or stretch them");
}

Message importToTurn()
{
    return ODO_TEXT("workflow.import_to_turn", "import the video again to measure it as it is shown");
}

} // namespace

Message storedFrameWarning(const std::string &trialName, const RecordingRecord &recording,
                           const std::filesystem::path &file, Opened which)
{
    if (!wouldBeShownOtherwise(recording, file, which))
        return {};
    return wholeMessage(viewInTrialSubject(recording.cameraName, trialName), measuredAsStored(),
                        importToTurn());
}

namespace {

/// A frame at a coarse grid, with mean 0 and norm 1.
Eigen::VectorXd coarse(const Frame &frame)
{
    constexpr int columns = 32, rows = 24, samples = 8;
    Eigen::VectorXd grid = Eigen::VectorXd::Zero(Eigen::Index(columns) * rows);
    for (int y = 0; y < rows * samples; ++y)
        for (int x = 0; x < columns * samples; ++x)
            grid[Eigen::Index(y / samples) * columns + x / samples] +=
                frame.y.at(x * frame.y.width / (columns * samples), y * frame.y.height / (rows * samples));
    grid.array() -= grid.mean();
    return grid.normalized();
}

/// Whether the image that a camera was registered by shows the scene as the frames do, and not as those of
/// the file are stored.
bool isSeenUpright(const RegisteredView &view)
{
    constexpr double clearly = 0.1; // of a correlation
    if (view.registrationImage.empty())
        return false;
    const auto image = readImage(view.registrationImage);
    const auto reader = VideoReader::open(view.file, {}, knownRecording(view.recording));
    const auto frame = reader ? (*reader)->frameAt(0) : tl::unexpected(reader.error());
    if (!image || !frame)
        return false;
    const Eigen::VectorXd seen = coarse(*frame), upright = coarse(*image),
                          stored = coarse(turned(*image, view.recording.orientation));
    return seen.dot(upright) > seen.dot(stored) + clearly;
}

} // namespace

Message oldRegistrationWarning(const std::string &trialName, const RegisteredView &view)
{
    const RecordingRecord &recording = view.recording;
    if (!view.registration || view.registration->isUpright || recording.orientation <= 1)
        return {};
    // frames turned by 90° have another shape than as stored, and the sizes are compared elsewhere
    const bool isOtherShape = recording.orientation > 4 && recording.widthPx != recording.heightPx;
    if (isOtherShape || isSeenUpright(view))
        return {};
    return wholeMessage(
        viewInTrialSubject(recording.cameraName, trialName),
        ODO_TEXT("workflow.registered_as_stored",
                 "its frames are turned or mirrored as its file says, but an earlier version registered "
                 "camera '%1', perhaps by frames as stored")(Named::camera(recording.cameraName)),
        ODO_TEXT("workflow.register_upright", "register the camera again"));
}

std::vector<Message> turnedWarnings(const std::string &trialName, const std::vector<RegisteredView> &views,
                                    Opened which)
{
    std::vector<Message> sentences;
    const auto add = [&sentences](Message sentence) {
        if (!sentence.isEmpty())
            sentences.push_back(std::move(sentence));
    };
    for (const RegisteredView &view : views) {
        add(storedFrameWarning(trialName, view.recording, view.file, which));
        add(oldRegistrationWarning(trialName, view));
    }
    return sentences;
}

Result<std::vector<ProjectProblem>> turnedRecordings(Project &project, Opened which)
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
        if (trial != trials.end() && wouldBeShownOtherwise(recording, project.resolve(recording), which))
            problems.push_back({measuredAsStored(), viewInTrialSubject(recording.cameraName, trial->second),
                                importToTurn()});
    }
    return problems;
}

} // namespace odo
