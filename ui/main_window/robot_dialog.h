// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "ui/main_window/pick_colour_dialog.h"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLineEdit;
class QPushButton;

namespace odo {

class RobotFootprint;

/// Asks what helps to find a robot: name, whether it is known by a colour, height; and in which colour it is drawn and which point of it is measured.
class RobotDialog : public QDialog
{
    Q_OBJECT
public:
    /// videos: in which a robot may be seen, to take its colour from.
    explicit RobotDialog(QList<PickableVideo> videos, QWidget *parent = nullptr);
    /// One that is to be changed; what is not asked for (length, width) stays.
    void setRobot(const RobotRecord &robot);
    RobotRecord robot() const;

private:
    void chooseColour();
    void pickColour();
    void showColour();
    void showFootprint();
    void updateButtons();

    QList<PickableVideo> m_videos;
    RobotRecord m_before;
    QLineEdit *m_name;
    QComboBox *m_look; ///< its data: whether it is known by its colour
    QPushButton *m_colourButton, *m_pickButton;
    RgbColour m_colour{0xd7, 0x23, 0x28};
    QComboBox *m_drawing;
    QComboBox *m_heightMode;
    QDoubleSpinBox *m_height, *m_forward, *m_left;
    RobotFootprint *m_footprint;
    QDialogButtonBox *m_buttons;
};

} // namespace odo
