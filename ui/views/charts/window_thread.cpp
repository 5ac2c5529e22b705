// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/window_thread.h"

#include "core/base/job_control.h"
#include "core/workflow/job_runner.h"

#include <QCoreApplication>
#include <QThread>
#include <chrono>
#include <future>
#include <memory>
#include <utility>

namespace odo {

void onWindowThread(std::function<void()> work)
{
    using namespace std::chrono_literals;
    if (QThread::currentThread() == qApp->thread()) {
        work();
        return;
    }
    const auto task = std::make_shared<std::packaged_task<void()>>(std::move(work));
    std::future<void> done = task->get_future();
    // Once the caller has given up, only what has begun keeps the task.
    callLater(qApp, [waiting = std::weak_ptr(task)] {
        if (const auto wanted = waiting.lock())
            (*wanted)();
    });
    // Looked at now and then: whoever cancels may wait for this thread, on the window's.
    while (done.wait_for(20ms) != std::future_status::ready)
        endIfCancelled();
    done.get();
}

} // namespace odo
