// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// Makes the hashes of recordings that have none yet: a recording ends without them, because reading
/// gigabytes again would hold up its result, and whoever closes the window. What is cancelled is made the
/// next time. A file that is not there, or not as it was, is left alone: a check of the project tells of it.
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

} // namespace odo
