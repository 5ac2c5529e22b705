// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/recording_lock.h"
#include "core/project/records.h"
#include "core/video/recorded_times.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace odo {

/// Completes the trials whose recording was cut off, by a kill or a power cut: from the pictures that are in
/// their files and from the raw times in the project. The last pictures, whose times had not been stored yet,
/// get them from the file's own time stamps, which are whole milliseconds. Leaves alone what somebody is
/// recording just now, and a trial whose file is missing. A file without any picture is removed. The hashes
/// are left to HashJob.
class RecoverJob : public Job
{
public:
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    /// After prepare: whether there is anything to do; run and commit may be left out where not.
    bool isNeeded() const { return !m_trials.empty(); }
    /// After commit: a sentence for each trial.
    const std::vector<std::string> &told() const { return m_told; }

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
        std::vector<RecordingRecord> recordings; ///< after run
        std::string missing;                     ///< a file that is not there; then the trial stays as it is
        std::vector<std::filesystem::path> empty; ///< files that no picture has come into
    };
    Result<void> recover(Unfinished &unfinished, const CancelToken &cancel) const;
    static void removeEmpty(const Unfinished &unfinished);
    Result<void> complete(Project &project, Unfinished &unfinished);

    std::filesystem::path m_mediaFolder;
    std::unique_ptr<RecordingLock> m_lock;
    std::vector<Unfinished> m_trials;
    std::vector<std::string> m_told;
};

/// Completes them at once, hashes too, on the project's thread, and gives a sentence for each: what the
/// command line does on opening a project to write.
Result<std::vector<std::string>> recoverTrials(Project &project, const JobControl &control);

} // namespace odo
