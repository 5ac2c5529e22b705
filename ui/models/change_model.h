// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "ui/models/row_table_model.h"

#include <vector>

namespace odo {

/// What was changed in a project and when, the newest first; only what holds a text, in any case of its
/// letters.
class ChangeModel : public RowTableModel
{
    Q_OBJECT
public:
    enum Columns { DateColumn, KindColumn, WordsColumn, ColumnCount };

    explicit ChangeModel(std::vector<ChangeEntry> changes, QObject *parent = nullptr);
    void setText(const QString &text);

private:
    int rows() const override { return static_cast<int>(m_shown.size()); }
    QVariant cell(int index, int column, int role) const override;
    QVariant heading(int column, int role) const override;
    const std::vector<ChangeEntry> m_changes;
    std::vector<std::size_t> m_shown;
};

} // namespace odo
