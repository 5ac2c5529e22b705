// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

class QCoreApplication;

namespace odo {

/// A language that all windows and reports can be shown in.
struct Language
{
    QString code; ///< "de", "zh_CN"
    QString name; ///< in itself: "Deutsch"
};
/// English first, then by their names.
const QList<Language> &languages();

/// What a person chose on this computer, remembered; empty: as the computer has it.
QString chosenLanguage();
void chooseLanguage(const QString &code);

/// Shows words in a language from now on (what is on the screen stays as it is), and numbers and dates as its
/// country has them: as this computer has them where it speaks the same language. Empty: the computer's first
/// language that is known here, or else English. Once, before the first window; English has its plural forms
/// from it too. GUI thread.
void installLanguage(QCoreApplication &application, const QString &code);
/// The code of the language that words are shown in; "en" before any was installed.
QString shownLanguage();

/// A help page by its name ("review") in the language shown.
QString helpPage(const QString &name);

} // namespace odo
