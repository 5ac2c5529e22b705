// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace odo {

/// A command line up to the cursor, as bash has it.
struct ShellLine
{
    enum class Quote { None, Single, Double };

    QStringList words; ///< without their quotes; the last one ends at the cursor and may be empty
    qsizetype keptLength =
        0; ///< how much of the last word stays, without quotes: bash replaces the rest of it
    Quote quote = Quote::None; ///< that is open at the cursor
};

/// Takes the quotes of bash away and divides the line into words. breaks: COMP_WORDBREAKS, at which bash
/// begins another word to complete. A word that begins with ~/ or $HOME/ is in the home folder. Any thread.
ShellLine readShellLine(const QString &line, const QString &breaks);

/// A text so that bash reads it as it is, behind a quote that is open or none.
QString quotedForShell(const QString &text, ShellLine::Quote quote);

/// The word with the home folder in place of "~". Any thread.
QString withHome(const QString &word);

} // namespace odo
