// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"
#include "ui/models/internal/row_table_model.h"

#include <QString>
#include <functional>
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

class Project;

/// The changes that one dialog makes to a project: reported in words, and undone by the dialog only if they
/// are its own. On the project's thread; the project must outlive it.
class OwnChanges
{
public:
    explicit OwnChanges(Project &project) : m_project(project) {}
    /// Project::change. The sentence says what was done; empty: it changed nothing.
    Result<QString> make(const Message &words, const std::function<Result<void>()> &work);
    /// Of the last one that was made here. NotFound where there is none left.
    Result<QString> undo();
    Result<QString> redo();

private:
    Project &m_project;
    int m_made = 0, m_undone = 0;
};

} // namespace odo
