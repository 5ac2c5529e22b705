// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/health_watch.h"

#include "core/project/project.h"
#include "ui/models/core_words.h"
#include "ui/record/chosen_cameras.h"
#include "ui/record/health_words.h"
#include "ui/record/live_board.h"
#include "ui/record/trouble_bar.h"

#include <QCoreApplication>
#include <algorithm>

namespace odo {
namespace {

class HealthWatchWords
{
    Q_DECLARE_TR_FUNCTIONS(HealthWatch)
};

} // namespace

HealthWatch::HealthWatch(const Project &project, bool readOnly, ChosenCameras &cameras, LiveBoard &board,
                         TroubleBar &trouble)
    : m_project(project), m_readOnly(readOnly), m_cameras(cameras), m_board(board), m_trouble(trouble)
{
}

void HealthWatch::look()
{
    if (!m_cameras.session())
        return;
    CaptureHealth health = m_cameras.session()->health();
    if (!health.disk.recording)
        health.disk.secondsLeft = m_cameras.session()->secondsOfRoom(m_project.file().parent_path());
    const LiveFigures live = m_cameras.tracker() ? m_cameras.tracker()->figures() : LiveFigures{};
    m_board.setHealth(health, m_cameras.cameras(), live, m_before);
    m_room = shownWords(roomWords(health.disk));
    m_anyDelivers = std::ranges::any_of(
        health.views, [](const ViewHealth &view) { return view.state == ViewHealth::State::Delivering; });
    const bool allEnded = std::ranges::all_of(
        health.views, [](const ViewHealth &view) { return view.state == ViewHealth::State::Ended; });
    m_hasEnded = health.disk.ended || allEnded;
    showTrouble(health);
}

void HealthWatch::countFromNow()
{
    m_before = m_cameras.session()->health();
}

QString HealthWatch::blocked() const
{
    if (m_readOnly)
        return HealthWatchWords::tr("The project can only be read");
    if (!m_cameras.session())
        return m_cameras.isPreparing() ? HealthWatchWords::tr("Opening the cameras…")
                                       : HealthWatchWords::tr("No camera runs");
    return m_anyDelivers ? QString() : HealthWatchWords::tr("No camera sends pictures");
}

void HealthWatch::showTrouble(const CaptureHealth &health)
{
    const auto &cameras = m_cameras.cameras();
    QString words = troubleWords(health, cameras);
    if (m_readOnly)
        words = HealthWatchWords::tr("This project can only be read: nothing can be recorded into it.");
    const QString unregistered = m_cameras.session() ? unregisteredWords(cameras) : QString();
    if (words.isEmpty() && !unregistered.isEmpty())
        m_trouble.setWords(unregistered, HealthWatchWords::tr("Register &it in Testbed"));
    else
        m_trouble.setWords(words);
}

} // namespace odo
