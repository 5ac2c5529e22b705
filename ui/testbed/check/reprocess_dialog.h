// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/job_runner.h"
#include "core/workflow/reprocess_job.h"

#include <QDialog>
#include <memory>

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace odo {

/// Measures a trial again with the registrations in force and shows what that changes, figure by figure, before it is kept.
/// What is not kept leaves nothing behind.
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
