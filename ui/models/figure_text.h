// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/trajectory/profile.h"
#include "ui/models/shown_units.h"

#include <QLocale>
#include <QString>
#include <optional>

namespace odo {

/// A number as a person reads it: rounded to the first significant digit of its σ (two where that digit is a
/// 1), in the words of a locale. Without a σ: three significant digits. Not finite: a dash.
struct FigureText
{
    QString value; ///< "1.83"
    QString sigma; ///< "0.02"; empty where it is not known
    QString unit;  ///< "m/s"; empty for a bare number

    /// "1.83 ±0.02 m/s"
    QString text() const;
    /// "m/s ±0.02": what stands small beside a large value
    QString smallPrint() const;
};

FigureText figureText(double value, std::optional<double> sigma, const QString &unit,
                      const QLocale &locale = QLocale());

/// What a metric is shown in, and by how much its stored value is multiplied for it; a bare number has no name.
ShownUnit metricUnit(const Metric &metric);
/// The figure of a metric, in the units that are shown (shown_units.h).
FigureText metricFigure(const Metric &metric, const QLocale &locale = QLocale());
/// "max_speed" → "Top speed"; a name that is not known is made readable.
QString metricName(const std::string &name);

/// "00:03.267", from an hour on "1:00:03.267". Negative times carry a minus.
QString timeCode(Nanoseconds time);
/// "3.27 s"
QString secondsText(Nanoseconds time, const QLocale &locale = QLocale());
/// An error or a height: "1.6 mm"; from 100 mm on without decimals. In the unit that is shown.
QString lengthText(double metres, const QLocale &locale = QLocale());
/// A place or a way, to about a centimetre: "1.23 m"; in the unit that is shown.
QString distanceText(double metres, const QLocale &locale = QLocale());
/// "1.83 ±0.02 m/s"; in the unit that is shown.
QString speedText(double metresPerSecond, std::optional<double> sigma, const QLocale &locale = QLocale());

} // namespace odo
