// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/trial_table.h"
#include "ui/models/number_text.h"

#include <QLocale>
#include <QStringList>
#include <cmath>
#include <optional>

namespace odo {

/// Tables for the clipboard: cells parted by tabs, for a spreadsheet of this country.

/// By how much a stored value is multiplied for the unit that is shown.
inline double factorOf(const TrialTableColumn &column)
{
    return metricUnit({column.metric, column.unit, 0, {}}).perSi;
}

/// In all digits, without signs between thousands; nothing where it is not known.
inline QString plainNumber(const std::optional<double> &value)
{
    constexpr int allDigits = 9;
    if (!value || !std::isfinite(*value))
        return {};
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(*value, 'g', allDigits);
}

/// A text that parts no cells.
inline QString plainCell(QString text)
{
    for (const QChar sign : {u'\t', u'\n', u'\r'})
        text.replace(sign, u' ');
    return text;
}

inline QString asLine(const QStringList &cells)
{
    return cells.join(u'\t') + u'\n';
}

} // namespace odo
