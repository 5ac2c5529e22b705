// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

namespace odo {

/// A sentence, or a part of one, as it stands in a source; for each thing that is computed there is a Q.
struct CoreSentence
{
    QString place; ///< "core/base/units.cpp:12"
    QString words; ///< "'Q' is not a finite number"
};

/// Names of the functions that make an Error of the words they are given: fail, those that the source
/// declares to return one, and its lambdas that return what those make.
QStringList errorMakers(const QString &source);

/// The sentences of a source of C++: what makers of errors are given, what follows an ErrorCode, what a job
/// reports to be doing, and what is /// put into something whose name is one of words: it ends with why,
/// advice, warning or the like. Of `a ? "b" : "c"` come both. What has no word of three letters is left out.
/// No compiler: literals, sums, choices and brackets are understood, anything else is a Q, as is a figure in
/// what snprintf writes.
QList<CoreSentence> sentencesIn(const QString &source, const QString &place, const QStringList &makers);

/// The sentences of all sources below a folder of the tree. Makers that a header declares are known in all of
/// them.
QList<CoreSentence> coreSentences(const QString &tree, const QString &folder);

} // namespace odo
