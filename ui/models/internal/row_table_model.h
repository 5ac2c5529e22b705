// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"

#include <QAbstractTableModel>
#include <vector>

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

/// The metrics of one robot's analysis, in words.
class MetricModel : public RowTableModel
{
    Q_OBJECT
public:
    enum Columns { NameColumn, ValueColumn, ColumnCount };
    enum Roles {
        IdRole = Qt::UserRole, ///< QString, Metric::name
        NumberRole,            ///< double
        ValueTextRole,         ///< QString, "1.83"
        SmallPrintRole,        ///< QString, "m/s ±0.02"
    };

    explicit MetricModel(QObject *parent = nullptr);
    void setMetrics(std::vector<Metric> metrics);

private:
    int rows() const override { return static_cast<int>(m_metrics.size()); }
    QVariant cell(int index, int column, int role) const override;
    QVariant heading(int column, int role) const override;
    std::vector<Metric> m_metrics;
};

} // namespace odo
