// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/calibrate_job.h"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QListWidget;

namespace odo {

/// Asks what a calibration needs: which camera, pictures of the board, the size of a square. The board's
/// pattern is found out.
class CalibrateDialog : public QDialog
{
    Q_OBJECT
public:
    /// current: the camera that is offered first.
    CalibrateDialog(const QStringList &cameras, const QString &current, QWidget *parent = nullptr);
    CalibrateSettings settings() const;
    void addFiles(const QStringList &files);

private:
    QWidget *makeFileList();
    void updateButtons();

    QComboBox *m_camera;
    QListWidget *m_files;
    
    QDoubleSpinBox *m_square;
    QComboBox *m_lens;
    QDialogButtonBox *m_buttons;
};

} // namespace odo
