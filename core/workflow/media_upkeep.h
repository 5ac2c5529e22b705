// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace odo {

/// Searches a folder and all below it for the lost videos of a project, by their content: a file counts when
/// its size and its SHA-256 are those of the recording, whatever its name is. A found file is linked where it
/// is, as one change that can be undone.
class RelinkJob : public Job
{
public:
    explicit RelinkJob(std::filesystem::path folder) : m_folder(std::move(folder)) {}
    Result<void> prepare(Project &project) override;
    /// NotFound where no video is lost, or none of them lies there.
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    std::size_t lostCount() const { return m_lost.size(); }   ///< after run
    std::size_t foundCount() const { return m_found.size(); } ///< after run

private:
    struct Found
    {
        RecordId recording = 0;
        std::filesystem::path file;
    };
    Result<void> findLost();
    Result<void> inspect(const std::vector<std::filesystem::path> &files, const JobControl &control);

    const std::filesystem::path m_folder;
    std::filesystem::path m_project;
    std::vector<RecordingRecord> m_lost;
    std::vector<Found> m_found;
};

/// Finds the files in the media folder that nothing in the project refers to (strayMedia), and which of them
/// are whole videos.
class FindStraysJob : public Job
{
public:
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &) override { return {}; }

    /// after run: those that RemoveStraysJob takes
    const std::vector<std::filesystem::path> &strays() const { return m_strays; }
    /// after run: what stays in any case (StrayMedia)
    const std::vector<std::filesystem::path> &others() const { return m_others; }
    /// after run: those that AdoptStraysJob takes
    const std::vector<std::filesystem::path> &videos() const { return m_videos; }

private:
    std::filesystem::path m_project;
    std::vector<std::filesystem::path> m_strays, m_others, m_videos;
};

/// Makes trials "recovered: NAME" of stray videos, which stay where they are. Videos whose names differ only
/// in the camera, as recordings and imports are called (NAME_CAMERA), become the views of one trial.
class AdoptStraysJob : public Job
{
public:
    explicit AdoptStraysJob(std::vector<std::filesystem::path> videos) : m_videos(std::move(videos)) {}
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const std::vector<std::string> &trials() const { return m_trials; } ///< after commit
    /// After run: why videos were left, one a trial that could not be made.
    const std::vector<Error> &failures() const { return m_failures; }

private:
    const std::vector<std::filesystem::path> m_videos;
    std::vector<std::unique_ptr<ImportTrialJob>> m_imports;
    std::vector<std::string> m_trials;
    std::vector<Error> m_failures;
};

/// Removes stray files. What has become a trial's meanwhile, or is being written, stays.
class RemoveStraysJob : public Job
{
public:
    explicit RemoveStraysJob(std::vector<std::filesystem::path> strays) : m_strays(std::move(strays)) {}
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &) override { return {}; }

    const std::vector<std::filesystem::path> &removed() const { return m_removed; } ///< after run

private:
    const std::vector<std::filesystem::path> m_strays;
    std::filesystem::path m_project;
    std::vector<std::filesystem::path> m_removed;
};

class ReferredFiles;

/// What lies in the bin of a project.
struct BinContent
{
    std::vector<TrialName> trials;
    std::int64_t bytes = 0; ///< of their recordings
};
Result<BinContent> binContent(Project &project);

/// Removes trials for good, one after the other: each in a transaction of its own, and then those files of
/// its recordings that lie in the project's media folder and belong to no other trial, of this project or of
/// one beside it: files elsewhere are somebody's own. It cannot be undone, and is listed among the changes.
/// Works on a connection of its own, so that nobody waits for it. Cancelled, it ends well: what is removed is
/// gone, the rest stays in the bin. Trials restored from the bin meanwhile stay.
class EmptyBinJob : public Job
{
public:
    explicit EmptyBinJob(BinContent content) : m_content(std::move(content)) {}
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override; ///< nothing

    int wantedCount() const { return static_cast<int>(m_content.trials.size()); }
    int removedCount() const { return m_removed; } ///< after run
    /// Files that could not be deleted.
    const std::vector<std::string> &left() const { return m_left; }

private:
    Result<void> remove(Project &project, const TrialName &trial, const Result<ReferredFiles> &usedBeside);

    const BinContent m_content;
    std::filesystem::path m_file; ///< of the project
    int m_removed = 0;
    std::vector<std::string> m_left;
};

} // namespace odo
