// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/error_words.h"

#include <QStringList>

namespace odo {
namespace {

QString sentence(const std::string &part)
{
    QString text = QString::fromStdString(part).simplified();
    if (text.isEmpty())
        return text;
    text[0] = text.at(0).toUpper();
    if (!text.endsWith(QLatin1Char('.')) && !text.endsWith(QLatin1Char('?')) &&
        !text.endsWith(QLatin1Char('!')))
        text += QLatin1Char('.');
    return text;
}

} // namespace

QString errorInWords(const Error &error)
{
    QStringList sentences{sentence(error.what + (error.why.empty() ? std::string() : ": " + error.why))};
    if (!error.advice.empty())
        sentences << sentence(error.advice);
    return sentences.join(QLatin1Char(' '));
}

} // namespace odo
