// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/trial_table.h"
#include "ui/models/number_text.h"

#include <QStringList>

namespace odo {

/// Tables for the clipboard: cells parted by tabs, for a spreadsheet of this country.

/// By how much a stored value is multiplied for the unit that is shown.
inline double factorOf(const TrialTableColumn &column)
{
    return metricUnit({column.metric, column.unit, 0, {}}).perSi;
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
