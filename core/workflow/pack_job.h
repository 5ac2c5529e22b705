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

/// Packs a project with everything that belongs to it into one file. Videos that lie elsewhere come into the
/// packed project's media folder; those that are lost, or are no longer the files that were measured, are named and left
/// out. The project itself is not changed.
class PackJob : public Job
{
public:
    explicit PackJob(OutputTarget archive) : m_archive(std::move(archive)) {}
    Result<void> prepare(Project &project) override;
    /// Errors: those of OutputFile; InvalidInput while a trial is being recorded.
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &) override { return {}; }

    const std::vector<std::string> &warnings() const { return m_warnings; } ///< after run

private:
    struct Elsewhere
    {
        RecordId recording = 0;
        std::filesystem::path file;
    };
    Result<void> look(Project &project, const JobControl &control);
    Result<void> copyProject(const std::filesystem::path &copy, std::vector<ArchiveEntry> &entries, const JobControl &control);

    const OutputTarget m_archive;
    std::filesystem::path m_project, m_mediaFolder;
    std::vector<Elsewhere> m_elsewhere;
    InputFiles m_inputs;
    std::vector<std::string> m_warnings;
};

} // namespace odo
