// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// Looks for the lost videos of a project in a folder and all below it, by their content: a file counts when
/// its size and its SHA-256 are those of the recording, whatever its name is. What is found is linked where
/// it lies, as one change that can be undone.
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
    Result<void> look(const std::vector<std::filesystem::path> &files, const JobControl &control);

    const std::filesystem::path m_folder;
    std::filesystem::path m_project;
    std::vector<RecordingRecord> m_lost;
    std::vector<Found> m_found;
};

} // namespace odo
