// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/metrics.h"

#include <QJsonObject>
#include <algorithm>

namespace odo::test {

namespace {

QString demandOf(const Measurement &metric)
{
    if (metric.atLeast)
        return QStringLiteral("at least %1").arg(*metric.atLeast);
    return metric.atMost ? QStringLiteral("at most %1").arg(*metric.atMost) : QString();
}

QString verdictOf(const Measurement &metric)
{
    if (!metric.atLeast && !metric.atMost)
        return {};
    return metric.isMet() ? QStringLiteral("met") : QStringLiteral("MISSED");
}

} // namespace

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

QString metricsTable(const std::vector<Measurement> &metrics)
{
    QString text = QStringLiteral("%1 %2  %3 %4 %5\n")
                       .arg(QStringLiteral("figure"), -54)
                       .arg(QStringLiteral("value"), 10)
                       .arg(QStringLiteral("demanded"), -16)
                       .arg(QString(), -7)
                       .arg(QStringLiteral("made of"));
    for (const Measurement &metric : metrics)
        text += QStringLiteral("%1 %2  %3 %4 %5\n")
                    .arg(metric.name, -54)
                    .arg(QString::number(metric.value, 'f', metric.value < 10 ? 3 : 1) + metric.unit, 10)
                    .arg(demandOf(metric), -16)
                    .arg(verdictOf(metric), -7)
                    .arg(metric.detail);
    return text;
}

QJsonArray metricsJson(const std::vector<Measurement> &metrics)
{
    QJsonArray list;
    for (const Measurement &metric : metrics) {
        QJsonObject object{{QStringLiteral("figure"), metric.name},
                           {QStringLiteral("value"), metric.value},
                           {QStringLiteral("unit"), metric.unit.trimmed()},
                           {QStringLiteral("detail"), metric.detail}};
        if (metric.atLeast)
            object.insert(QStringLiteral("at_least"), *metric.atLeast);
        if (metric.atMost)
            object.insert(QStringLiteral("at_most"), *metric.atMost);
        if (metric.atLeast || metric.atMost)
            object.insert(QStringLiteral("met"), metric.isMet());
        list.append(object);
    }
    return list;
}

} // namespace odo::test
