// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_job.h"

#include "core/project/project.h"
#include "ui/report/pdf_file.h"

namespace odo {

ReportJob::ReportJob(ReportMaker maker, std::filesystem::path file, QString title)
    : m_maker(std::move(maker)), m_file(std::move(file)), m_title(std::move(title))
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
    PdfFile file(m_file, m_title);
    const auto made = m_maker(**project, control, [&](const ReportPage &page) -> Result<void> {
        ++m_pageCount;
        return file.add(page);
    });
    if (!made)
        return made;
    if (control.isCancelled())
        return cancelled("report");
    return file.finish();
}

Result<void> ReportJob::commit(Project &)
{
    return {};
}

} // namespace odo
