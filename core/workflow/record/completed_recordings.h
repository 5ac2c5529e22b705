// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project_locks.h"
#include "core/project/records.h"
#include "core/video/frame_times.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace odo {

/// Completes the trials whose recording was cut off, by a kill or a power cut: from the frames that are in
/// their files and from the raw times in the project. The last frames, whose times had not been stored yet,
/// get them from the file's own time stamps, which are whole milliseconds. Leaves alone what somebody is
/// recording just now, and a trial whose file is missing. A file without any frame is removed. The hashes are
/// left to HashJob.
class RecoverJob : public Job
{
public:
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    /// After prepare: whether there is anything to do; run and commit may be left out where not.
    bool isNeeded() const { return !m_trials.empty(); }
    /// After commit: a sentence for each trial.
    const std::vector<Message> &problems() const { return m_problems; }

private:
    struct View
    {
        RecordingRecord record;
        std::filesystem::path file;
        RecordedTimes times;
    };
    struct Unfinished
    {
        TrialRecord trial;
        std::vector<View> views;
        std::vector<RecordingRecord> recordings;  ///< after run
        std::filesystem::path missing;            ///< a file that is not there; then the trial stays as it is
        std::vector<std::filesystem::path> empty; ///< files without a frame
    };
    Result<void> recover(Unfinished &unfinished, const CancelToken &cancel) const;
    static void removeEmpty(const Unfinished &unfinished);
    Result<void> complete(Project &project, Unfinished &unfinished);

    std::filesystem::path m_mediaFolder;
    std::unique_ptr<RecordingLock> m_lock;
    std::vector<Unfinished> m_trials;
    std::vector<Message> m_problems;
};

/// Completes them at once, hashes too, on the project's thread, and gives a sentence for each: what the
/// command line does on opening a project to write.
Result<std::vector<Message>> recoverTrials(Project &project, const JobControl &control);

/// Makes the hashes of recordings that have none yet: a recording ends without them, because reading
/// gigabytes again would hold up its result, and whoever closes the window. What is cancelled is made the
/// next time. A file that is not there, or not as it was, is left alone: a check of the project reports it.
class HashJob : public Job
{
public:
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    /// Of those that were made, also after a run that was cancelled.
    Result<void> commit(Project &project) override;

    bool isNeeded() const { return !m_files.empty(); } ///< after prepare; run and commit may be left out

private:
    struct File
    {
        RecordId recording = 0;
        std::filesystem::path path;
        std::int64_t bytes = 0;
        std::string sha256; ///< after run; empty: not made
    };
    std::vector<File> m_files;
};

/// A view whose recording has ended.
struct EndedView
{
    RecordingRecord record; ///< id and camera; the rest is filled in
    std::filesystem::path file;
    std::vector<Nanoseconds> taken; ///< of each frame, by one clock for all views
    double clockSigmaS = 0;
    bool clockKnown = true; ///< false: taken is right against itself alone
};

/// Frame times, rate, sync and size of the views that have frames, the first of which is the first view. The
/// hash is left to HashJob. Errors: Io.
Result<std::vector<RecordingRecord>> describeRecordings(const std::vector<EndedView> &views);

/// Duration and sync of a trial with these recordings, one at least.
void describeTrial(TrialRecord &trial, const std::vector<RecordingRecord> &recordings);

} // namespace odo
