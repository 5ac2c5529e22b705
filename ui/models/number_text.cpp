// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/number_text.h"

#include "core/analysis/metric_table.h"
#include "ui/models/shown_message.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>

namespace odo {

Badge registrationBadge(const std::optional<FloorRegistration> &registration)
{
    constexpr double goodBelowM = 0.005, badFromM = 0.020;
    if (!registration)
        return {QCoreApplication::translate("odo::Badge", "not registered"), BadgeState::Bad};
    // Markers may fit by chance, and closely under a lens that is hardly known: the worse of the two counts.
    const double worseM = std::max(registration->rmsM, registration->floorSigmaM);
    const QString text = QChar(0x00b1) + lengthText(worseM);
    if (worseM <= goodBelowM)
        return {text, BadgeState::Good};
    return {text, worseM < badFromM ? BadgeState::Warning : BadgeState::Bad};
}

Badge cameraBadge(const std::optional<RegistrationRecord> &registration)
{
    if (!registration)
        return registrationBadge(std::nullopt);
    if (registration->lastCheck) {
        const RegistrationCheck &check = *registration->lastCheck;
        switch (check.outcome) {
        case RegistrationCheck::Outcome::CameraMoved:
            return {QCoreApplication::translate("odo::Badge", "moved %1").arg(lengthText(check.shiftM)),
                    BadgeState::Bad};
        case RegistrationCheck::Outcome::MarkersMoved:
            return {
                QCoreApplication::translate("odo::Badge", "marker moved %1").arg(lengthText(check.shiftM)),
                BadgeState::Warning};
        case RegistrationCheck::Outcome::Undetermined:
            return {QCoreApplication::translate("odo::Badge", "markers not found"), BadgeState::Warning};
        case RegistrationCheck::Outcome::Still:
            break;
        }
    }
    return registrationBadge(registration->registration);
}

namespace {

constexpr double inch = 0.0254, foot = 12 * inch; // exactly so since 1959

std::atomic<UnitSystem> shown = UnitSystem::Millimetres;

const std::array<QString, 3> &words()
{
    static const std::array<QString, 3> all{QStringLiteral("mm"), QStringLiteral("cm"), QStringLiteral("in")};
    return all;
}

} // namespace

UnitSystem unitSystemFromWord(const QString &word)
{
    for (std::size_t i = 0; i < words().size(); ++i) {
        if (words()[i] == word)
            return static_cast<UnitSystem>(i);
    }
    return UnitSystem::Millimetres;
}

QString unitSystemWord(UnitSystem system)
{
    return words()[static_cast<std::size_t>(system)];
}

const ShownUnits &unitsOf(UnitSystem system)
{
    static const std::array<ShownUnits, 3> all{{
        {{QStringLiteral("mm"), 1000},
         {QStringLiteral("m"), 1},
         {QStringLiteral("m/s"), 1},
         {QStringLiteral("m/s²"), 1}},
        {{QStringLiteral("cm"), 100},
         {QStringLiteral("cm"), 100},
         {QStringLiteral("cm/s"), 100},
         {QStringLiteral("cm/s²"), 100}},
        {{QStringLiteral("in"), 1 / inch},
         {QStringLiteral("ft"), 1 / foot},
         {QStringLiteral("ft/s"), 1 / foot},
         {QStringLiteral("ft/s²"), 1 / foot}},
    }};
    return all[static_cast<std::size_t>(system)];
}

UnitSystem shownUnitSystem()
{
    return shown;
}

void setShownUnitSystem(UnitSystem system)
{
    shown = system;
}

const ShownUnits &shownUnits()
{
    return unitsOf(shown);
}

namespace {

constexpr int mostDecimals = 6;

/// The position of the first significant digit: 0 for 1 to 9.99, -1 for 0.1 to 0.999.
int leadingPosition(double magnitude)
{
    return static_cast<int>(std::floor(std::log10(magnitude)));
}

/// Digits after the point (negative: before it) that a σ allows.
int decimalsForSigma(double sigma)
{
    const int place = leadingPosition(sigma);
    const bool leadsWithOne = sigma / std::pow(10.0, place) < 1.95; // 1.96 is written as 2
    return -place + (leadsWithOne ? 1 : 0);
}

QString rounded(double value, int decimals, const QLocale &locale)
{
    const double unit = std::pow(10.0, -decimals);
    double result = decimals < 0 ? std::round(value / unit) * unit : value;
    if (std::abs(result) < unit / 2)
        result = 0; // no "-0.00"
    QLocale plain = locale;
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    return plain.toString(result, 'f', std::clamp(decimals, 0, mostDecimals));
}

NumberText shownNumber(double value, std::optional<double> sigma, const ShownUnit &unit,
                       const QLocale &locale)
{
    return numberText(value * unit.perSi, sigma ? std::optional(*sigma * unit.perSi) : std::nullopt,
                      unit.name, locale);
}

} // namespace

QString NumberText::text() const
{
    QString all = value;
    if (!sigma.isEmpty())
        all += QStringLiteral(" ±") + sigma;
    if (!unit.isEmpty())
        all += QChar(u'\u00a0') + unit;
    return all;
}

QString NumberText::smallPrint() const
{
    if (sigma.isEmpty())
        return unit;
    const QString plusMinus = QStringLiteral("±") + sigma;
    return unit.isEmpty() ? plusMinus : unit + u' ' + plusMinus;
}

NumberText numberText(double value, std::optional<double> sigma, const QString &unit, const QLocale &locale)
{
    if (!std::isfinite(value))
        return {QStringLiteral("–"), {}, unit};
    const bool sigmaKnown = sigma && std::isfinite(*sigma) && *sigma >= std::pow(10.0, -mostDecimals);
    if (sigmaKnown) {
        const int decimals = decimalsForSigma(*sigma);
        return {rounded(value, decimals, locale), rounded(*sigma, decimals, locale), unit};
    }
    const double magnitude = std::abs(value);
    if (unit.isEmpty() && value == std::round(value)) // a count
        return {rounded(value, 0, locale), {}, unit};
    const int decimals =
        magnitude < std::pow(10.0, -mostDecimals) ? 0 : std::max(0, 2 - leadingPosition(magnitude));
    return {rounded(value, decimals, locale), {}, unit};
}

ShownUnit metricUnit(const Metric &metric)
{
    const ShownUnits &units = shownUnits();
    if (metric.unit == "rad/s") // nobody drives in radians
        return {QStringLiteral("°/s"), 180 / std::numbers::pi};
    if (metric.name == "path_completed")
        return {QStringLiteral("%"), 100};
    if (metric.unit == "m")
        return units.distance;
    if (metric.unit == "mm")
        return {units.length.name, fromMillimetres(units.length.perSi)};
    if (metric.unit == "m/s")
        return units.speed;
    if (metric.unit == "m/s²")
        return units.acceleration;
    if (metric.unit == "points")
        return {QCoreApplication::translate("odo::NumberText", "points"), 1};
    return {metric.unit == "1" ? QString() : QString::fromStdString(metric.unit), 1};
}

NumberText metricNumber(const Metric &metric, const QLocale &locale)
{
    const auto sigma = metric.name == "path_completed" ? std::nullopt : metric.sigma;
    NumberText figure = shownNumber(metric.value, sigma, metricUnit(metric), locale);
    if (metric.isAtLeast)
        figure.value.prepend(QStringLiteral("≥ "));
    return figure;
}

QString metricName(const std::string &name)
{
    if (const MetricKind *kind = metricKind(name))
        return shownWords(kind->name);
    QString readable = QString::fromStdString(name).replace(u'_', u' ');
    if (!readable.isEmpty())
        readable[0] = readable[0].toUpper();
    return readable;
}

QString plainNumber(const std::optional<double> &value)
{
    constexpr int allDigits = 9;
    if (!value || !std::isfinite(*value))
        return {};
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(*value, 'g', allDigits);
}

QString shortDate(Instant instant)
{
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(instant.time_since_epoch().count()),
                              QLocale::ShortFormat);
}

