// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/revisions.h"

#include <QDialog>
#include <QStringList>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace odo {

class Project;
class RevisionPicture;

/// Every calibration and registration of a camera: when, by which version, from what, how good, and which trials were
/// measured with it. An older one can be put in force again, and trials measured anew with what is in force.
class RevisionsDialog : public QDialog
{
    Q_OBJECT
public:
    /// The project must outlive the dialog; used on its own thread.
    RevisionsDialog(Project &project, const QStringList &cameras, const QString &current, QWidget *parent = nullptr);
    ~RevisionsDialog() override;

    /// Something was changed in the project.
    bool hasChanged() const { return m_hasChanged; }

private:
    void refresh();
    void showRow(int row);
    void showCurrent();
    void choose();
    void registerAnew();
    void reprocess();
    void tell(const QString &words);

    Project &m_project;
    std::vector<Revision> m_revisions;
    bool m_hasChanged = false;
    QComboBox *m_camera;
    QTableWidget *m_table;
    QLabel *m_words;
    RevisionPicture *m_picture;
    QPushButton *m_choose, *m_register, *m_reprocess;
};

} // namespace odo
