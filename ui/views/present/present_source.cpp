// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/present/present_source.h"

#include <QLocale>

namespace odo {

QString presentedSpeed(double metresPerSecond)
{
    const ShownUnit &unit = shownUnits().speed;
    constexpr int decimals = 2; // of m/s
    return QLocale().toString(metresPerSecond * unit.perSi, 'f', unit.perSi > 1 ? 0 : decimals);
}

} // namespace odo
