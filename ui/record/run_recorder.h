// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/line_up.h"
#include "core/workflow/live_trial.h"

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <memory>
#include <optional>
#include <thread>

namespace odo {

class CaptureSession;
class Project;

/// Records one trial at a time from cameras that run, for a window: what has reached the disk is told to the
/// project once a second, and the end is written on a thread of its own. Whatever happens to the recorder,
/// what was recorded is kept: the destructor ends the recording and completes the trial. Lives on the
/// project's thread.
class RunRecorder : public QObject
{
    Q_OBJECT
public:
    explicit RunRecorder(Project &project, QObject *parent = nullptr);
    ~RunRecorder() override;

    /// cameras: the name of each view of the session. Errors: those of LiveTrial::begin.
    Result<void> begin(const NextRun &run, const std::vector<std::string> &cameras,
                       std::shared_ptr<CaptureSession> session, Nanoseconds preRoll);
    /// recorded() or failed() follows.
    void end();
    bool isRecording() const { return m_trial != nullptr && !m_ending; }
    bool isEnding() const { return m_ending; }

Q_SIGNALS:
    /// The trial is complete in the project. warnings: whole sentences.
    void recorded(const QString &trial, const QStringList &warnings);
    void failed(const odo::Error &error);

private:
    void append();
    void complete(const Result<void> &ended);

    Project &m_project;
    std::shared_ptr<CaptureSession> m_session;
    std::shared_ptr<LiveTrial> m_trial;
    bool m_ending = false;
    Result<void> m_ended; ///< of the thread; read after it was joined
    std::thread m_thread;
    QTimer m_timer;
};

} // namespace odo
