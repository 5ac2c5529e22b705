// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/school/hub_results.h"
#include "ui/scoreboard/internal/board_content.h"

#include <memory>
#include <optional>
#include <string>

namespace odo {

/// Reads what the page shows from a school's hub, again and again, and connects again where the connection
/// was lost. The map only where the login may read tracks. Each call may take as long as the server does. On
/// one thread.
class HubReader
{
public:
    HubReader(HubAddress address, StandingsChoice choice);
    ~HubReader();

    /// nullopt: nothing has changed since it was read last. After an error the next call reads again.
    Result<std::optional<BoardContent>> readIfChanged();

private:
    Result<std::optional<BoardContent>> ask();
    Result<void> addBestRun(const HubStandings &standings, BoardContent &content);

    const HubAddress m_address;
    const StandingsChoice m_choice;
    std::unique_ptr<HubResults> m_hub; ///< null: to be connected
    std::optional<std::int64_t> m_state;
    BestRunMap m_map;
};

/// What to do where a hub cannot be reached.
Message checkHubAddress();

} // namespace odo
