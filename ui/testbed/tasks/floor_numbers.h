// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace odo {

/// Places on the floor as a person writes them in tables: millimetres, without a grouping that could be read as a decimal sign.
/// A place that is no number is empty.
QString placeText(double metres);
/// Of 1200,5 or 1200.5 in millimetres; NaN for what is no number.
double placeOf(const QString &text);

} // namespace odo
