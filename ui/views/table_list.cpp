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

void fitColumns(QTableView &table, int taking, const QList<int> &givingWay)
{
    table.resizeColumnsToContents();
    QHeaderView &header = *table.horizontalHeader();
    const int least = 8 * table.fontMetrics().averageCharWidth();
    int spare = table.viewport()->width() - header.length();
    if (spare > 0)
        return header.resizeSection(taking, header.sectionSize(taking) + spare);
    while (spare < 0) {
        const auto widest =
            std::ranges::max_element(givingWay, {}, [&](int column) { return header.sectionSize(column); });
        if (widest == givingWay.end() || header.sectionSize(*widest) <= least)
            return;
        header.resizeSection(*widest, header.sectionSize(*widest) - 1);
        ++spare;
    }
}

} // namespace odo
