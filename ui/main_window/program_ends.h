// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QObject>
#include <filesystem>
#include <optional>

namespace odo {

class MainWindow;

/// Says that the program ended by its own fault the last time, where the report of it is, and offers to open
/// the project that was open then, with what was recorded in it.
class CrashNotice : public QDialog
{
    Q_OBJECT
public:
    /// project: to be offered; empty: none.
    CrashNotice(const std::filesystem::path &report, const std::optional<std::filesystem::path> &project,
                QWidget *parent = nullptr);

Q_SIGNALS:
    void openRequested(const std::filesystem::path &project);
};

/// Shows a notice over the window if the folder holds crash reports not shown yet. opening: the project that
/// is being opened anyway. Does not wait.
void reportCrashes(MainWindow &window, const std::filesystem::path &folder,
                   const std::optional<std::filesystem::path> &opening);

/// Ends the window as closing it does, with a recording finished and kept and no question asked, when the
/// system asks: SIGTERM, SIGINT (Ctrl-C) and SIGHUP after watchStopSignals(). At log-out and shutdown, which
/// somebody may call off, it finishes the recording, and the window stays. Beside the window; GUI thread.
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
