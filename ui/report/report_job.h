// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/job.h"
#include "ui/report/page_output.h"
#include "ui/report/report_maker.h"

#include <filesystem>
#include <memory>

namespace odo {

/// Makes a report and gives its pages to a file or a printer. It reads by a connection of its own while it runs,
/// so the project never waits; what fails or is cancelled leaves nothing.
class ReportJob : public Job
{
public:
    ReportJob(ReportMaker maker, std::unique_ptr<PageOutput> output);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override; ///< nothing

    int pageCount() const { return m_pageCount; } ///< after run

private:
    ReportMaker m_maker;
    std::unique_ptr<PageOutput> m_output;
    std::filesystem::path m_project;
    int m_pageCount = 0;
};

} // namespace odo
