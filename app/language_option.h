// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QCommandLineOption>

namespace odo {

class CommandCall;

/// --language, for commands that write what people read: reports, pictures, videos. What a command answers stays English.
QCommandLineOption languageOption();
/// Installs it (language.h). WrongCall where it is not known.
Result<void> applyLanguage(const CommandCall &call);

} // namespace odo
