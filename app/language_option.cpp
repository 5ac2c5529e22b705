// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/language_option.h"

#include "app/command_call.h"
#include "app/option_names.h"
#include "ui/main_window/language.h"

#include <QCoreApplication>
#include <algorithm>

namespace odo {

namespace {

QStringList codes()
{
    QStringList codes;
    for (const Language &each : languages())
        codes << each.code;
    return codes;
}

} // namespace

QCommandLineOption languageOption()
{
    return {option::language, QStringLiteral("Of the words and numbers: %1.").arg(codes().join(QStringLiteral(", "))),
            QStringLiteral("CODE"), QStringLiteral("en")};
}

Result<void> applyLanguage(const CommandCall &call)
{
    const QString code = QString::fromStdString(call.value(option::language));
    if (!codes().contains(code))
        return call.wrongCall(QStringLiteral("--language is one of %1").arg(codes().join(QStringLiteral(", "))));
    installLanguage(*qApp, code);
    return {};
}

} // namespace odo
