// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/import/clip_groups.h"
#include "core/workflow/import/import_trial_job.h"
#include "ui/main_window/internal/import_dialogs.h"

#include <QDialog>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace odo {

class CheckList;

/// The runs of a whole lesson, as their clips were grouped by the time of recording: one row a run, with its
/// name, its team and the clip of each camera. Rows that are ticked become trials.
class ImportLessonDialog : public QDialog
{
    Q_OBJECT
public:
    /// offer.name is not used; taken: names of trials that are there.
    ImportLessonDialog(const ImportTrialDialog::Offer &offer, const QStringList &taken,
                       std::vector<ClipGroup> groups, QWidget *parent = nullptr);

    /// Of the rows that are ticked, in their order.
    std::vector<ImportSettings> settings() const;

private:
    enum Column { TrialColumn, TeamColumn, TimeColumn, LengthColumn, FirstClipColumn };
    QWidget *makeCameras(const ImportTrialDialog::Offer &offer);
    void fill(const ImportTrialDialog::Offer &offer);
    bool sharesCamera(int row) const; ///< two of its clips
    QString missing() const;          ///< why it cannot be imported; empty: it can
    void updateButtons();

    const QStringList m_taken;
    const std::vector<ClipGroup> m_groups;
    std::vector<QComboBox *> m_cameras; ///< of each view
    QComboBox *m_task;
    CheckList *m_robots;
    QTableWidget *m_table;
    QLabel *m_message;
    QPushButton *m_accept = nullptr;
};

} // namespace odo
