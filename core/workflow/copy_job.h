// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/job.h"

#include <filesystem>

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

} // namespace odo
