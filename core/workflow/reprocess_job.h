// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/job.h"
#include "core/workflow/profile_change.h"

#include <memory>
#include <string>
#include <vector>

namespace odo {

class TrackJob;

/// What analysing a trial again changes for one of its robots.
struct ReprocessedRobot
{
    std::string name;
    ProfileChange change;
};

/// Analyses the stored observations of a trial again with the registrations in force, and tells what that changes. Stores
/// nothing until keep() is called: a person looks first. NotFound where the trial was never tracked.
class ReprocessJob : public Job
{
public:
    explicit ReprocessJob(std::string trial);
    ~ReprocessJob() override;
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override; ///< nothing

    const std::string &trial() const { return m_trial; }
    const std::vector<ReprocessedRobot> &robots() const { return m_robots; } ///< after run
    /// Stores the new analyses beside the old ones, as the current ones; one transaction, on the project's thread.
    Result<void> keep(Project &project);

private:
    std::string m_trial;
    std::vector<std::pair<std::string, Profile>> m_before; ///< by robot
    std::unique_ptr<TrackJob> m_analysis;
    std::vector<ReprocessedRobot> m_robots;
};

} // namespace odo
