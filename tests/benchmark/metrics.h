// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/benchmark/benchmark_clips.h"

#include <QJsonArray>
#include <QString>

namespace odo::test {

/// One line of the table: what was measured, and what is demanded of it, if anything is.
struct Measurement
{
    QString name;
    double value = 0;
    std::optional<double> atLeast, atMost;
    QString unit, detail;

    bool isMet() const { return (!atLeast || value >= *atLeast) && (!atMost || value <= *atMost); }
};

double median(std::vector<double> values);

QString metricsTable(const std::vector<Measurement> &metrics);
QJsonArray metricsJson(const std::vector<Measurement> &metrics);

} // namespace odo::test
