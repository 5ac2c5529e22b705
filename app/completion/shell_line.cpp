// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/completion/shell_line.h"

#include "core/base/platform/user_folders.h"

namespace odo {

namespace {

/// Reads a line character by character.
class ShellLineReader
{
public:
    explicit ShellLineReader(const QString &breaks) : m_breaks(breaks) { m_line.words << QString(); }

    void take(QChar c)
    {
        if (m_isEscaped)
            takeEscaped(c);
        else if (m_line.quote == Quote::Single)
            takeQuoted(c, u'\'');
        else if (m_line.quote == Quote::Double)
            takeInDouble(c);
        else
            takeBare(c);
    }
    ShellLine line() const { return m_line; }

private:
    using Quote = ShellLine::Quote;

    QString &word() { return m_line.words.last(); }
    void add(QChar c)
    {
        word() += c;
        m_isInWord = true;
    }
    void takeEscaped(QChar c)
    {
        m_isEscaped = false;
        if (m_line.quote == Quote::Double && !QStringLiteral("\\\"$`").contains(c))
            add(u'\\');
        add(c);
    }
    void takeQuoted(QChar c, QChar end)
    {
        if (c != end)
            return add(c);
        m_line.quote = Quote::None;
        m_line.keptLength = word().size();
    }
    void takeInDouble(QChar c)
    {
        if (c == u'\\')
            m_isEscaped = true;
        else
            takeQuoted(c, u'"');
    }
    void takeBare(QChar c)
    {
        if (c == u'\\') {
            m_isEscaped = true;
        } else if (c == u'\'' || c == u'"') {
            m_line.quote = c == u'"' ? Quote::Double : Quote::Single;
            m_line.keptLength = word().size();
            m_isInWord = true;
        } else if (c.isSpace()) {
            if (m_isInWord)
                m_line.words << QString();
            m_isInWord = false;
            m_line.keptLength = 0;
        } else {
            add(c);
            if (m_breaks.contains(c))
                m_line.keptLength = word().size();
        }
    }

    const QString m_breaks;
    ShellLine m_line;
    bool m_isEscaped = false, m_isInWord = false;
};

QString escaped(const QString &text)
{
    static const QString plain = QStringLiteral("_./-+,%@^:=");
    QString result;
    for (const QChar c : text) {
        if (c.unicode() < 0x80 && !c.isLetterOrNumber() && !plain.contains(c))
            result += u'\\';
        result += c;
    }
    return result;
}

} // namespace

ShellLine readShellLine(const QString &line, const QString &breaks)
{
    ShellLineReader reader(breaks);
    for (const QChar c : line)
        reader.take(c);
    return reader.line();
}

QString quotedForShell(const QString &text, ShellLine::Quote quote)
{
    QString result = text;
    switch (quote) {
    case ShellLine::Quote::Single:
        return result.replace(u'\'', QStringLiteral("'\\''"));
    case ShellLine::Quote::Double:
        result.replace(u'\\', QStringLiteral("\\\\"));
        for (const QChar c : {u'"', u'$', u'`'})
            result.replace(c, QStringLiteral("\\") + c);
        return result.replace(u'!', QStringLiteral("\"'!'\"")); // of the history, also within double quotes
    case ShellLine::Quote::None:
        break;
    }
    return escaped(text);
}

QString withHome(const QString &word)
{
    for (const QString &home : {QStringLiteral("~/"), QStringLiteral("$HOME/"), QStringLiteral("${HOME}/")})
        if (word.startsWith(home))
            return QString::fromStdString(homeFolder().string()) + word.mid(home.size() - 1);
    return word;
}

} // namespace odo
