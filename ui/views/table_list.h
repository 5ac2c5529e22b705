// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QTableView;

namespace odo {

/// Lets a table look and behave as a list of rows, as all of Odograph's dialogs show them: rows are chosen, cells are not
/// edited, there is no grid and no row numbers, and Tab goes on to the next widget.
void showAsList(QTableView &table);

} // namespace odo
