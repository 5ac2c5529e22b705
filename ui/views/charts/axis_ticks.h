// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <vector>

namespace odo {

/// Where an axis puts its marks: round numbers (1, 2 or 5 times a power of ten) that cover a range.
struct AxisTicks
{
    double first = 0, step = 1; ///< step > 0
    int count = 0;              ///< marks; the last is first + (count − 1) · step
    int decimals = 0;           ///< that the labels need

    std::vector<double> values() const;
    double last() const { return first + (count - 1) * step; }
    QString label(double value, const QLocale &locale = QLocale()) const;
};

/// Marks inside [low, high], at most about `most` of them.
AxisTicks niceTicks(double low, double high, int most);
/// Marks that reach to or beyond both ends of [low, high].
AxisTicks coveringTicks(double low, double high, int most);

} // namespace odo
