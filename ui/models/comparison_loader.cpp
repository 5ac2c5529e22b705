// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/comparison_loader.h"

#include "core/project/project.h"

#include <utility>

namespace odo {

ComparisonLoader::ComparisonLoader(std::filesystem::path projectFile, QObject *parent)
    : QObject(parent), m_file(std::move(projectFile))
{
    connect(&m_task, &BackgroundTask::finished, this, &ComparisonLoader::finish);
}

void ComparisonLoader::load(CompareSettings settings)
{
    m_wanted = std::move(settings);
    if (!m_task.isRunning())
        begin();
}

void ComparisonLoader::begin()
{
    m_result = std::make_shared<ComparisonScenePtr>();
    m_task.start([file = m_file, settings = *std::exchange(m_wanted, std::nullopt),
                  result = m_result](const JobControl &) -> Result<void> {
        const auto project = Project::open(file, Project::Access::ReadOnly);
        if (!project)
            return tl::unexpected(project.error());
        auto scene = loadComparisonScene(**project, settings);
        if (!scene)
            return tl::unexpected(scene.error());
        *result = std::move(*scene);
        return {};
    });
}

void ComparisonLoader::finish(const std::optional<Error> &error)
{
    if (m_wanted) {
        begin();
        return;
    }
    if (error)
        Q_EMIT failed(*error);
    else
        Q_EMIT loaded(*m_result);
}

} // namespace odo
