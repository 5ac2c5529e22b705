// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>
#include <span>
#include <string>

namespace odo {

/// A text for a label that breaks lines: a word of more than forty letters may be broken after each forty, so
/// that a name of ten thousand does not ask for a window as wide as itself.
inline QString breakable(const QString &text)
{
    constexpr int longest = 40;
    const QChar breakHere(0x200b); // zero width space
    QString broken;
    int run = 0;
    for (const QChar c : text) {
        run = c.isSpace() ? 0 : run + 1;
        if (run > longest && !c.isLowSurrogate() && !c.isMark()) {
            broken += breakHere;
            run = 1;
        }
        broken += c;
    }
    return broken;
}

/// A sentence, or a part of one, as core makes it. %1, %2 … stand for what varies: a figure, a name.
struct CorePattern
{
    const char *english = nullptr; ///< of the context CoreWords, without a full stop
    const char *phrases = "";      ///< "13": what %1 and %3 hold are words of core too
    const char *lists = "";        ///< "2": %2 holds names as "O, U and V", or "none"
};

/// What core says, in the language of the windows. core makes English sentences and never translates; each is
/// found again by its pattern (ui/models/core_words/), also where it is one of several, joined by "; ", ": "
/// or a full stop, and its figures and names go over into the translation. Decimal numbers get the language's
/// sign. What no pattern knows, and everything in English, stays as it is. Any thread.
QString shownWords(const std::string &english);
QString shownWords(const QString &english);

/// All patterns, of all subjects.
std::span<const CorePattern> corePatterns();
/// The pattern that a sentence without its full stop is known by as a whole; nullptr: none.
const CorePattern *corePatternOf(const QString &english);

/// Two parts of a message as one: "what: why".
QString joinedWords(const QString &what, const QString &why);
/// A sentence with its full stop, as the language has it; unless it ends with a sign.
QString fullSentence(const QString &words);

/// An Error as a person reads it, in the language of the windows: what, why, and what to do, as sentences.
QString errorInWords(const Error &error);

/// The same on one line, as Error::message() has it: "what: why; what to do".
QString errorLine(const Error &error);

} // namespace odo
