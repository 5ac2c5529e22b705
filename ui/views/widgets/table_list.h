// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QStyledItemDelegate>
#include <vector>

class QTableView;

namespace odo {

/// Paints the badge of an item of a list or table, text and state taken from two roles of its model. An item
/// without a badge text is painted as any other.
class BadgeDelegate : public QStyledItemDelegate
{
    Q_OBJECT
public:
    BadgeDelegate(int textRole, int stateRole, QObject *parent);
    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    const int m_textRole, m_stateRole;
};

/// Lets a table look and behave as a list of rows, as all of Odograph's dialogs show them: rows are chosen,
/// cells are not edited, there is no grid and no row numbers, and Tab goes on to the next widget.
void showAsList(QTableView &table);

/// Makes the columns as wide as their content. What is left goes to one of them; if they do not all fit, the
/// shrinkable ones become narrower, the widest first: all to 16 letters, all but the first of them to eight,
/// and then that one to twelve, but none below its heading. What does not fit then is reached by scrolling.
void fitColumns(QTableView &table, int taking, const QList<int> &shrinkable);

/// The record that a row shows; nullptr where no row is chosen (-1), or where the row shows none.
template <class Record>
const Record *recordAt(const std::vector<Record> &records, int row)
{
    return row >= 0 && row < static_cast<int>(records.size()) ? &records[static_cast<std::size_t>(row)]
                                                              : nullptr;
}

} // namespace odo
