// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/register_job.h"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QRadioButton;

namespace odo {

class PathField;

/// Asks what a registration needs: which camera, which marker layout, and where its markers are seen.
class RegisterDialog : public QDialog
{
    Q_OBJECT
public:
    RegisterDialog(const QStringList &cameras, const QString &current, const QStringList &layouts,
                   QWidget *parent = nullptr);
    RegisterSettings settings() const;

private:
    void updateButtons();

    QComboBox *m_camera, *m_layout;
    QRadioButton *m_fromRecording, *m_fromFile, *m_fromPixels;
    PathField *m_picture, *m_pixels;
    QDialogButtonBox *m_buttons;
};

} // namespace odo
