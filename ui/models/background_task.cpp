// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/background_task.h"

#include "core/base/shortage.h"
#include "core/workflow/call_later.h"
#include "ui/models/core_words.h"

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
    const JobControl control{m_cancel, [this](double fraction, const std::string &text) {
                                 const QString words = shownWords(text);
                                 callLater(this, [this, fraction, words] { Q_EMIT progressed(fraction, words); });
                             }};
    const auto finishLater = [this](const Result<void> &result) {
        callLater(this, [this, result] {
            if (m_thread.joinable())
                m_thread.join();
            m_running = false;
            Q_EMIT finished(result ? std::nullopt : std::optional<Error>(result.error()));
        });
    };
    auto thread = startThread(cannotDoThis, [control, finishLater, work = std::move(work)] {
        finishLater(orShortage(cannotDoThis, [&] { return work(control); }));
    });
    if (thread)
        m_thread = std::move(*thread);
    else
        finishLater(tl::unexpected(thread.error()));
    return true;
}

} // namespace odo
