// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/setup_checks.h"
#include "ui/models/background_task.h"

#include <QDialog>
#include <memory>

class QLabel;
class QPushButton;

namespace odo {

class FactList;
class RunningCameras;

/// The set-up doctor: what makes cameras lose pictures or measure wrongly on this machine, each with what to
/// do about it.
class DoctorDialog : public QDialog
{
    Q_OBJECT
public:
    /// cameras: those that run, if any do; must outlive it.
    explicit DoctorDialog(const RunningCameras &cameras, QWidget *parent = nullptr);

private:
    void examine();
    void show(const std::vector<SetupFinding> &findings);

    const RunningCameras &m_cameras;
    FactList *m_facts;
    QLabel *m_words;
    QPushButton *m_again = nullptr;
    BackgroundTask m_task;
};

} // namespace odo
