// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/completed_recordings.h"

#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/capture/capture_session.h"
#include "core/files/file_words.h"
#include "core/project/project.h"
#include "core/project/project_media.h"
#include "core/project/project_words.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/video/video_reader.h"
#include "core/workflow/shared_words.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace odo {

namespace {

/// The raw times of the frames in the file: no more of them, and no fewer.
void fit(std::vector<RawTime> &frames, const std::vector<Nanoseconds> &fileTimes)
{
    if (fileTimes.empty())
        return frames.clear();
    frames.resize(std::min(frames.size(), fileTimes.size()));
    if (frames.empty())
        frames.push_back({});
    const RawTime last = frames.back();
    const Nanoseconds lastInFile = fileTimes[frames.size() - 1];
    for (std::size_t i = frames.size(); i < fileTimes.size(); ++i) {
        const Nanoseconds since = fileTimes[i] - lastInFile;
        frames.push_back({last.sequence, last.device + since, last.arrival + since});
    }
}

/// Of a file that cannot be played: whether it holds nothing but the beginning of one. Its name is not
/// enough: never delete what somebody might still recover a frame from.
bool hasNoFrame(const std::filesystem::path &file)
{
    constexpr std::uintmax_t mostWithout = 65536;
    std::error_code problem;
    if (files::sizeOf(file, problem) > mostWithout || problem)
        return false;
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    return !stream.bad() && bytes.find("\xff\xd8\xff") == std::string::npos; // how a JPEG image begins
}

} // namespace

Result<void> RecoverJob::prepare(Project &project)
{
    const auto trials = ODO_TRY(project.trials().all());
    if (std::ranges::none_of(trials, &TrialRecord::unfinished))
        return {};
    // else it was moved away: an empty one in its place would be in the way
    if (files::isFolder(project.mediaFolder())) {
        auto lock = RecordingLock::take(project.mediaFolder());
        if (!lock)
            return lock.error().code == ErrorCode::AlreadyExists ? Result<void>()
                                                                 : tl::unexpected(lock.error());
        m_lock = std::move(*lock);
    }
    m_mediaFolder = project.mediaFolder();
    for (const TrialRecord &trial : trials) {
        if (!trial.unfinished)
            continue;
        Unfinished unfinished{trial, {}, {}, {}, {}};
        const auto recordings = ODO_TRY(project.trials().recordings(trial.id));
        for (const RecordingRecord &record : recordings) {
            auto times = ODO_TRY(project.trials().rawTimes(record.id));
            unfinished.views.push_back({record, project.resolve(record), std::move(times)});
        }
        m_trials.push_back(std::move(unfinished));
    }
    return {};
}

Result<void> RecoverJob::run(const JobControl &control)
{
    for (std::size_t i = 0; i < m_trials.size(); ++i) {
        control.report(static_cast<double>(i) / static_cast<double>(m_trials.size()),
                       ODO_TEXT("workflow.completing_recording", "completing a recording that was cut off"));
        if (control.isCancelled())
            return cancelled(ODO_TEXT("workflow.completing_recordings", "completing the recordings"));
        ODO_TRY(recover(m_trials[i], control.cancel));
    }
    return {};
}

Result<void> RecoverJob::recover(Unfinished &unfinished, const CancelToken &cancel) const
{
    std::vector<EndedView> ended;
    for (View &view : unfinished.views) {
        if (!files::exists(view.file) && (!view.times.frames.empty() || !m_lock)) {
            unfinished.missing = view.file;
            return {};
        }
        const auto reader = VideoReader::open(view.file, cancel);
        if (!reader && reader.error().code == ErrorCode::Cancelled)
            return tl::unexpected(reader.error());
        if (!reader) { // it was cut off before a frame was on the disk
            if (view.times.frames.empty() && isOwnMedia(view.file, m_mediaFolder) && hasNoFrame(view.file))
                unfinished.empty.push_back(view.file);
            continue;
        }
        const VideoInfo &info = (*reader)->info();
        EndedView one{view.record, view.file, {}, 0, !view.times.frames.empty()};
        fit(view.times.frames, info.frameTimes);
        DerivedTimes derived = deriveTimes(view.times);
        one.taken = std::move(derived.taken);
        one.clockSigmaS = derived.sigmaS;
        one.record.widthPx = info.format.width;
        one.record.heightPx = info.format.height;
        ended.push_back(std::move(one));
    }
    auto recordings = ODO_TRY(describeRecordings(ended));
    unfinished.recordings = std::move(recordings);
    return {};
}

Result<void> RecoverJob::commit(Project &project)
{
    for (Unfinished &unfinished : m_trials)
        ODO_TRY(complete(project, unfinished));
    m_lock.reset();
    return {};
}

