// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/project_watch.h"

#include "core/project/write_ahead_log.h"
#include "ui/models/background_task.h"

#include <QGuiApplication>
#include <chrono>

namespace odo {

namespace {

using std::chrono::milliseconds;
constexpr milliseconds checkInterval{500}, quietTime{1000}, longestUnwritten{5000};

} // namespace

ProjectWatch::ProjectWatch(Project &project, Access access, QObject *parent)
    : QObject(parent), m_project(project), m_access(access), m_task(std::make_unique<BackgroundTask>())
{
    const auto state = m_project.state();
    if (state)
        m_state = *state;
    if (!hasLog(m_project.file()))
        m_savedState = m_state;
    m_quiet.start();
    m_written.start();
    connect(&m_timer, &QTimer::timeout, this, &ProjectWatch::poll);
    connect(qGuiApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState active) {
        if (active != Qt::ApplicationActive)
            writeBack();
    });
    m_timer.start(checkInterval);
}

ProjectWatch::~ProjectWatch() = default;

void ProjectWatch::poll()
{
    if (!m_project.isInPlace()) {
        Q_EMIT lost();
        return; // the handler may have closed the project, and this with it
    }
    if (m_project.isOverwritten()) {
        Q_EMIT overwritten();
        return;
    }
    noteState();
    if (!isSaved() &&
        (m_quiet.hasExpired(quietTime.count()) || m_written.hasExpired(longestUnwritten.count())))
        writeBack();
}

void ProjectWatch::noteState()
{
    const auto state = m_project.state();
    if (!state)
        return; // busy, or the disk fails: the next reader gets the error
    const bool byOthers = m_state && state->byOthers != m_state->byOthers;
    const bool here = m_state && state->here != m_state->here;
    const bool wasSaved = isSaved();
    if (m_state != *state)
        m_quiet.restart();
    m_state = *state;
    if (isSaved() != wasSaved)
        Q_EMIT savedChanged();
    // Other threads of this program report their own changes. A change from outside in between is reported
    // once they are idle.
    const bool isOutside = (byOthers || m_isUnsure) && !here;
    m_isUnsure = (byOthers || m_isUnsure) && here;
    if (isOutside)
        Q_EMIT changedOutside();
}

void ProjectWatch::writeBack()
{
    if (m_access == Access::ReadOnly || isSaved() || m_task->isRunning())
        return;
    m_written.restart();
    const auto before = m_project.state();
    m_task = std::make_unique<BackgroundTask>();
    connect(m_task.get(), &BackgroundTask::finished, this, [this, before](const std::optional<Error> &error) {
        if (error || !before)
            return; // again at a later look
        m_savedState = *before;
        Q_EMIT savedChanged();
    });
    m_task->start([file = m_project.file()](const JobControl &) -> Result<void> {
        const auto project = ODO_TRY(Project::openAgain(file, Project::Access::ReadWrite));
        return project->writeBack() ? Result<void>() : cancelled(ODO_TEXT("ui.writing_back", "writing back"));
    });
}

} // namespace odo
