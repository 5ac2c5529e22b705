// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/number_text.h"
#include "ui/school/hub_exchange.h"

#include <QString>

namespace odo {

/// What came of an exchange, as sentences.
QString outcomeWords(HubState::Work work, const SchoolReport &report);
/// "bench1 at hub.school.example/robots".
QString hubName(const SchoolLink &link);
/// What a login of this role may do.
QString roleWords(const std::string &role);
/// What is to be sent, in words.
QString pendingWords(const HubState &state);
/// How the tie is just now; empty while all is well.
Badge hubBadge(const HubState &state);

} // namespace odo
