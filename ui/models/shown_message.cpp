// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/shown_message.h"

#include "core/base/plain_text.h"
#include "ui/models/shown_names.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace odo {

namespace {

class ShownMessageWords
{
    Q_DECLARE_TR_FUNCTIONS(ShownMessageWords)
};

QString shownNumber(const MessageArgument &number)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const QString figure = locale.toString(number.number, 'f', number.decimals);
    if (number.text.empty())
        return figure;
    const QString unit = QString::fromStdString(number.text);
    return unit == QStringLiteral("°") ? figure + unit : figure + QLatin1Char(' ') + unit;
}

QString shownList(const MessageArgument &list)
{
    if (list.parts.empty())
        return ShownMessageWords::tr("none");
    QString words = shownWords(list.parts.front());
    for (std::size_t i = 1; i < list.parts.size(); ++i) {
        const bool isLast = i + 1 == list.parts.size();
        const QString pattern =
            !isLast || list.joint == MessageArgument::Joint::Comma ? ShownMessageWords::tr("%1, %2")
            : list.joint == MessageArgument::Joint::Or             ? ShownMessageWords::tr("%1 or %2")
                                                                   : ShownMessageWords::tr("%1 and %2");
        words = pattern.arg(words, shownWords(list.parts[i]));
    }
    return words;
}

QString shownArgument(const MessageArgument &argument)
{
    switch (argument.kind) {
    case MessageArgument::Kind::Number:
        return shownNumber(argument);
    case MessageArgument::Kind::List:
        return shownList(argument);
    case MessageArgument::Kind::Message:
        return shownWords(argument.parts.front());
    case MessageArgument::Kind::Team:
        return shownTeam(argument.text);
    case MessageArgument::Kind::Person:
        return arePseudonymsShown() ? QStringLiteral("…") : QString::fromStdString(argument.text);
    default:
        return QString::fromStdString(plainLine(argument.text));
    }
}

QString sentence(QString text)
{
    if (text.isEmpty())
        return text;
    text[0] = text.at(0).toUpper();
    return fullSentence(text);
}

} // namespace

QString breakable(const QString &text)
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

QString shownWords(const Message &message)
{
    if (message.isEmpty())
        return {};
    const QString words = QCoreApplication::translate(message.text->code, message.text->english);
    QString filled;
    for (qsizetype i = 0; i < words.size(); ++i) {
        const int which = words.at(i) == u'%' && i + 1 < words.size() ? words.at(i + 1).digitValue() : 0;
        if (which < 1) {
            filled += words.at(i);
            continue;
        }
        if (std::size_t(which) <= message.arguments.size())
            filled += shownArgument(message.arguments[std::size_t(which - 1)]);
        ++i;
    }
    return filled;
}

QString joinedWords(const QString &what, const QString &why)
{
    return ShownMessageWords::tr("%1: %2").arg(what, why);
}

QString fullSentence(const QString &words)
{
    static const QString signs = QStringLiteral(".?!。？！");
    return words.isEmpty() || signs.contains(words.back()) ? words : ShownMessageWords::tr("%1.").arg(words);
}

QString errorInWords(const Error &error)
{
    const QString what = shownWords(error.what), why = shownWords(error.why);
    QStringList sentences{sentence(why.isEmpty() ? what : joinedWords(what, why))};
    if (!error.advice.isEmpty())
        sentences << sentence(shownWords(error.advice));
    return sentences.join(QLatin1Char(' '));
}

QString errorLine(const Error &error)
{
    const QString line = joinedWords(shownWords(error.what), shownWords(error.why));
    return error.advice.isEmpty() ? line
                                  : ShownMessageWords::tr("%1; %2").arg(line, shownWords(error.advice));
}

} // namespace odo
