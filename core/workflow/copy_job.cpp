// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/copy_job.h"

#include "core/base/file_system.h"
#include "core/files/output_guard.h"
#include "core/project/project.h"

namespace odo {

Result<void> CopyJob::prepare(Project &project)
{
    m_project = project.file();
    return {};
}

Result<void> CopyJob::run(const JobControl &control)
{
    if (auto may = checkNewProject(m_copy, "copy '" + m_copy.filename().string() + "'"); !may)
        return may;
    control.report(0, "copying the project");
    const auto project = Project::openAgain(m_project, Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    if (auto saved = (*project)->saveCopy(m_copy); !saved)
        return saved;
    if (!control.isCancelled())
        return {};
    files::remove(m_copy);
    return cancelled("copy '" + m_copy.filename().string() + "'");
}

} // namespace odo
