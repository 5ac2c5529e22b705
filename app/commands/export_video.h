// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_call.h"

namespace odo {

/// The options of `export --format video`, for its syntax.
QList<QCommandLineOption> videoOptions();
/// Makes the annotated video of a trial and answers. Needs a QGuiApplication.
Result<void> exportVideo(const CommandCall &call, const std::string &file);

} // namespace odo
