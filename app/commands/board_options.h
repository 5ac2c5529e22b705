// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_call.h"
#include "core/calibration/board_detection.h"

#include <QCommandLineOption>
#include <QList>

namespace odo {

/// --board, --square and --pattern, of the commands that detect a board.
QList<QCommandLineOption> boardOptions();
/// The board that they describe. WrongCall where they describe none.
Result<BoardSpec> boardFrom(const CommandCall &call);

} // namespace odo
