// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"
#include "ui/main_window/internal/pick_colour_dialog.h"
#include "ui/models/project_changes.h"

#include <QDialog>
#include <functional>
#include <vector>

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace odo {

class Project;

/// The robots of a project: add, edit, delete, each as one change that can be undone, here too (Ctrl+Z undoes
/// changes made here). On the project's thread; the project must outlive it.
class RobotsDialog : public QDialog
{
    Q_OBJECT
public:
    explicit RobotsDialog(Project &project, bool readOnly = false, QWidget *parent = nullptr);

Q_SIGNALS:
    void changed(); ///< the project

private:
    void refresh(const std::string &choose);
    const RobotRecord *current() const;
    void add();
    void change();
    void remove();
    void apply(const Message &words, const std::string &choose, const std::function<Result<void>()> &work);
    void showOutcome(const Result<QString> &outcome, const std::string &choose);

    Project &m_project;
    OwnChanges m_changes;
    const bool m_readOnly;
    std::vector<RobotRecord> m_robots;
    QTableWidget *m_table;
    QPushButton *m_add, *m_edit, *m_remove;
    QLabel *m_message;
};

class RobotFootprint;

/// Asks what helps to find a robot: name, whether it is known by a colour, height; and in which colour it is
/// drawn and which point of it is measured.
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
