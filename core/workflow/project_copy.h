// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/project_archive.h"
#include "core/files/protected_files.h"
#include "core/project/records.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace odo {

/// Saves a copy of the project's file; its videos stay where they are. A copy that is cancelled goes again.
/// Errors: those of Project::saveCopy.
class CopyJob : public Job
{
public:
    explicit CopyJob(std::filesystem::path copy) : m_copy(std::move(copy)) {}
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &) override { return {}; }

private:
    const std::filesystem::path m_copy;
    std::filesystem::path m_project;
};

/// Packs a project with everything that belongs to it into one file. Videos outside it come into the packed
/// project's media folder; those that are lost, or are no longer the files that were measured, are named and
/// left out. The project itself is not changed.
class PackJob : public Job
{
public:
    explicit PackJob(OutputTarget archive) : m_archive(std::move(archive)) {}
    Result<void> prepare(Project &project) override;
    /// Errors: those of OutputFile; InvalidInput while a trial is being recorded.
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &) override { return {}; }

    const std::vector<Message> &warnings() const { return m_warnings; } ///< after run

private:
    struct Elsewhere
    {
        RecordId recording = 0;
        std::filesystem::path file;
    };
    Result<void> inspect(Project &project, const JobControl &control);
    Result<void> copyProject(const std::filesystem::path &copy, std::vector<ArchiveEntry> &entries,
                             const JobControl &control);

    const OutputTarget m_archive;
    std::filesystem::path m_project, m_mediaFolder;
    std::vector<Elsewhere> m_elsewhere;
    InputFiles m_inputs;
    std::vector<Message> m_warnings;
};

/// Makes a project with the set-up of another one: cameras with their current intrinsics, marker layouts,
/// robots, and the tasks that are in use with how they are scored. Without people and trials; register the
/// cameras again at their new positions; the images of their calibration stay with the other project. Gives
/// the file. Any thread. Errors: those of Project::open and Project::create, and Cancelled; a partial file is
/// removed then, and a file that was there stays.
Result<std::filesystem::path> makeProjectLike(const std::filesystem::path &original,
                                              const std::filesystem::path &file, const std::string &title,
                                              const JobControl &control);

} // namespace odo
