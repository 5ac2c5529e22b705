// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

namespace odo::test {

/// Words that belong together, of neighbouring lines: "in\nstep" is one phrase. Plain value.
class Passage
{
public:
    void add(int line, const QString &words);
    bool isEmpty() const { return m_words.isEmpty(); }
    const QString &words() const { return m_words; }
    /// The line of the source where the character at this offset is.
    int lineAt(qsizetype offset) const;

private:
    struct Part
    {
        qsizetype offset;
        int line;
    };
    QString m_words;
    QList<Part> m_parts;
};

/// What a user reads of a C++ source: the English of tr, translate, ODO_TEXT and QT_TRANSLATE_NOOP; with
/// hasPlainTexts also other literals of two words or more.
QList<Passage> textsOfSource(const QString &source, bool hasPlainTexts);
/// What a user reads of Markdown, HTML or similar: without code, addresses and markup.
QList<Passage> textsOfDocument(const QString &document);
/// Identifiers of a C++ source, each where it is first.
QList<Passage> namesOfSource(const QString &source);
/// "heldOutPx" -> "held out px", "HTMLPage" -> "html page".
QString wordsOfName(const QString &name);

} // namespace odo::test
