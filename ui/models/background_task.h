// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <QObject>
#include <functional>
#include <optional>
#include <thread>

namespace odo {

/// Long work that belongs to no open project, on a thread of its own; one at a time. Signals come on the
/// object's thread. The destructor cancels and waits.
class BackgroundTask : public QObject
{
    Q_OBJECT
public:
    using Work = std::function<Result<void>(const JobControl &)>;

    using QObject::QObject;
    ~BackgroundTask() override;
    bool isRunning() const { return m_running; }
    /// False when it runs already.
    bool start(Work work);
    void cancel() { m_cancel.cancel(); }
    /// Whether cancel was called since the start; the work may have come to its end all the same.
    bool isCancelled() const { return m_cancel.isCancelled(); }

Q_SIGNALS:
    void progressed(double fraction, const QString &text);
    /// No error: it came to a good end.
    void finished(const std::optional<odo::Error> &error);

private:
    CancelToken m_cancel;
    std::thread m_thread;
    bool m_running = false;
};

} // namespace odo
