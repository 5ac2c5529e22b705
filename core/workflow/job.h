// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <QMetaObject>
#include <QObject>
#include <memory>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>

namespace odo {

class Project;

/// A use case in three steps, so that long work never touches the project and the project never waits for
/// long work: prepare reads what is needed, run works on values alone, commit stores the outcome in one
/// transaction. A failed or cancelled job leaves the project as it was.
class Job
{
public:
    virtual ~Job() = default;
    /// On the project's thread; quick.
    virtual Result<void> prepare(Project &project) = 0;
    /// On any thread; long; asks control for cancellation at least ten times a second.
    virtual Result<void> run(const JobControl &control) = 0;
    /// On the project's thread; quick; one transaction.
    virtual Result<void> commit(Project &project) = 0;
};

/// All three steps on the calling thread: what the command line does.
Result<void> runToEnd(Job &job, Project &project, const JobControl &control);

class Job;

/// Runs one Job at a time for a window: prepare and commit on the runner's (the project's) thread, run on a
/// thread of its own. Signals are emitted on the runner's thread. The destructor cancels and waits.
class JobRunner : public QObject
{
    Q_OBJECT
public:
    explicit JobRunner(Project &project, QObject *parent = nullptr);
    ~JobRunner() override;

    bool isRunning() const { return m_job != nullptr; }
    /// False when another job runs. finished() is emitted in every other case.
    bool start(std::shared_ptr<Job> job);
    void cancel();

Q_SIGNALS:
    void progressed(double fraction, const odo::Message &text);
    /// Once a job, after commit: no error on success. job is the one given to start.
    void finished(const std::shared_ptr<odo::Job> &job, const std::optional<odo::Error> &error);

private:
    void finish(const Result<void> &result);

    Project &m_project;
    std::shared_ptr<Job> m_job;
    CancelToken m_cancel;
    std::thread m_thread;
};

} // namespace odo

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace odo {

/// A call queued from one thread to another. Qt's event queue orders what both do with it, by a lock that
/// ThreadSanitizer cannot see in a library that is not built with it; in its builds we declare that order
/// here, so that whatever it still reports is ours.
template <class Call>
class PendingCall
{
public:
    explicit PendingCall(Call call) : m_call(std::move(call)) {}
    // NOLINTNEXTLINE(performance-noexcept-move-constructor): may throw what the call's own may
    PendingCall(PendingCall &&other) noexcept(std::is_nothrow_move_constructible_v<Call>)
        : m_call(std::move(other.m_call))
    {
        handOver();
    }
    ~PendingCall() { takeOver(); }
    PendingCall &operator=(PendingCall &&) = delete;

    void operator()()
    {
        takeOver();
        m_call();
    }

private:
#ifdef __SANITIZE_THREAD__
    static inline char s_order = 0;
    static void handOver()
    {
        __tsan_release(&s_order);
    }
    static void takeOver()
    {
        __tsan_acquire(&s_order);
    }
#else
    static void handOver() {}
    static void takeOver() {}
#endif
    Call m_call;
};

/// Calls on the context's thread, in a later turn of its event loop, in the order in which one thread asks;
/// never after the context is gone. Any thread: this is how threads report to windows and jobs.
template <class Call>
void callLater(QObject *context, Call &&call)
{
    QMetaObject::invokeMethod(context, PendingCall<std::decay_t<Call>>(std::forward<Call>(call)),
                              Qt::QueuedConnection);
}

} // namespace odo
