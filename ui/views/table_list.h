// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

class QTableView;

namespace odo {

/// Lets a table look and behave as a list of rows, as all of Odograph's dialogs show them: rows are chosen, cells are not
/// edited, there is no grid and no row numbers, and Tab goes on to the next widget.
void showAsList(QTableView &table);

/// The record that a row shows; nullptr where no row is chosen (-1), or where the row shows none.
template <class Record>
const Record *recordAt(const std::vector<Record> &records, int row)
{
    return row >= 0 && row < static_cast<int>(records.size()) ? &records[static_cast<std::size_t>(row)]
                                                              : nullptr;
}

} // namespace odo
