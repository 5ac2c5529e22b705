// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/job.h"
#include "core/workflow/track/view_synchronisation.h"

#include <memory>
#include <string>
#include <vector>

namespace odo {

class TrackJob;

/// Synchronises the views of a stored trial again, and analyses what was tracked in it once more by the new
/// clocks; one change, which can be undone. The synchronisation that it had stays in the list of changes, the
/// analyses that it had in the project. Errors: NotFound for the trial; InvalidInput where there are no two
/// views; Undetermined, with the reason, where nothing gives an offset that is to be found.
class SynchroniseJob : public Job
{
public:
    /// steps: of the views but the first, as stepsFor reads them.
    SynchroniseJob(std::string trial, std::vector<ViewStep> steps);
    ~SynchroniseJob() override;
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const TrialRecord &trial() const { return m_trial; }                ///< after run
    std::vector<RecordingRecord> recordings() const;                    ///< after run
    const std::vector<Message> &warnings() const { return m_warnings; } ///< whole sentences

private:
    Result<void> prepareAnalysis(Project &project);

    SyncRequest m_request;
    TrialRecord m_trial;
    std::vector<RegisteredView> m_before, m_views;
    std::unique_ptr<TrackJob> m_analysis; ///< null: nothing was tracked
    std::vector<Message> m_warnings;
};

} // namespace odo
