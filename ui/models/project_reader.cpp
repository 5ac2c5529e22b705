// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/project_reader.h"

#include "core/project/project.h"
#include "core/workflow/call_later.h"

#include <utility>

namespace odo {

ProjectReader::ProjectReader(std::filesystem::path projectFile, QObject *parent)
    : QObject(parent), m_file(std::move(projectFile))
{
    connect(&m_task, &BackgroundTask::finished, this, &ProjectReader::finish);
}

void ProjectReader::ask(Request request)
{
    const bool isFirst = !m_next;
    m_next = std::move(request);
    m_isWanted = false;
    if (isFirst)
        callLater(this, [this] { begin(); });
}

void ProjectReader::begin()
{
    if (!m_next || m_task.isRunning()) // else it begins when that has ended
        return;
    Request request = *std::exchange(m_next, std::nullopt);
    m_take = std::move(request.take);
    m_isWanted = true;
    m_task.start([file = m_file, what = std::move(request.what)](const JobControl &) -> Result<void> {
        const auto project = Project::openAgain(file, Project::Access::ReadOnly);
        return project ? what(**project) : tl::unexpected(project.error());
    });
}

void ProjectReader::finish(const std::optional<Error> &error)
{
    const auto take = std::exchange(m_take, nullptr);
    if (std::exchange(m_isWanted, false))
        take(error);
    begin();
}

} // namespace odo
