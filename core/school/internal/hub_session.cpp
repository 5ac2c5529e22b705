// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/internal/hub_session.h"

#include <thread>

namespace odo {

HubSession::HubSession(HubAddress address, const JobControl &control)
    : m_subject(address.subject()), m_address(std::move(address)), m_control(control), m_hub(m_address)
{
}

Result<void> HubSession::open()
{
    struct Opened
    {
        std::string role;
        int version = 0;
    };
    m_isOpen = false;
    const auto connectAnew = [address = m_address](std::unique_ptr<SchoolHub> &hub) -> Result<Opened> {
        hub.reset();
        auto ready = ODO_TRY(connectReady(address));
        hub = std::move(ready.hub);
        return Opened{std::move(ready.role), ready.version};
    };
    auto opened = ODO_TRY(ask<Result<Opened>>(connectAnew));
    m_isOpen = true;
    m_role = std::move(opened.role);
    m_version = opened.version;
    return {};
}

void HubSession::report(double done, const Message &words)
{
    m_done = done;
    m_control.report(done, words);
}

std::chrono::seconds HubSession::longestAbsence()
{
    return std::chrono::seconds(30);
}

Message HubSession::serverIsAway()
{
    return ODO_TEXT("school.server_away", "the server is away; trying again");
}

Message HubSession::waitingForServer()
{
    return ODO_TEXT("school.waiting", "waiting for the server");
}

bool HubSession::rest() const
{
    for (int i = 0; i < 10 && !m_control.isCancelled(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return !m_control.isCancelled();
}

} // namespace odo
