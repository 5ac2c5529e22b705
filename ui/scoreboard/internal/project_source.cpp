// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoreboard/internal/project_source.h"

#include "core/project/project.h"
#include "ui/models/shown_names.h"

#include <utility>

namespace odo {

namespace {

/// How often others' changes are asked for: a change is on the page within a second, with time to spare.
constexpr std::chrono::milliseconds followInterval{200};

} // namespace

ProjectSource::ProjectSource(std::unique_ptr<Project> project, StandingsChoice choice)
    : m_project(std::move(project)), m_reader(*m_project, std::move(choice))
{
    connect(&m_timer, &QTimer::timeout, this, &ProjectSource::follow);
}

ProjectSource::~ProjectSource() = default;

Result<BoardContent> ProjectSource::begin()
{
    m_withPseudonyms = arePseudonymsShown();
    m_newest = ODO_TRY(m_reader.read());
    m_timer.start(followInterval);
    return m_newest;
}

void ProjectSource::follow()
{
    if (!m_project->isInPlace()) {
        m_timer.stop();
        Q_EMIT ended(
            fail(ErrorCode::Io, fileSubject(m_project->file()),
                 ODO_TEXT("ui.scoreboard_project_gone", "it was moved or deleted, so the standings ended"),
                 ODO_TEXT("ui.scoreboard_start_again", "start them with the file's present name"))
                .value());
        return;
    }
    if (!m_reader.hasChanged() && m_withPseudonyms == arePseudonymsShown())
        return;
    auto content = m_reader.read();
    if (!content && content.error().code != ErrorCode::NotFound)
        return; // busy, or the disk fails: read at the next look
    m_withPseudonyms = arePseudonymsShown();
    if (content)
        m_newest = std::move(*content);
    else
        m_newest.problem = content.error();
    Q_EMIT read(m_newest);
}

} // namespace odo
