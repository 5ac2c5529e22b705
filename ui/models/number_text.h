// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/base/units.h"
#include "core/project/records.h"

#include <QLocale>
#include <QString>
#include <optional>

namespace odo {

enum class BadgeState { Neutral, Good, Warning, Bad };

/// A short verdict on a coloured ground; the words alone must say it.
struct Badge
{
    QString text;
    BadgeState state = BadgeState::Neutral;
};

/// How well a camera is registered: "±1.6 mm", the larger of the markers' misfit and the floor's σ. Good up
/// to 5 mm, bad from 20 mm on.
Badge registrationBadge(const std::optional<FloorRegistration> &registration);

/// How far a camera can be relied on now: as registrationBadge, unless the last check says that it has moved
/// ("moved 14 mm"), that markers have, or that they were not found.
Badge cameraBadge(const std::optional<RegistrationRecord> &registration);

/// What a person wants results to be shown in. Targets and markers are set up in millimetres in each of them,
/// as they are printed; files and the command line do not know of it.
enum class UnitSystem { Millimetres, Centimetres, Inches };

/// "mm", "cm", "in": the word kept in the settings; another one is Millimetres.
UnitSystem unitSystemFromWord(const QString &word);
QString unitSystemWord(UnitSystem system);

/// A unit of a quantity.
struct ShownUnit
{
    QString name;     ///< "m/s"
    double perSi = 1; ///< so many make one of the SI's
};

/// The units of one system.
struct ShownUnits
{
    ShownUnit length;   ///< of errors and heights
    ShownUnit distance; ///< of distances travelled
    ShownUnit speed, acceleration;
};
const ShownUnits &unitsOf(UnitSystem system);

/// The formats of the whole program, those of QLocale(). Any thread. Text already on the screen changes only
/// when it is rebuilt.
UnitSystem shownUnitSystem();
void setShownUnitSystem(UnitSystem system);
const ShownUnits &shownUnits();

/// A number as a person reads it: rounded to the first significant digit of its σ (two where that digit is a
/// 1), in the words of a locale. Without a σ: three significant digits. Not finite: a dash.
struct NumberText
{
    QString value; ///< "1.83"
    QString sigma; ///< "0.02"; empty where it is not known
    QString unit;  ///< "m/s"; empty for a bare number

    /// "1.83 ±0.02 m/s"
    QString text() const;
    /// "m/s ±0.02": shown small beside a large value
    QString smallPrint() const;
};

NumberText numberText(double value, std::optional<double> sigma, const QString &unit,
                      const QLocale &locale = QLocale());

/// What a metric is shown in, and by how much its stored value is multiplied for it; a bare number has no
/// name.
ShownUnit metricUnit(const Metric &metric);
/// A metric as text, in the units that are shown (shown_units.h).
NumberText metricNumber(const Metric &metric, const QLocale &locale = QLocale());
/// "max_speed" → "Top speed"; a name that is not known is made readable.
QString metricName(const std::string &name);

/// "3/9/26 9:15 AM", as the person's country writes it.
QString shortDate(Instant instant);
/// For a spreadsheet: in all digits, without signs between thousands; nothing where it is not known.
QString plainNumber(const std::optional<double> &value);
/// "00:03.267", from an hour on "1:00:03.267". Negative times carry a minus.
QString timeCode(Nanoseconds time);
/// "3.27 s"
QString secondsText(Nanoseconds time, const QLocale &locale = QLocale());
/// An error or a height: "1.6 mm"; from 100 mm on without decimals. In the unit that is shown.
QString lengthText(double metres, const QLocale &locale = QLocale());
/// A coordinate on the floor: "1204 mm", "1204 ±1.2 mm" with its σ; in the unit that is shown.
QString coordinateText(double metres, std::optional<double> sigmaM = std::nullopt,
                       const QLocale &locale = QLocale());
/// A position or distance, to about a centimetre: "1.23 m"; in the unit that is shown.
QString distanceText(double metres, const QLocale &locale = QLocale());
/// "1.83 ±0.02 m/s"; in the unit that is shown.
QString speedText(double metresPerSecond, std::optional<double> sigma, const QLocale &locale = QLocale());

/// Numbers as people type them: with the decimal sign of their language, or with the other one of point and
/// comma where it can be nothing else. "1.234" where a point parts thousands is a thousand to one and a bit
/// to another: it is read as neither. GUI thread.

/// Whether a text has the sign that parts thousands once, where it could be meant as the decimal sign just as
/// well.
bool isAmbiguousNumber(const QString &text, const QLocale &locale);

/// The text with the locale's own decimal sign, where it has the other one.
QString withDecimalSign(QString text, const QLocale &locale);

/// nullopt: no number, or one that can be read in two ways.
std::optional<double> typedNumber(const QString &text, const QLocale &locale = QLocale());

/// As a text sorts by the numbers in it: "Trial 9" before "Trial 10". QCollator's own way needs a locale that
/// has one. Any thread.
QString withNumbersPadded(const QString &text);

/// The value of a variable as it is stored: a number that was typed with a decimal point, all else as it is.
QString storedValue(const QString &typed, const QLocale &locale = QLocale());

} // namespace odo
