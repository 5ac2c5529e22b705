// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/run_recorder.h"

#include "core/base/shortage.h"
#include "core/project/project.h"
#include "core/workflow/job.h"
#include "core/workflow/record/completed_recordings.h"
#include "ui/models/shown_message.h"

namespace odo {
namespace {

constexpr auto storeEach = std::chrono::seconds(1);

} // namespace

/// What is to be recorded, for the thread that does it.
struct RunRecorder::Order
{
    NextRun run;
    std::vector<std::string> cameras;
    std::shared_ptr<CaptureSession> session;
    RunStart start;
};

RunRecorder::RunRecorder(std::filesystem::path project, QObject *parent)
    : QObject(parent), m_project(std::move(project))
{
}

RunRecorder::~RunRecorder()
{
    finish();
}

void RunRecorder::finish()
{
    end();
    awaitThread();
}

void RunRecorder::awaitThread()
{
    m_stopHashing.cancel();
    if (m_thread.joinable())
        m_thread.join();
}

void RunRecorder::begin(const NextRun &run, const std::vector<std::string> &cameras,
                        std::shared_ptr<CaptureSession> session, const RunStart &start)
{
    Q_ASSERT(m_state == State::Idle && session);
    awaitThread();
    m_stopHashing = CancelToken();
    m_endWanted = false; // nobody else is there just now
    m_state = State::Recording;
    const QString trial = QString::fromStdString(run.trial);
    auto thread =
        startThread(cannotDoThis(), [this, order = Order{run, cameras, std::move(session), start}]() mutable {
            work(std::move(order));
        });
    if (thread)
        m_thread = std::move(*thread);
    else
        tellEnd(trial, tl::unexpected(thread.error()));
}

void RunRecorder::end()
{
    if (m_state != State::Recording)
        return;
    m_state = State::Ending;
    const std::lock_guard lock(m_mutex);
    m_endWanted = true;
    m_wake.notify_all();
}

void RunRecorder::report(const Error &error)
{
    callLater(this, [this, error] { Q_EMIT failed(error); });
}

/// From now on another one may begin.
void RunRecorder::tellEnd(const QString &trial, const Result<std::vector<Message>> &warnings)
{
    callLater(this, [this, trial, warnings] {
        m_state = State::Idle;
        if (warnings)
            Q_EMIT recorded(trial, *warnings);
        else
            Q_EMIT gaveUp(trial, warnings.error());
    });
}

/// Waits for it, until it is time to store.
bool RunRecorder::isEndWanted()
{
    std::unique_lock lock(m_mutex);
    return m_wake.wait_for(lock, storeEach, [this] { return m_endWanted; });
}

/// The recording thread.
void RunRecorder::work(Order order)
{
    const QString trial = QString::fromStdString(order.run.trial);
    const auto project = Project::openAgain(m_project, Project::Access::ReadWrite);
    if (!project)
        return tellEnd(trial, tl::unexpected(project.error()));
    const Result<std::vector<Message>> warnings =
        orShortage(cannotDoThis(), [&] { return record(order, **project); });
    order.session.reset(); // others may need the cameras
    tellEnd(trial, warnings);
    makeHashes(**project);
}

/// Gives the warnings.
Result<std::vector<Message>> RunRecorder::record(const Order &order, Project &project)
{
    auto trial = ODO_TRY(trialOf(project, order.run));
    const auto live =
        ODO_TRY(LiveTrial::begin(project, std::move(trial), order.cameras, *order.session, order.start));
    while (!isEndWanted()) {
        if (const Result<void> stored = live->append(project); !stored)
            report(stored.error());
    }
    ODO_TRY(runToEnd(*live, project, {}));
    return live->warnings();
}

void RunRecorder::makeHashes(Project &project)
{
    HashJob hashes;
    if (const Result<void> done = runToEnd(hashes, project, {m_stopHashing, {}});
        !done && done.error().code != ErrorCode::Cancelled)
        report(done.error());
}

} // namespace odo
