// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/row_table_model.h"

namespace odo {

QVariant RowTableModel::data(const QModelIndex &index, int role) const
{
    return checkIndex(index, CheckIndexOption::IndexIsValid) ? cell(index.row(), index.column(), role)
                                                             : QVariant();
}

QVariant RowTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    const bool isThere = orientation == Qt::Horizontal && section >= 0 && section < m_columns;
    return isThere ? heading(section, role) : QVariant();
}

QVariant RowTableModel::aligned(Qt::Alignment side)
{
    return QVariant::fromValue(side | Qt::AlignVCenter);
}

} // namespace odo
