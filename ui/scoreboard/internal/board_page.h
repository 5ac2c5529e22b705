// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scoreboard/internal/board_content.h"
#include "ui/scoreboard/internal/board_language.h"

#include <QByteArray>
#include <QJsonObject>

namespace odo {

/// The page of the standings, without what it shows: that comes by /events (boardState) and /map. It names
/// teams, classes and tasks, and no person, trial or robot. Any thread.
QByteArray boardPage(const BoardLanguage &language);

/// What the page shows; with how long a recording has been going on at a moment. As resources/scoreboard
/// reads it: task, facts[], unit, running{team, words, seconds}, teams[{rank, team, of, value, sigma, behind,
/// isNear, best, last, runs}], map, mapWords, notes[], empty.
QJsonObject boardState(const BoardContent &content, const BoardLanguage &language, Instant now);

/// The map of the best run as one element <svg>; empty where there is none.
QByteArray boardMap(const BoardContent &content, const BoardLanguage &language);

} // namespace odo
