// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/benchmark/live/live_measurement.h"
#include "ui/record/internal/live_board.h"
#include "ui/record/internal/run_recorder.h"
#include "ui/record/internal/running_cameras.h"

#include <QApplication>
#include <QTimer>

#include <functional>

namespace odo {
class Project;
}

namespace odo::test {

/// Knows the longest that an event of the window's thread took, in processor time. (BusyWatch looks all the
/// time, which would be seen in what is measured here.)
class WatchedApplication : public QApplication
{
    Q_OBJECT
public:
    using QApplication::QApplication;
    bool notify(QObject *receiver, QEvent *event) override;
    /// Since the last call.
    double takeLongestMs() { return std::exchange(m_longestMs, 0); }

private:
    bool m_isInside = false;
    double m_longestMs = 0;
};

/// Whether what goes on is painted as well.
enum class LiveWindow { Shown, Hidden };

/// The parts of Record mode put together as its page has them: two cameras that run, their pictures and the
/// map in a window, a robot that is followed, a trial that is recorded. Measures itself meanwhile. GUI
/// thread.
class LiveRig : public QObject
{
    Q_OBJECT
public:
    /// uris: of cameras A and B. open: how they are opened.
    LiveRig(Project &project, RunningCameras::Open open, const std::array<std::string, 2> &uris,
            LiveWindow window);

    /// Waits until both cameras deliver. Errors: those of opening; Unavailable when they do not within a
    /// minute.
    Result<void> waitForCameras();
    /// Records for so long, and looks at what was recorded. each: called every five seconds but the first and
    /// last.
    Result<LiveMeasurement> record(double seconds, const std::function<void()> &each);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void takeMoment(const LiveMoment &moment);
    Result<void> readRecordings(const std::string &trial, LiveMeasurement &measured) const;

    Project &m_project;
    const LiveWindow m_window;
    RunningCameras m_cameras;
    LiveBoard m_board;
    RunRecorder m_recorder;
    QTimer m_health;
    std::optional<Error> m_failure;
    std::vector<Nanoseconds>
        m_unpainted; ///< when the places were taken that the map has got and not painted yet
    LiveMeasurement m_measured;
    bool m_measuring = false;
};

} // namespace odo::test
