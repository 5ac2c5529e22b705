// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/background_task.h"

#include "core/base/shortage.h"
#include "core/project/project.h"
#include "core/workflow/job.h"
#include "ui/models/shown_message.h"

#include <utility>

namespace odo {

BackgroundTask::~BackgroundTask()
{
    m_cancel.cancel();
    if (m_thread.joinable())
        m_thread.join();
}

bool BackgroundTask::start(Work work)
{
    if (m_running)
        return false;
    m_running = true;
    m_cancel = CancelToken();
    const JobControl control{m_cancel, [this](double fraction, const Message &text) {
                                 const QString words = shownWords(text);
                                 callLater(this,
                                           [this, fraction, words] { Q_EMIT progressed(fraction, words); });
                             }};
    const auto finishLater = [this](const Result<void> &result) {
        callLater(this, [this, result] {
            if (m_thread.joinable())
                m_thread.join();
            m_running = false;
            Q_EMIT finished(result ? std::nullopt : std::optional<Error>(result.error()));
        });
    };
    auto thread = startThread(cannotDoThis(), [control, finishLater, work = std::move(work)] {
        finishLater(orShortage(cannotDoThis(), [&] {
            const CancelScope scope(&control.cancel);
            return work(control);
        }));
    });
    if (thread)
        m_thread = std::move(*thread);
    else
        finishLater(tl::unexpected(thread.error()));
    return true;
}

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