QString timeCode(Nanoseconds time)
{
    using namespace std::chrono;
    const auto total = round<milliseconds>(abs(time)).count();
    const auto ms = total % 1000, s = total / 1000 % 60, min = total / 60'000 % 60, h = total / 3'600'000;
    const QString sign = time < Nanoseconds(0) && total > 0 ? QStringLiteral("-") : QString();
    const QString rest = QStringLiteral("%1:%2.%3")
                             .arg(min, 2, 10, QChar(u'0'))
                             .arg(s, 2, 10, QChar(u'0'))
                             .arg(ms, 3, 10, QChar(u'0'));
    return h == 0 ? sign + rest : sign + QString::number(h) + u':' + rest;
}

QString secondsText(Nanoseconds time, const QLocale &locale)
{
    return rounded(toSeconds(time), 2, locale) + QStringLiteral("\u00a0s");
}

QString lengthText(double metres, const QLocale &locale)
{
    const ShownUnit &unit = shownUnits().length;
    if (!std::isfinite(metres))
        return QStringLiteral("–");
    constexpr double finestM = 0.0001; // 0.1 mm
    const int most = std::max(0, int(std::ceil(-std::log10(finestM * unit.perSi) - 0.5)));
    const int decimals = std::max(0, std::abs(metres) < 0.1 ? most : most - 1);
    return rounded(metres * unit.perSi, decimals, locale) + QChar(u'\u00a0') + unit.name;
}

