// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/base/shortage.h"
#include "core/school/internal/school_hub.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

namespace odo {

/// A connection to a hub on a thread of its own, so that who asks can stop waiting: libpq itself waits for a
/// server that keeps the connection and never answers. A thread that is stuck like that is left behind, and
/// the next call starts another one. On one thread.
class HubThread
{
public:
    /// Each may set, use or reset the connection. It owns all that it uses: it may go on when nobody waits.
    using Work = std::function<void(std::unique_ptr<SchoolHub> &hub)>;

    explicit HubThread(HubAddress address);
    ~HubThread();
    HubThread(const HubThread &) = delete;
    HubThread &operator=(const HubThread &) = delete;

    /// What work gives, a Result. Errors: Cancelled; Unavailable where there is no answer within two minutes.
    /// whenSlow: called every three seconds meanwhile.
    template <class Outcome>
    Outcome call(std::function<Outcome(std::unique_ptr<SchoolHub> &)> work, const JobControl &control,
                 const std::function<void()> &whenSlow)
    {
        const auto outcome = std::make_shared<std::optional<Outcome>>();
        ODO_TRY(await(
            [work = std::move(work), outcome, what = m_address.subject()](std::unique_ptr<SchoolHub> &hub) {
                *outcome = orShortage(what, [&] { return work(hub); });
            },
            control, whenSlow));
        return std::move(**outcome);
    }

    /// Why there is no connection on a thread that was started anew.
    Error lostConnection() const;

private:
    struct Desk;
    Result<void> await(Work work, const JobControl &control, const std::function<void()> &whenSlow);
    Result<void> start();
    void leave();

    const HubAddress m_address;
    std::shared_ptr<Desk> m_desk; ///< null: no thread
    std::thread m_thread;
};

} // namespace odo
