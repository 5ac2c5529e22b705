// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/figures.h"

#include <QJsonObject>
#include <algorithm>

namespace odo::test {

namespace {

QString demandOf(const Figure &figure)
{
    if (figure.atLeast)
        return QStringLiteral("at least %1").arg(*figure.atLeast);
    return figure.atMost ? QStringLiteral("at most %1").arg(*figure.atMost) : QString();
}

QString verdictOf(const Figure &figure)
{
    if (!figure.atLeast && !figure.atMost)
        return {};
    return figure.isMet() ? QStringLiteral("met") : QStringLiteral("MISSED");
}

} // namespace

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

QString figuresTable(const std::vector<Figure> &figures)
{
    QString text = QStringLiteral("%1 %2  %3 %4 %5\n")
                       .arg(QStringLiteral("figure"), -54)
                       .arg(QStringLiteral("value"), 10)
                       .arg(QStringLiteral("demanded"), -16)
                       .arg(QString(), -7)
                       .arg(QStringLiteral("made of"));
    for (const Figure &figure : figures)
        text += QStringLiteral("%1 %2  %3 %4 %5\n")
                    .arg(figure.name, -54)
                    .arg(QString::number(figure.value, 'f', figure.value < 10 ? 3 : 1) + figure.unit, 10)
                    .arg(demandOf(figure), -16)
                    .arg(verdictOf(figure), -7)
                    .arg(figure.detail);
    return text;
}

QJsonArray figuresJson(const std::vector<Figure> &figures)
{
    QJsonArray list;
    for (const Figure &figure : figures) {
        QJsonObject object{{QStringLiteral("figure"), figure.name},
                           {QStringLiteral("value"), figure.value},
                           {QStringLiteral("unit"), figure.unit.trimmed()},
                           {QStringLiteral("detail"), figure.detail}};
        if (figure.atLeast)
            object.insert(QStringLiteral("at_least"), *figure.atLeast);
        if (figure.atMost)
            object.insert(QStringLiteral("at_most"), *figure.atMost);
        if (figure.atLeast || figure.atMost)
            object.insert(QStringLiteral("met"), figure.isMet());
        list.append(object);
    }
    return list;
}

} // namespace odo::test
