// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/school/hub_exchange.h"

#include "core/project/project.h"
#include "ui/models/shown_message.h"
#include "ui/school/internal/hub_words.h"

#include <algorithm>
#include <utility>

namespace odo {

namespace {
constexpr std::chrono::milliseconds longestSilence{4000}; ///< that nobody need know of
} // namespace

HubExchange::HubExchange(HubPace pace, QObject *parent) : QObject(parent), m_pace(pace)
{
    connect(&m_timer, &QTimer::timeout, this, &HubExchange::look);
    m_rest.start();
    m_since.start();
}

HubExchange::~HubExchange() = default;

void HubExchange::setProject(Project *project, bool isReadOnly)
{
    m_task.reset(); // cancels and waits
    m_project = project;
    m_isReadOnly = isReadOnly;
    m_state = {};
    m_conflicts.clear();
    m_seen.reset();
    m_wordsBefore.reset();
    m_delay = {};
    m_isUnsent = true; // what changed without the project being open, and what standings follow from
    m_rest.restart();
    if (!m_project) {
        m_timer.stop();
        Q_EMIT changed();
        return;
    }
    readState();
    m_timer.start(m_pace.look);
    Q_EMIT changed();
}

std::optional<HubAddress> HubExchange::hub() const
{
    if (!m_state.link)
        return std::nullopt;
    auto address = HubAddress::parse(m_state.link->url);
    if (!address)
        return std::nullopt;
    address->password = m_passwords.value(QString::fromStdString(m_state.link->url)).toStdString();
    return std::move(*address);
}

void HubExchange::forgetConflicts()
{
    m_conflicts.clear();
    Q_EMIT changed();
}

void HubExchange::readState()
{
    auto link = m_project->school().link();
    const auto pending = m_project->school().pending();
    if (!link || !pending)
        return; // busy, or the disk fails: the next reader gets the error
    m_state.link = std::move(*link);
    m_state.pending = *pending;
}

void HubExchange::look()
{
    const auto state = m_project->state();
    if (isRunning())
        return followWork();
    if (!state)
        return;
    const std::pair seen(state->byOthers, state->here);
    if (m_seen != seen) {
        const bool wasSeen = m_seen.has_value();
        m_seen = seen;
        if (wasSeen) {
            m_rest.restart();
            m_isUnsent = true;
        }
        readState();
        Q_EMIT changed();
    }
    if (!isTime())
        return;
    m_wordsBefore = m_state.words;
    exchangeBy(HubState::Work::Publishing, WithRecordings::No);
}

void HubExchange::followWork()
{
    const auto pending = m_state.pending;
    const bool wasSilent = std::exchange(m_state.isSilent, m_progress.hasExpired(longestSilence.count()));
    readState();
    if (m_state.pending != pending || m_state.isSilent != wasSilent)
        Q_EMIT changed();
}

bool HubExchange::isTime() const
{
    if (!m_isUnsent || !m_state.link || m_state.link->role == "viewer" || m_isReadOnly ||
        m_state.isPasswordWanted)
        return false;
    return m_rest.hasExpired(m_pace.quiet.count()) &&
           (m_delay.count() == 0 || m_since.hasExpired(m_delay.count())) && (!m_mayPublish || m_mayPublish());
}

void HubExchange::connectTo(const HubAddress &address, const QString &media)
{
    HubAddress whole = address;
    whole.password = m_passwords.value(QString::fromStdString(address.url())).toStdString();
    begin(HubState::Work::Connecting,
          [whole, folder = media.toStdString()](Project &project, const JobControl &control, SchoolReport &) {
              return withoutValue(connectToSchool(project, whole, folder, control));
          });
}

void HubExchange::publish(WithRecordings recordings)
{
    exchangeBy(HubState::Work::Publishing, recordings);
}

void HubExchange::pull(WithRecordings recordings)
{
    exchangeBy(HubState::Work::Pulling, recordings);
}

void HubExchange::exchangeBy(HubState::Work work, WithRecordings recordings)
{
    if (!m_state.link)
        return;
    const QString password = m_passwords.value(QString::fromStdString(m_state.link->url));
    const auto call = work == HubState::Work::Pulling ? &pullFromSchool : &publishToSchool;
    begin(work, [call, recordings, password = password.toStdString()](
                    Project &project, const JobControl &control, SchoolReport &report) {
        return withoutValue(call(project, recordings, control, {password, &report}));
    });
}

void HubExchange::begin(HubState::Work work, Exchange exchange)
{
    if (!m_project || m_isReadOnly || isRunning())
        return;
    m_state.work = work;
    m_state.done = 0;
    m_progress.restart();
    if (!m_wordsBefore)
        m_state.words.clear();
    m_report = std::make_shared<SchoolReport>();
    if (m_task)
        m_task.release()->deleteLater(); // it has ended, perhaps just now, in a call to us
    m_task = std::make_unique<BackgroundTask>();
    connect(m_task.get(), &BackgroundTask::progressed, this, [this](double done, const QString &words) {
        if (done != std::exchange(m_state.done, done))
            m_progress.restart();
        m_state.words = words.left(1).toUpper() + words.mid(1) + u'…';
        Q_EMIT changed();
    });
    connect(m_task.get(), &BackgroundTask::finished, this, &HubExchange::finish);
    m_task->start([file = m_project->file(), exchange = std::move(exchange),
                   report = m_report](const JobControl &control) -> Result<void> {
        const auto project = ODO_TRY(Project::openAgain(file, Project::Access::ReadWrite));
        return exchange(*project, control, *report);
    });
    Q_EMIT changed();
}

void HubExchange::finish(const std::optional<Error> &error)
{
    const auto work = std::exchange(m_state.work, HubState::Work::None);
    const bool isCancelled = error && error->code == ErrorCode::Cancelled;
    m_since.restart();
    m_state.isSilent = false;
    const std::optional<QString> before = std::exchange(m_wordsBefore, std::nullopt);
    const bool isQuiet = before && !error && m_report->sent == 0 && m_report->warnings.empty();
    m_state.words = error ? errorInWords(*error) : isQuiet ? *before : outcomeWords(work, *m_report);
    m_state.problem = isCancelled ? std::nullopt : error;
    m_state.isPasswordWanted = error && isPasswordNeeded(*error);
    if (!error)
        m_delay = {};
    else if (error->code == ErrorCode::Unavailable)
        m_delay = std::clamp(2 * m_delay, m_pace.again, m_pace.longest);
    else
        m_delay = m_pace.longest;
    readState();
    if (const auto state = m_project->state())
        m_seen = {state->byOthers, state->here}; // with what the exchange itself wrote
    m_isUnsent = error || work != HubState::Work::Publishing || m_state.pending > 0;
    take(*m_report); // also what was done before it failed
    Q_EMIT changed();
}

/// A row that was reported before has its newest values.
void HubExchange::take(const SchoolReport &report)
{
    for (const SchoolConflict &conflict : report.conflicts) {
        const auto known = std::ranges::find(m_conflicts, conflict.uuid, &SchoolConflict::uuid);
        if (known == m_conflicts.end())
            m_conflicts.push_back(conflict);
        else
            *known = conflict;
    }
    if (!report.conflicts.empty())
        Q_EMIT conflictsFound();
    if (report.received > 0 || report.mediaBytes > 0)
        Q_EMIT received();
}

void HubExchange::cancel()
{
    if (m_task)
        m_task->cancel();
}

Result<void> HubExchange::disconnectFromHub()
{
    if (!m_project || isRunning())
        return {};
    ODO_TRY(m_project->school().disconnect());
    const QString words = tr("Disconnected. All trials stay in the project.");
    m_state = {};
    m_state.words = words;
    m_conflicts.clear();
    readState();
    Q_EMIT changed();
    return {};
}

void HubExchange::setPassword(const HubAddress &address, const QString &password)
{
    m_passwords[QString::fromStdString(address.url())] = password;
    m_state.isPasswordWanted = false;
    m_delay = {};
    Q_EMIT changed();
}

} // namespace odo
