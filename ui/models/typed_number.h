// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <optional>

namespace odo {

/// Numbers as people type them: with the decimal sign of their language, or with the other one of point and comma
/// where it can be nothing else. "1.234" where a point parts thousands is a thousand to one and a bit to another: it is
/// read as neither. GUI thread.

/// Whether a text has the sign that parts thousands once, where it could be meant as the decimal sign just as well.
bool isReadTwoWays(const QString &text, const QLocale &locale);

/// The text with the locale's own decimal sign, where it has the other one.
QString withDecimalSign(QString text, const QLocale &locale);

/// nullopt: no number, or one that can be read in two ways.
std::optional<double> typedNumber(const QString &text, const QLocale &locale = QLocale());

} // namespace odo
