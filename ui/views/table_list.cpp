// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/table_list.h"

#include <QHeaderView>
#include <QTableView>
#include <algorithm>

namespace odo {

void showAsList(QTableView &table)
{
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setShowGrid(false);
    table.setTabKeyNavigation(false);
    table.verticalHeader()->hide();
    table.horizontalHeader()->setHighlightSections(false);
    table.horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

namespace {

/// The widest first, pixel by pixel, down to a width; gives what is still missing.
int shrink(QHeaderView &header, const QList<int> &columns, int least, int missing)
{
    for (; missing > 0; --missing) {
        const auto widest = std::ranges::max_element(columns, {}, [&](int column) { return header.sectionSize(column); });
        if (widest == columns.end() || header.sectionSize(*widest) <= least)
            break;
        header.resizeSection(*widest, header.sectionSize(*widest) - 1);
    }
    return missing;
}

} // namespace

void fitColumns(QTableView &table, int taking, const QList<int> &givingWay)
{
    table.resizeColumnsToContents();
    QHeaderView &header = *table.horizontalHeader();
    const int letter = table.fontMetrics().averageCharWidth(), least = 8 * letter, enough = 16 * letter;
    const int spare = table.viewport()->width() - header.length();
    if (spare > 0)
        return header.resizeSection(taking, header.sectionSize(taking) + spare);
    int missing = -spare;
    missing = shrink(header, givingWay, enough, missing);
    missing = shrink(header, givingWay.mid(1), least, missing);
    shrink(header, givingWay, least, missing);
}

} // namespace odo