Result<void> RecoverJob::complete(Project &project, Unfinished &unfinished)
{
    TrialRecord &trial = unfinished.trial;
    const auto tell = [&](Message outcome, Message advice = {}) {
        const Message what = joined({trialSubject(trial.name), recordingWasCutOff()}, Join::Colon);
        m_problems.push_back(
            joined({what, joined({std::move(outcome), std::move(advice)}, Join::Colon)}, Join::Semicolon));
    };
    if (!unfinished.missing.empty()) {
        tell(isMissing(fileSubject(unfinished.missing)), restoreAndReopen());
        return {};
    }
    if (unfinished.recordings.empty()) {
        tell(ODO_TEXT("workflow.trial_left_out", "nothing of it had reached the disk, and it was removed"),
             ODO_TEXT("workflow.record_it_again", "record it again"));
        if (auto removed =
                project.note(ODO_TEXT("workflow.leave_out_trial",
                                      "remove %1, which recorded nothing")(Named::trial(trial.name)),
                             [&] { return project.trials().removeUnfinished(trial.id); });
            !removed)
            return removed;
        removeEmpty(unfinished);
        return {};
    }
    describeTrial(trial, unfinished.recordings);
    const MessageArgument length = quantity(trial.durationS, 1, "s");
    const std::size_t views = unfinished.recordings.size();
    tell(views == 1
             ? ODO_TEXT("workflow.view_is_kept",
                        "%1 of %2 view were saved, at most the last second is missing")(length, views)
             : ODO_TEXT("workflow.views_are_kept",
                        "%1 of %2 views were saved, at most the last second is missing")(length, views));
    if (auto completed =
            project.note(ODO_TEXT("workflow.complete_trial",
                                  "complete %1, whose recording was cut off")(Named::trial(trial.name)),
                         [&] { return project.trials().complete(trial, unfinished.recordings); });
        !completed)
        return completed;
    removeEmpty(unfinished);
    return {};
}

void RecoverJob::removeEmpty(const Unfinished &unfinished)
{
    for (const std::filesystem::path &file : unfinished.empty)
        files::remove(file);
}

Result<std::vector<Message>> recoverTrials(Project &project, const JobControl &control)
{
    RecoverJob job;
    ODO_TRY(job.prepare(project));
    if (!job.isNeeded())
        return std::vector<Message>{};
    ODO_TRY(job.run(control));
    ODO_TRY(job.commit(project));
    HashJob hashes;
    ODO_TRY(runToEnd(hashes, project, control));
    return job.problems();
}

Result<void> HashJob::prepare(Project &project)
{
    const auto recordings = ODO_TRY(project.trials().unhashed());
    for (const RecordingRecord &recording : recordings) {
        File file{recording.id, project.resolve(recording), recording.bytes, {}};
        std::error_code problem;
        const std::uintmax_t bytes = files::sizeOf(file.path, problem);
        if (!problem && bytes == static_cast<std::uintmax_t>(file.bytes))
            m_files.push_back(std::move(file));
    }
    return {};
}

Result<void> HashJob::run(const JobControl &control)
{
    for (std::size_t i = 0; i < m_files.size(); ++i) {
        control.report(static_cast<double>(i) / static_cast<double>(m_files.size()),
                       ODO_TEXT("workflow.making_hash",
                                "computing the hash of %1")(Named::file(m_files[i].path.filename())));
        auto hash = fileSha256(m_files[i].path, control);
        if (hash)
            m_files[i].sha256 = std::move(*hash);
        else if (hash.error().code == ErrorCode::Cancelled)
            return tl::unexpected(hash.error());
    }
    return {};
}

Result<void> HashJob::commit(Project &project)
{
    return project.inTransaction([&]() -> Result<void> {
        for (const File &file : m_files) {
            if (file.sha256.empty())
                continue;
            ODO_TRY(project.trials().setHash(file.recording, file.sha256));
        }
        return {};
    });
}

namespace {

void putInStep(RecordingRecord &record, const EndedView &view, const EndedView &first)
{
    if (!view.clockKnown || !first.clockKnown) {
        record.syncMethod = "none";
        return;
    }
    record.syncMethod = "clock";
    record.startOffsetS = toSeconds(view.taken.front() - first.taken.front());
    record.startOffsetSigmaS = std::hypot(view.clockSigmaS, first.clockSigmaS);
}

} // namespace

Result<std::vector<RecordingRecord>> describeRecordings(const std::vector<EndedView> &views)
{
    std::vector<RecordingRecord> records;
    const EndedView *first = nullptr;
    for (const EndedView &view : views) {
        if (view.taken.empty())
            continue;
        RecordingRecord record = view.record;
        record.position = static_cast<int>(records.size());
        record.frameTimes.clear();
        for (const Nanoseconds taken : view.taken)
            record.frameTimes.push_back(taken - view.taken.front());
        const double lengthS = toSeconds(record.frameTimes.back());
        record.framesPerSecond = lengthS > 0 ? static_cast<double>(view.taken.size() - 1) / lengthS : 0;
        if (!first)
            first = &view;
        else
            putInStep(record, view, *first);
        std::error_code problem;
        record.bytes = static_cast<std::int64_t>(files::sizeOf(view.file, problem));
        if (problem)
            return cannotBeInspected(quotedFileSubject(view.file), problem, checkFileIsThere());
        records.push_back(std::move(record));
    }
    return records;
}

void describeTrial(TrialRecord &trial, const std::vector<RecordingRecord> &recordings)
{
    trial.durationS = toSeconds(recordings.front().frameTimes.back());
    trial.syncMethod = "none";
    if (recordings.size() < 2)
        return;
    trial.syncMethod = recordings[1].syncMethod;
    trial.syncOffsetS = recordings[1].startOffsetS;
    trial.syncOffsetSigmaS = recordings[1].startOffsetSigmaS;
    trial.syncScore = trial.syncMethod == "clock" ? 1 : 0;
}

} // namespace odo
