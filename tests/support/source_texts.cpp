// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/source_texts.h"

#include <QRegularExpression>
#include <QSet>

namespace odo::test {

namespace {

struct Token
{
    QString text;
    int line;

    bool isComment() const { return text.startsWith(u"//") || text.startsWith(u"/*"); }
    bool isLiteral() const { return text.startsWith(u'"'); } ///< but a raw one, which isn't for users
    bool isName() const { return text[0].isLetter() || text[0] == u'_'; }
    /// Of a literal: what the user sees.
    QString words() const
    {
        QString inside = text.mid(1, text.size() - 2);
        return inside.replace(QLatin1String("\\n"), QLatin1String(" "))
            .replace(QLatin1String("\\\""), QLatin1String("\""));
    }
};

/// Without comments. A raw literal is one token.
QList<Token> tokensOf(const QString &source)
{
    static const QRegularExpression token(
        QStringLiteral(R"re(//[^\n]*|/\*.*?\*/|R"([^()\\ ]{0,16})\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|)re"
                       R"re('(?:\\.|[^'\\\n])+'|\d[\w'.]*|[A-Za-z_]\w*|[^\s\w])re"),
        QRegularExpression::DotMatchesEverythingOption);
    QList<Token> tokens;
    int line = 1;
    qsizetype counted = 0;
    for (auto each = token.globalMatch(source); each.hasNext();) {
        const auto match = each.next();
        line += int(QStringView(source).mid(counted, match.capturedStart() - counted).count(u'\n'));
        counted = match.capturedStart();
        if (const Token found{match.captured(), line}; !found.isComment())
            tokens << found;
    }
    return tokens;
}

/// A bracket that is open: what stands before it, and how many commas came so far.
struct Bracket
{
    QString before;
    int argument = 0;
};

bool isTranslated(const Bracket &call)
{
    static const QSet<QString> second{QStringLiteral("ODO_TEXT"), QStringLiteral("QT_TRANSLATE_NOOP"),
                                      QStringLiteral("translate")};
    return call.before == QLatin1String("tr") ? call.argument == 0
                                              : call.argument == 1 && second.contains(call.before);
}

} // namespace

void Passage::add(int line, const QString &words)
{
    m_parts.append({m_words.size(), line});
    m_words += words;
}

int Passage::lineAt(qsizetype offset) const
{
    int line = 0;
    for (const Part &part : m_parts)
        if (part.offset <= offset)
            line = part.line;
    return line;
}

QList<Passage> textsOfSource(const QString &source, bool hasPlainTexts)
{
    static const QRegularExpression twoWords(QStringLiteral("[a-z]+ [a-z]+"));
    const QList<Token> tokens = tokensOf(source);
    QList<Passage> texts;
    QList<Bracket> open;
    for (qsizetype i = 0; i < tokens.size(); ++i) {
        const QChar first = tokens[i].text[0];
        if (QStringLiteral("([{").contains(first)) {
            open << Bracket{first == u'(' && i > 0 ? tokens[i - 1].text : QString()};
        } else if (QStringLiteral(")]}").contains(first)) {
            if (!open.isEmpty())
                open.removeLast();
        } else if (first == u',') {
            if (!open.isEmpty())
                ++open.last().argument;
        } else if (tokens[i].isLiteral()) {
            Passage text;
            for (; i < tokens.size() && tokens[i].isLiteral(); ++i)
                text.add(tokens[i].line, tokens[i].words());
            --i;
            if ((!open.isEmpty() && isTranslated(open.last())) ||
                (hasPlainTexts && twoWords.match(text.words()).hasMatch()))
                texts << text;
        }
    }
    return texts;
}

QList<Passage> textsOfDocument(const QString &document)
{
    static const QRegularExpression markup(QStringLiteral("`[^`]*`|\\]\\([^)]*\\)|<[^>]*>"));
    static const QRegularExpression beginsAlone(QStringLiteral("^\\s*([|#*-]|\\d+\\.)"));
    QList<Passage> texts;
    Passage text;
    const auto end = [&] {
        if (!text.isEmpty())
            texts << text;
        text = {};
    };
    bool isCode = false;
    const QStringList lines = document.split(u'\n');
    for (int i = 0; i < lines.size(); ++i) {
        QString line = lines[i];
        if (line.trimmed().startsWith(QLatin1String("```"))) {
            isCode = !isCode;
            continue;
        }
        if (isCode)
            continue;
        line.replace(markup, QStringLiteral("\u2026")).replace(QLatin1String("&amp;"), QLatin1String("&"));
        if (line.trimmed().isEmpty() || beginsAlone.match(line).hasMatch())
            end();
        if (!line.trimmed().isEmpty())
            text.add(i + 1, line + u' ');
    }
    end();
    return texts;
}

QList<Passage> namesOfSource(const QString &source)
{
    QList<Passage> names;
    QSet<QString> seen;
    for (const Token &token : tokensOf(source))
        if (token.isName() && !seen.contains(token.text) && !token.text.contains(u'"')) {
            seen << token.text;
            names.append(Passage());
            names.last().add(token.line, token.text);
        }
    return names;
}

QString wordsOfName(const QString &name)
{
    static const QRegularExpression part(QStringLiteral("[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\\d+"));
    QStringList parts;
    for (auto each = part.globalMatch(name); each.hasNext();)
        parts << each.next().captured().toLower();
    return parts.join(u' ');
}

} // namespace odo::test
