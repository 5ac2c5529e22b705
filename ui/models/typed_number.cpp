// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/typed_number.h"

#include <QRegularExpression>
#include <cmath>

namespace odo {

namespace {

/// The point or comma that parts thousands, where a text has it once and no decimal sign; empty in any other case.
QString onlySign(const QString &text, const QLocale &locale)
{
    const QString sign = locale.groupSeparator();
    const bool isPointOrComma = sign == QStringLiteral(".") || sign == QStringLiteral(",");
    return isPointOrComma && text.count(sign) == 1 && !text.contains(locale.decimalPoint()) ? sign : QString();
}

} // namespace

bool isReadTwoWays(const QString &text, const QLocale &locale)
{
    static const QRegularExpression thousands(QStringLiteral("^\\D*[1-9]\\d{0,2}[.,]\\d{3}(?!\\d)"));
    return !onlySign(text, locale).isEmpty() && thousands.match(text).hasMatch();
}

QString withDecimalSign(QString text, const QLocale &locale)
{
    if (const QString sign = onlySign(text, locale); !sign.isEmpty() && !isReadTwoWays(text, locale))
        text.replace(sign, locale.decimalPoint());
    return text;
}

std::optional<double> typedNumber(const QString &text, const QLocale &locale)
{
    const QString bare = text.trimmed();
    if (isReadTwoWays(bare, locale))
        return std::nullopt;
    bool read = false;
    double number = locale.toDouble(withDecimalSign(bare, locale), &read);
    if (!read)
        number = QLocale::c().toDouble(bare, &read);
    return read && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

} // namespace odo
