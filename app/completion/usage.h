// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_call.h"

#include <QHash>
#include <QString>
#include <QStringList>
#include <vector>

namespace odo {

/// One way to call a command, as its help says it.
struct UsageForm
{
    QStringList positionals;            ///< "add", "P.odo", "TRIAL"
    bool isLastRepeated = false;        ///< "TRIAL..."
    QHash<QString, QString> valueForms; ///< what stands behind an option there: "csv|tum|json"; by its name
};

/// Reads the forms of a call out of the words of its help (CommandSyntax::arguments), where " | " divides
/// them outside brackets. Any thread.
std::vector<UsageForm> usageForms(const CommandSyntax &syntax);

/// The option of that name, without dashes; null where the command has none.
const QCommandLineOption *optionNamed(const CommandSyntax &syntax, const QString &name);

} // namespace odo