QString distanceText(double metres, const QLocale &locale)
{
    const ShownUnit &unit = shownUnits().distance;
    return rounded(metres * unit.perSi, unit.perSi < 100 ? 2 : 0, locale) + QChar(u'\u00a0') + unit.name;
}

QString speedText(double metresPerSecond, std::optional<double> sigma, const QLocale &locale)
{
    return shownNumber(metresPerSecond, sigma, shownUnits().speed, locale).text();
}

namespace {

/// The point or comma that parts thousands, where a text has it once and no decimal sign; empty in any other
/// case.
QString onlySign(const QString &text, const QLocale &locale)
{
    const QString sign = locale.groupSeparator();
    const bool isPointOrComma = sign == QStringLiteral(".") || sign == QStringLiteral(",");
    return isPointOrComma && text.count(sign) == 1 && !text.contains(locale.decimalPoint()) ? sign
                                                                                            : QString();
}

} // namespace

bool isAmbiguousNumber(const QString &text, const QLocale &locale)
{
    static const QRegularExpression thousands(QStringLiteral("^\\D*[1-9]\\d{0,2}[.,]\\d{3}(?!\\d)"));
    return !onlySign(text, locale).isEmpty() && thousands.match(text).hasMatch();
}

QString withDecimalSign(QString text, const QLocale &locale)
{
    if (const QString sign = onlySign(text, locale); !sign.isEmpty() && !isAmbiguousNumber(text, locale))
        text.replace(sign, locale.decimalPoint());
    return text;
}

std::optional<double> typedNumber(const QString &text, const QLocale &locale)
{
    const QString bare = text.trimmed();
    if (isAmbiguousNumber(bare, locale))
        return std::nullopt;
    bool read = false;
    double number = locale.toDouble(withDecimalSign(bare, locale), &read);
    if (!read)
        number = QLocale::c().toDouble(bare, &read);
    return read && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

QString storedValue(const QString &typed, const QLocale &locale)
{
    const QString bare = typed.trimmed();
    bool isStored = false;
    QLocale::c().toDouble(bare, &isStored);
    return isStored || !typedNumber(bare, locale) ? bare : withDecimalSign(bare, QLocale::c());
}

QString coordinateText(double metres, std::optional<double> sigmaM, const QLocale &locale)
{
    const ShownUnit &unit = shownUnits().length;
    if (sigmaM)
        return numberText(metres * unit.perSi, *sigmaM * unit.perSi, unit.name, locale).text();
    constexpr double millimetre = 1e-3;
    const int decimals =
        std::max(0, static_cast<int>(std::ceil(-std::log10(millimetre * unit.perSi) - 1e-9)));
    QLocale plain = locale;
    plain.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator);
    return plain.toString(metres * unit.perSi, 'f', decimals) + u' ' + unit.name;
}

QString withNumbersPadded(const QString &text)
{
    constexpr qsizetype width = 12;
    QString padded;
    for (qsizetype i = 0; i < text.size();) {
        qsizetype end = i;
        while (end < text.size() && text.at(end).isDigit())
            ++end;
        if (end > i)
            padded += text.mid(i, end - i).rightJustified(width, u'0');
        else
            padded += text.at(end++);
        i = end;
    }
    return padded;
}

} // namespace odo
