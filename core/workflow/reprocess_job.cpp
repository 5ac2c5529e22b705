// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/reprocess_job.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track_job.h"

namespace odo {

ReprocessJob::ReprocessJob(std::string trial) : m_trial(std::move(trial)) {}

ReprocessJob::~ReprocessJob() = default;

Result<void> ReprocessJob::prepare(Project &project)
{
    const auto trial = project.trials().find(m_trial);
    if (!trial)
        return tl::unexpected(trial.error());
    auto analyses = project.analyses().current(trial->id);
    if (!analyses)
        return tl::unexpected(analyses.error());
    if (analyses->empty())
        return fail(ErrorCode::NotFound, "trial '" + m_trial + "'", "it has not been tracked yet, so there is nothing to analyse again",
                    "track it first");
    TrackSettings settings;
    settings.again = true;
    for (AnalysisRecord &analysis : *analyses) {
        settings.robots.push_back(analysis.robotName);
        m_before.emplace_back(analysis.robotName, std::move(analysis.profile));
    }
    m_analysis = std::make_unique<TrackJob>(m_trial, std::move(settings));
    return m_analysis->prepare(project);
}

Result<void> ReprocessJob::run(const JobControl &control)
{
    if (auto done = m_analysis->run(control); !done)
        return done;
    if (control.isCancelled())
        return cancelled("trial '" + m_trial + "'");
    const auto &after = m_analysis->outcome().robots;
    for (std::size_t i = 0; i < m_before.size(); ++i)
        m_robots.push_back({m_before[i].first, changeBetween(m_before[i].second, after[i].analysis.profile)});
    return {};
}

Result<void> ReprocessJob::commit(Project &) { return {}; }

Result<void> ReprocessJob::keep(Project &project) { return m_analysis->commit(project); }

} // namespace odo
