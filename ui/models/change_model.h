// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <QAbstractTableModel>
#include <vector>

namespace odo {

/// What was changed in a project and when, the newest first; only what holds a text, in any case of its
/// letters.
class ChangeModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Columns { DateColumn, KindColumn, WordsColumn, ColumnCount };

    explicit ChangeModel(std::vector<ChangeEntry> changes, QObject *parent = nullptr);
    void setText(const QString &text);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    const std::vector<ChangeEntry> m_changes;
    std::vector<std::size_t> m_shown;
};

} // namespace odo
