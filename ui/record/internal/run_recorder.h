// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/workflow/record/line_up.h"
#include "core/workflow/record/live_trial.h"

#include <QObject>
#include <QStringList>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace odo {

class CaptureSession;
class Project;

/// Records one trial at a time from cameras that run, for a window: on a thread of its own, which opens the
/// project once more and stores there once a second what has reached the disk, so that the window never waits
/// for a disk. Whatever happens to the recorder, what was recorded is kept: the destructor ends the recording
/// and completes the trial, which takes as long as the frames that wait for the disk. The files' hashes are
/// made after that, unless the next recording, or the end, comes first; see HashJob. Lives on one thread.
class RunRecorder : public QObject
{
    Q_OBJECT
public:
    /// project: its file, which must stay open as long as the recorder lives.
    explicit RunRecorder(std::filesystem::path project, QObject *parent = nullptr);
    ~RunRecorder() override;

    /// Not while one goes on. start: recorded from as far back as the session remembers. cameras: the
    /// name of each view of the session. gaveUp() follows, or, after end(), recorded().
    void begin(const NextRun &run, const std::vector<std::string> &cameras,
               std::shared_ptr<CaptureSession> session, const RunStart &start);
    void end();
    /// As end(), and waits until the trial is complete in the project: as long as the frames waiting for the
    /// disk take.
    void finish();
    bool isRecording() const { return m_state == State::Recording; }
    bool isEnding() const { return m_state == State::Ending; }

Q_SIGNALS:
    /// The trial is complete in the project. warnings: whole sentences.
    void recorded(const QString &trial, const std::vector<odo::Message> &warnings);
    /// It could not begin, with the errors of LiveTrial::begin; or it could not be completed, and what was
    /// recorded is when the project is opened again.
    void gaveUp(const QString &trial, const odo::Error &error);
    /// The project does not have all of what has reached the disk yet. The recording goes on.
    void failed(const odo::Error &error);

private:
    enum class State { Idle, Recording, Ending };
    struct Order;

    void work(Order order);
    Result<std::vector<Message>> record(const Order &order, Project &project);
    bool isEndWanted();
    void makeHashes(Project &project);
    void awaitThread();
    void tellEnd(const QString &trial, const Result<std::vector<Message>> &warnings);
    void report(const Error &error);

    const std::filesystem::path m_project;
    State m_state = State::Idle;
    std::thread m_thread;
    CancelToken m_stopHashing;
    std::mutex m_mutex; ///< guards what follows
    std::condition_variable m_wake;
    bool m_endWanted = false;
};

} // namespace odo
