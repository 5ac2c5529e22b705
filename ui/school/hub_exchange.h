// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/school/school_sync.h"
#include "ui/models/background_task.h"

#include <QElapsedTimer>
#include <QHash>
#include <QObject>
#include <QString>
#include <QTimer>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace odo {

/// What is known of the open project's tie to the school's hub.
struct HubState
{
    enum class Work { None, Connecting, Publishing, Pulling };

    std::optional<SchoolLink> link; ///< nullopt: not connected
    std::int64_t pending = 0;       ///< changes that are still to be sent
    Work work = Work::None;
    double done = 0;              ///< of the work
    QString words;                ///< of the work that is going on, or of what came of the last one
    std::optional<Error> problem; ///< of the last exchange
    bool isPasswordWanted = false;
    bool isSilent = false; ///< the work waits for the server, for seconds by now

    bool isAway() const { return problem && problem->code == ErrorCode::Unavailable; }
};

/// For the foot of a window: "Hub: 3 pending, server away"; empty where the project is not connected.
QString hubStateWords(const HubState &state);

/// When changes are sent by themselves.
struct HubPace
{
    std::chrono::milliseconds look{500};    ///< at the project
    std::chrono::milliseconds quiet{4000};  ///< since the last change, before it is sent
    std::chrono::milliseconds again{5'000}; ///< after a failure; twice as long after each further one
    std::chrono::milliseconds longest{300'000};
};

/// The open project's tie to the school's hub: connects, publishes and pulls on a thread of its own, and
/// publishes by itself, without recordings, when the project has rested for a moment. Nothing here waits for
/// the server. Passwords are kept in memory alone, as long as it lives. GUI thread.
class HubExchange : public QObject
{
    Q_OBJECT
public:
    explicit HubExchange(HubPace pace = {}, QObject *parent = nullptr);
    ~HubExchange() override;

    /// null: none is open. Ends what goes on with the one before, which must still be open; that takes a
    /// moment, whatever the server does. The project must outlive this, or setProject(nullptr).
    void setProject(Project *project, bool isReadOnly = false);
    /// Where it is false nothing is sent by itself: the computer has more urgent work.
    void setMayPublish(std::function<bool()> mayPublish) { m_mayPublish = std::move(mayPublish); }

    const HubState &state() const { return m_state; }
    /// The hub that the project is connected to, with the password if one was entered; nullopt: none.
    std::optional<HubAddress> hub() const;
    bool isRunning() const { return m_state.work != HubState::Work::None; }
    bool isReadOnly() const { return m_isReadOnly; }
    /// What was changed here and elsewhere, the latest of each row, until it is read.
    const std::vector<SchoolConflict> &conflicts() const { return m_conflicts; }
    void forgetConflicts();

    /// Each begins; one at a time, a second one is ignored. changed() follows.
    void connectTo(const HubAddress &address, const QString &media);
    void publish(WithRecordings recordings);
    void pull(WithRecordings recordings);
    void cancel();
    /// What is not sent stays in the project. Not while anything runs.
    Result<void> disconnectFromHub();
    /// For the hub of the project, or one that it is to be connected to, at the next exchange.
    void setPassword(const HubAddress &address, const QString &password);

Q_SIGNALS:
    void changed();        ///< the state
    void received();       ///< the project has what others published
    void conflictsFound(); ///< more than before

private:
    using Exchange =
        std::function<Result<void>(Project &project, const JobControl &control, SchoolReport &report)>;
    void look();
    void followWork();
    void readState();
    bool isTime() const;
    void begin(HubState::Work work, Exchange exchange);
    void finish(const std::optional<Error> &error);
    void take(const SchoolReport &report);
    void exchangeBy(HubState::Work work, WithRecordings recordings);

    const HubPace m_pace;
    Project *m_project = nullptr;
    bool m_isReadOnly = false;
    std::function<bool()> m_mayPublish;
    HubState m_state;
    std::vector<SchoolConflict> m_conflicts;
    QHash<QString, QString> m_passwords; ///< by the hub's URL
    QTimer m_timer;
    std::optional<std::pair<std::int64_t, std::uint64_t>> m_seen; ///< the project's state
    bool m_isUnsent = false;              ///< something was changed since the last exchange
    QElapsedTimer m_rest;                 ///< since the last change
    QElapsedTimer m_progress;             ///< since the work went on
    QElapsedTimer m_since;                ///< the last exchange
    std::chrono::milliseconds m_delay{0}; ///< until the next one
    std::optional<QString> m_wordsBefore; ///< an exchange that nobody asked for; stay where it did nothing
    std::shared_ptr<SchoolReport> m_report;
    std::unique_ptr<BackgroundTask> m_task; ///< last, so that it ends first
};

} // namespace odo
