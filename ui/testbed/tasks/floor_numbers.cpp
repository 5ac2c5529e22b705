// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/floor_numbers.h"

#include "core/base/units.h"
#include "ui/models/typed_number.h"

#include <QLocale>
#include <cmath>
#include <limits>

namespace odo {

QString placeText(double metres)
{
    if (!std::isfinite(metres))
        return {};
    QLocale locale; // 2,750 could be read as 2.75
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const double mm = std::round(toMillimetres(metres) * 1000) / 1000; // 0.3 m is 300 mm, not 299.99999999999994
    return locale.toString(mm + 0.0, 'f', QLocale::FloatingPointShortest);
}

double placeOf(const QString &text)
{
    return fromMillimetres(typedNumber(text).value_or(std::numeric_limits<double>::quiet_NaN()));
}

} // namespace odo
