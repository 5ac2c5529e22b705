// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/error_words.h"

#include "ui/models/core_words.h"

#include <QStringList>

namespace odo {
namespace {

QString shown(const std::string &part)
{
    return shownWords(QString::fromStdString(part).simplified());
}

QString sentence(QString text)
{
    if (text.isEmpty())
        return text;
    text[0] = text.at(0).toUpper();
    return fullSentence(text);
}

} // namespace

QString errorInWords(const Error &error)
{
    QStringList sentences{
        sentence(error.why.empty() ? shown(error.what) : joinedWords(shown(error.what), shown(error.why)))};
    if (!error.advice.empty())
        sentences << sentence(shown(error.advice));
    return sentences.join(QLatin1Char(' '));
}

QString errorLine(const Error &error)
{
    return shownWords(error.message());
}

} // namespace odo
