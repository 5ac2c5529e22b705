// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_call.h"

namespace odo {

/// `export --format html`: one page of all the trials of a call, and answers.
Result<void> exportPage(const CommandCall &call, const QString &file);

} // namespace odo
