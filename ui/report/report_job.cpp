// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_job.h"

#include "core/project/project.h"

namespace odo {

ReportJob::ReportJob(ReportMaker maker, std::unique_ptr<PageOutput> output)
    : m_maker(std::move(maker)), m_output(std::move(output))
{
}

Result<void> ReportJob::prepare(Project &project)
{
    m_project = project.file();
    return {};
}

Result<void> ReportJob::run(const JobControl &control)
{
    const auto project = Project::openAgain(m_project, Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    const std::unique_ptr<PageOutput> output = std::move(m_output); // gone with what it holds, however this ends
    auto made = m_maker(**project, control, [&](const ReportPage &page) -> Result<void> {
        ++m_pageCount;
        return output->add(page);
    });
    if (!made)
        return made;
    if (control.isCancelled())
        return cancelled("report");
    return output->finish();
}

Result<void> ReportJob::commit(Project &)
{
    return {};
}

} // namespace odo
