// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <QObject>
#include <filesystem>
#include <functional>
#include <memory>
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

class Project;

/// Reads from a project on a thread of its own, by a reading connection of its own, so the window does not
/// wait. Only the newest request is answered. A request starts when the event loop runs again; of several
/// made before that, only the last starts. The window must have the project open meanwhile. GUI thread; the
/// destructor waits for the read.
class ProjectReader : public QObject
{
    Q_OBJECT
public:
    explicit ProjectReader(std::filesystem::path projectFile, QObject *parent = nullptr);

    /// what is called on the reader's thread; then, on the GUI thread, take with what it gave or why the
    /// project cannot be read.
    template <class Value>
    void read(std::function<Result<Value>(Project &)> what, std::function<void(Result<Value>)> take)
    {
        const auto value = std::make_shared<std::optional<Value>>();
        ask({[what = std::move(what), value](Project &project) -> Result<void> {
                 Value given = ODO_TRY(what(project));
                 *value = std::move(given);
                 return {};
             },
             [take = std::move(take), value](const std::optional<Error> &error) {
                 if (error)
                     take(tl::unexpected(*error));
                 else
                     take(std::move(**value));
             }});
    }
    /// A request has not been answered yet.
    bool isRunning() const { return m_next.has_value() || m_isWanted; }

private:
    struct Request
    {
        std::function<Result<void>(Project &)> what;
        std::function<void(const std::optional<Error> &)> take;
    };
    void ask(Request request);
    void begin();
    void finish(const std::optional<Error> &error);

    std::filesystem::path m_file;
    std::optional<Request> m_next; ///< not started yet
    std::function<void(const std::optional<Error> &)> m_take;
    bool m_isWanted = false; ///< what is being read
    BackgroundTask m_task;
};

} // namespace odo
