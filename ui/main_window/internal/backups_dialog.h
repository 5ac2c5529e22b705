// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/backups.h"
#include "ui/models/background_task.h"

#include <QDialog>
#include <filesystem>
#include <vector>

class QLabel;
class QPushButton;
class QTableView;
class QTableWidget;

namespace odo {

class ChangeModel;

/// The backups of a project: where they are, what restoring one would change, one more
/// now. Reads on threads of its own. Accepted: chosen() is to be restored. The project must stay open
/// meanwhile.
class BackupsDialog : public QDialog
{
    Q_OBJECT
public:
    explicit BackupsDialog(const std::filesystem::path &project, bool readOnly = false,
                           QWidget *parent = nullptr);

    /// The backup that is chosen; empty: none.
    std::filesystem::path chosen() const;

private:
    void refresh();
    void backUpNow();
    void showPreview();
    void takePreview(const Result<BackupPreview> &preview);
    void setChanges(std::vector<ChangeEntry> changes);

    const std::filesystem::path m_project;
    const bool m_readOnly;
    std::vector<ProjectBackup> m_backups;
    QTableWidget *m_list;
    QLabel *m_preview, *m_message;
    QTableView *m_changes;
    QPushButton *m_make, *m_restore;
    ProjectReader m_previewReader, m_maker;
};

} // namespace odo
