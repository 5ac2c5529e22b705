// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

namespace odo {

/// A table whose rows lie in a list: asks its heir only for cells and headings that there are. GUI thread.
class RowTableModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    int rowCount(const QModelIndex &parent = {}) const final { return parent.isValid() ? 0 : rows(); }
    int columnCount(const QModelIndex &parent = {}) const final { return parent.isValid() ? 0 : m_columns; }
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const final;
    /// Nothing beside the rows.
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const final;

protected:
    RowTableModel(int columns, QObject *parent) : QAbstractTableModel(parent), m_columns(columns) {}
    virtual int rows() const = 0;
    virtual QVariant cell(int index, int column, int role) const = 0;
    virtual QVariant heading(int column, int role) const = 0;
    /// What Qt::TextAlignmentRole answers: left or right, in the middle of the line.
    static QVariant aligned(Qt::Alignment side);

private:
    const int m_columns;
};

} // namespace odo
