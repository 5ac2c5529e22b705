// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/school/internal/hub_thread.h"

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace odo {

/// A connection that is made again while the server is away, for a while. Errors: those of SchoolHub;
/// Cancelled, soon, whatever the server does. On one thread.
class HubSession
{
public:
    /// control must outlive it.
    HubSession(HubAddress address, const JobControl &control);
    Result<void> open();

    /// Work that may be done twice: it is, where the connection was lost. It is done on another thread, and
    /// owns all that it uses.
    template <class Work>
    auto patiently(const Work &work) -> decltype(work(std::declval<SchoolHub &>()))
    {
        using Outcome = decltype(work(std::declval<SchoolHub &>()));
        const auto end = std::chrono::steady_clock::now() + longestAbsence();
        for (;;) {
            auto outcome = m_isOpen
                               ? ask<Outcome>([work](std::unique_ptr<SchoolHub> &hub) { return work(*hub); })
                               : Outcome(tl::unexpected(m_lost));
            if (outcome || outcome.error().code != ErrorCode::Unavailable)
                return outcome;
            m_lost = outcome.error();
            m_isOpen = false;
            if (std::chrono::steady_clock::now() > end)
                return outcome;
            report(m_done, serverIsAway());
            if (!rest())
                return cancelled(m_subject);
            if (auto opened = open(); !opened && opened.error().code != ErrorCode::Unavailable)
                return tl::unexpected(opened.error());
        }
    }

    /// To whoever asked for the work.
    void report(double done, const Message &words);

    const Message &subject() const { return m_subject; }
    const std::string &role() const { return m_role; }
    int version() const { return m_version; }

private:
    template <class Outcome>
    Outcome ask(std::function<Outcome(std::unique_ptr<SchoolHub> &)> work)
    {
        return m_hub.call<Outcome>(std::move(work), m_control,
                                   [this] { report(m_done, waitingForServer()); });
    }

    bool rest() const; ///< false: cancelled

    static std::chrono::seconds longestAbsence();
    static Message serverIsAway();
    static Message waitingForServer();

    const Message m_subject;
    const HubAddress m_address;
    const JobControl &m_control;
    HubThread m_hub;
    bool m_isOpen = false;
    std::string m_role;
    int m_version = 0;
    double m_done = 0; ///< that was reported last
    Error m_lost;
};

} // namespace odo
