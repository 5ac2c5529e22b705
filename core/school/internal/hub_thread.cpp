// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/internal/hub_thread.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace odo {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds lookInterval{20}; ///< for a cancellation
constexpr std::chrono::seconds slow{3}, longestSilence{120};
/// So many threads may be stuck at once; each keeps a connection until the server answers or goes away.
constexpr int mostStuck = 8;

std::atomic<int> stuckThreads = 0;

} // namespace

/// Between the thread that asks and the one that works.
struct HubThread::Desk
{
    std::mutex mutex;
    std::condition_variable changed;
    Work work; ///< empty: nothing to do
    bool isLeft = false, isStuck = false, hasEnded = false;

    void serve()
    {
        std::unique_ptr<SchoolHub> hub;
        std::unique_lock lock(mutex);
        for (;;) {
            changed.wait(lock, [this] { return isLeft || work; });
            if (isLeft)
                break;
            const Work current = work;
            lock.unlock();
            current(hub);
            lock.lock();
            work = nullptr;
            changed.notify_all();
        }
        lock.unlock();
        hub.reset();
        lock.lock();
        hasEnded = true;
        if (isStuck)
            --stuckThreads;
        changed.notify_all();
    }
};

HubThread::HubThread(HubAddress address) : m_address(std::move(address)) {}

HubThread::~HubThread()
{
    leave();
}

Result<void> HubThread::start()
{
    if (stuckThreads >= mostStuck)
        return fail(ErrorCode::Unavailable, m_address.subject(),
                    ODO_TEXT("school.never_answers", "the server takes connections and answers none"),
                    ODO_TEXT("school.check_server", "have the hub's administrator look at the server"));
    auto desk = std::make_shared<Desk>();
    m_thread = ODO_TRY(startThread(m_address.subject(), [desk] { desk->serve(); }));
    m_desk = std::move(desk);
    return {};
}

Error HubThread::lostConnection() const
{
    return {ErrorCode::Unavailable, m_address.subject(),
            ODO_TEXT("school.silent", "the server does not answer"), tryLater()};
}

/// Without waiting for one that is stuck.
void HubThread::leave()
{
    if (!m_desk)
        return;
    std::unique_lock lock(m_desk->mutex);
    m_desk->isLeft = true;
    m_desk->changed.notify_all();
    const bool isIdle = !m_desk->work;
    if (isIdle) // closing a connection asks nothing of the server
        m_desk->changed.wait_for(lock, std::chrono::seconds(1), [this] { return m_desk->hasEnded; });
    m_desk->isStuck = !m_desk->hasEnded;
    if (m_desk->isStuck)
        ++stuckThreads;
    const bool hasEnded = m_desk->hasEnded;
    lock.unlock();
    if (hasEnded)
        m_thread.join();
    else
        m_thread.detach();
    m_desk.reset();
}

Result<void> HubThread::await(Work work, const JobControl &control, const std::function<void()> &whenSlow)
{
    if (!m_desk)
        ODO_TRY(start());
    const auto begun = Clock::now();
    Clock::duration patience = slow;
    std::unique_lock lock(m_desk->mutex);
    m_desk->work = std::move(work);
    m_desk->changed.notify_all();
    while (!m_desk->changed.wait_for(lock, lookInterval, [this] { return !m_desk->work; })) {
        const auto waited = Clock::now() - begun;
        const bool isSilent = waited > longestSilence;
        lock.unlock();
        if (control.isCancelled() || isSilent) {
            leave();
            if (!isSilent)
                return cancelled(m_address.subject());
            return tl::unexpected(lostConnection());
        }
        if (waited > patience) {
            whenSlow();
            patience += slow;
        }
        lock.lock();
    }
    return {};
}

} // namespace odo
