// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoreboard/internal/hub_source.h"

#include "core/base/shortage.h"
#include "ui/scoreboard/internal/hub_reader.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace odo {

namespace {

using Clock = std::chrono::steady_clock;

/// How often the hub is asked whether anything changed. Asking needs no channel beside the queries, works
/// through a pooler of connections, and shows at once that the server is away, which a LISTEN would not.
constexpr std::chrono::milliseconds askInterval{300};
/// How often this thread takes what the other one brought.
constexpr std::chrono::milliseconds takeInterval{50};
/// After that a server that says nothing counts as away.
constexpr std::chrono::seconds longestSilence{4};
/// The first answer may take as long as a connection and a query may.
constexpr std::chrono::seconds longestStart{30};

tl::unexpected<Error> silent(const HubAddress &address)
{
    return fail(ErrorCode::Unavailable, address.subject(),
                ODO_TEXT("ui.hub_silent", "the server does not answer"), checkHubAddress());
}

/// What the page says: it is not for those who see it where the hub is.
Error shownProblem(const Error &error)
{
    const bool isAway = error.code == ErrorCode::Unavailable;
    return {error.code, ODO_TEXT("school.subject", "school hub"),
            isAway ? Message(ODO_TEXT("ui.hub_away", "it cannot be reached")) : error.why,
            ODO_TEXT("ui.hub_goes_on", "the page shows the last standings until it is back")};
}

} // namespace

/// Between the thread that asks and the one that serves.
struct HubSource::Mailbox
{
    std::mutex mutex;
    std::condition_variable changed;
    bool isCancelled = false, hasEnded = false;
    bool isAnswered = false;                      ///< the last question, without an error
    std::optional<Clock::time_point> askedAt;     ///< while an answer is awaited
    std::optional<Result<BoardContent>> received; ///< the newest, until it is taken

    void ask(HubReader &reader)
    {
        std::unique_lock lock(mutex);
        while (!isCancelled) {
            askedAt = Clock::now();
            lock.unlock();
            auto answer = reader.readIfChanged();
            lock.lock();
            askedAt.reset();
            isAnswered = answer.has_value();
            if (!answer)
                received = Result<BoardContent>(tl::unexpected(answer.error()));
            else if (*answer)
                received = Result<BoardContent>(std::move(**answer));
            changed.notify_all();
            changed.wait_for(lock, askInterval, [this] { return isCancelled; });
        }
        hasEnded = true;
        changed.notify_all();
    }
};

HubSource::HubSource(HubAddress address, StandingsChoice choice)
    : m_address(std::move(address)), m_choice(std::move(choice)), m_mailbox(std::make_shared<Mailbox>())
{
    connect(&m_timer, &QTimer::timeout, this, &HubSource::follow);
}

HubSource::~HubSource()
{
    if (!m_thread.joinable())
        return;
    std::unique_lock lock(m_mailbox->mutex);
    m_mailbox->isCancelled = true;
    m_mailbox->changed.notify_all();
    const bool hasEnded =
        m_mailbox->changed.wait_for(lock, std::chrono::seconds(1), [this] { return m_mailbox->hasEnded; });
    lock.unlock();
    if (hasEnded)
        m_thread.join();
    else
        m_thread
            .detach(); // stuck in a call that nobody can end; it keeps the mailbox, and touches nothing else
}

Result<BoardContent> HubSource::begin()
{
    m_thread = ODO_TRY(
        startThread(m_address.subject(), [mailbox = m_mailbox, address = m_address, choice = m_choice] {
            HubReader reader(address, choice);
            mailbox->ask(reader);
        }));
    std::unique_lock lock(m_mailbox->mutex);
    m_mailbox->changed.wait_for(lock, longestStart, [this] { return m_mailbox->received.has_value(); });
    if (!m_mailbox->received)
        return silent(m_address);
    m_newest = ODO_TRY(std::move(*std::exchange(m_mailbox->received, std::nullopt)));
    m_timer.start(takeInterval);
    return m_newest;
}

void HubSource::follow()
{
    std::unique_lock lock(m_mailbox->mutex);
    auto received = std::exchange(m_mailbox->received, std::nullopt);
    const auto askedAt = m_mailbox->askedAt;
    const bool isAnswered = m_mailbox->isAnswered;
    lock.unlock();
    const bool isSilent = askedAt && Clock::now() - *askedAt > longestSilence;
    if (received && *received)
        m_newest = std::move(**received);
    else if (received)
        m_newest.problem = shownProblem(received->error());
    else if (isSilent && !m_newest.problem)
        m_newest.problem = shownProblem(silent(m_address).value());
    else if (isAnswered && !isSilent && m_newest.problem)
        m_newest.problem.reset();
    else
        return;
    Q_EMIT read(m_newest);
}

} // namespace odo
