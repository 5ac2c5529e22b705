// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/school/hub_address.h"
#include "ui/scoreboard/internal/board_source.h"

#include <QTimer>
#include <chrono>
#include <memory>
#include <thread>

namespace odo {

/// The standings of a school's hub. A thread of its own asks the hub, so a server that does not answer holds
/// up nobody: the last standings stay, with a note, until it answers again. It never ends by itself.
class HubSource : public BoardSource
{
    Q_OBJECT
public:
    HubSource(HubAddress address, StandingsChoice choice);
    ~HubSource() override;
    /// Waits for the first answer of the server, some seconds at most. Errors: those of HubResults.
    Result<BoardContent> begin() override;

private:
    struct Mailbox;
    void follow();

    const HubAddress m_address;
    const StandingsChoice m_choice;
    const std::shared_ptr<Mailbox> m_mailbox; ///< also the thread's, which may be stuck in a call
    std::thread m_thread;
    BoardContent m_newest;
    QTimer m_timer;
};

} // namespace odo
