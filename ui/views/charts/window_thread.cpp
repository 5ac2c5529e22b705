// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/window_thread.h"

#include "core/base/job_control.h"
#include "core/workflow/job_runner.h"

#include <QCoreApplication>
#include <QThread>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>

namespace odo {

namespace {

/// Work on its way from one thread to another.
struct Errand
{
    std::function<void()> work;
    std::mutex mutex;
    std::condition_variable changed;
    bool isDone = false, isGivenUp = false;
    std::exception_ptr failure;
};

void run(Errand &errand)
{
    {
        const std::lock_guard lock(errand.mutex);
        if (errand.isGivenUp)
            return;
    }
    std::exception_ptr failure;
    try {
        errand.work();
    } catch (...) {
        failure = std::current_exception();
    }
    const std::lock_guard lock(errand.mutex);
    errand.failure = failure;
    errand.isDone = true;
    errand.changed.notify_all();
}

} // namespace

void onWindowThread(std::function<void()> work)
{
    using namespace std::chrono_literals;
    if (QThread::currentThread() == qApp->thread()) {
        work();
        return;
    }
    const auto errand = std::make_shared<Errand>();
    errand->work = std::move(work);
    callLater(qApp, [errand] { run(*errand); });
    std::unique_lock lock(errand->mutex);
    // Looked at now and then: whoever cancels may wait for this thread, on the window's.
    while (!errand->changed.wait_for(lock, 20ms, [&] { return errand->isDone; })) {
        if (const CancelToken *cancel = CancelScope::current(); cancel && cancel->isCancelled()) {
            errand->isGivenUp = true;
            throw WorkCancelled();
        }
    }
    if (errand->failure)
        std::rethrow_exception(errand->failure);
}

} // namespace odo
