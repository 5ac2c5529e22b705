// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

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
