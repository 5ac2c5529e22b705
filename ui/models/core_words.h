// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <span>
#include <string>

namespace odo {

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

} // namespace odo
