// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace odo {

/// Paints the badge of an item of a list or table, text and state taken from two roles of its model. An item without a badge
/// text is painted as any other.
class BadgeDelegate : public QStyledItemDelegate
{
    Q_OBJECT
public:
    BadgeDelegate(int textRole, int stateRole, QObject *parent);
    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    const int m_textRole, m_stateRole;
};

} // namespace odo
