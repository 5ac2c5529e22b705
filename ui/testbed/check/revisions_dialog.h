// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/job.h"
#include "core/workflow/track/reanalysis.h"

#include <QDialog>
#include <QStringList>
#include <memory>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace odo {

class Project;
class RevisionImage;

/// Every calibration and registration of a camera: when, by which version, from what, how good, and which
/// trials use it. The user can make an older one current and reanalyse trials with the current ones.
class RevisionsDialog : public QDialog
{
    Q_OBJECT
public:
    /// The project must outlive the dialog; used on its own thread.
    RevisionsDialog(Project &project, const QStringList &cameras, const QString &current,
                    QWidget *parent = nullptr);
    ~RevisionsDialog() override;

    /// Something was changed in the project.
    bool hasChanged() const { return m_hasChanged; }

private:
    void refresh();
    void showRow(int row);
    void showCurrent();
    void choose();
    void reregister();
    void reprocess();
    void showOutcome(const QString &words);

    Project &m_project;
    std::vector<Revision> m_revisions;
    bool m_hasChanged = false;
    QComboBox *m_camera;
    QTableWidget *m_table;
    QLabel *m_words;
    RevisionImage *m_image;
    QPushButton *m_choose, *m_register, *m_reprocess;
};

/// Reanalyses a trial with the current registrations and shows the change of each metric before the user
/// keeps it. A rejected analysis leaves nothing behind.
class ReprocessDialog : public QDialog
{
    Q_OBJECT
public:
    /// The project must outlive the dialog; used on its own thread.
    explicit ReprocessDialog(Project &project, QWidget *parent = nullptr);
    ~ReprocessDialog() override;

    bool isRunning() const { return m_runner.isRunning(); }
    bool hasKept() const { return m_hasKept; }

    void done(int result) override;

private:
    void fillTrials();
    void forget();
    void begin();
    void finish(const std::shared_ptr<Job> &job, const std::optional<Error> &error);
    void showChanges();
    void addMetric(const QString &robot, const MetricChange &metric);
    void keep();

    Project &m_project;
    bool m_hasKept = false;
    QComboBox *m_trial;
    QTableWidget *m_table;
    QLabel *m_words;
    QPushButton *m_begin, *m_keep;
    std::shared_ptr<ReprocessJob> m_done; ///< what is shown, to be kept
    JobRunner m_runner;
};

} // namespace odo
