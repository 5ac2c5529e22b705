// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace odo {

class MainWindow;

/// Ends the window as closing it does, with a recording finished and kept and no question asked, when the system asks: SIGTERM, SIGINT
/// (Ctrl-C) and SIGHUP after watchStopSignals(). At log-out and shutdown, which somebody may call off, it finishes the recording, and the
/// window stays. Beside the window; GUI thread.
class StopRequests : public QObject
{
    Q_OBJECT
public:
    explicit StopRequests(MainWindow &window);

private:
    void stop();

    MainWindow &m_window;
};

} // namespace odo
