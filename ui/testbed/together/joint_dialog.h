// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/calibrate/register_job.h"
#include "ui/models/background_task.h"

#include <QDialog>
#include <functional>
#include <memory>

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace odo {

/// Registers all cameras of a layout together and shows what changes, before anything is stored. Once it is
/// accepted the job is to be committed by whoever opened it.
class JointDialog : public QDialog
{
    Q_OBJECT
public:
    /// A job for this σ of the markers' measured places, prepared. Called on the dialog's thread.
    using Prepare = std::function<Result<std::shared_ptr<RegisterJointJob>>(double tapeSigmaM)>;

    JointDialog(const QString &layout, Prepare prepare, QWidget *parent = nullptr);
    ~JointDialog() override;

    /// Once accepted: run, not yet committed.
    const std::shared_ptr<RegisterJointJob> &job() const { return m_job; }

    void done(int result) override;

private:
    QWidget *makeTables();
    void fit();
    void show(const std::optional<Error> &error);
    void showCameras();
    void showMarkers();

    const Prepare m_prepare;
    std::shared_ptr<RegisterJointJob> m_job;
    BackgroundTask m_task;
    bool m_fitAgain = false;
    QDoubleSpinBox *m_tape;
    QTableWidget *m_cameras, *m_markers;
    QLabel *m_verdict, *m_advice;
    QPushButton *m_save;
};

} // namespace odo
