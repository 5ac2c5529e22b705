// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check_tools.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/models/live_cameras.h"
#include "ui/testbed/check/accuracy_dialog.h"
#include "ui/testbed/check/length_wizard.h"
#include "ui/testbed/check/moved_dialog.h"
#include "ui/testbed/check/revisions_dialog.h"
#include "ui/testbed/known_cameras.h"
#include "ui/testbed/tool_action.h"
#include "ui/views/command_names.h"

#include <QAction>

namespace odo {

CheckTools::CheckTools(Project &project, LiveCameras &live, QWidget &window)
    : QObject(&window), m_project(project), m_live(live), m_window(window)
{
    add(Moved, QStringLiteral("moved"), tr("&Check the cameras…"), tr("Moved?"),
        tr("Look whether each camera still stands where it was registered, before the robots run"), &CheckTools::checkMoved);
    add(Length, QStringLiteral("length"), tr("Check a known &length…"), tr("Length…"),
        tr("Measure something of known length in a camera's picture, and see whether the camera is as good as it promises"),
        &CheckTools::checkLength);
    add(Accuracy, QStringLiteral("accuracy"), tr("&Expected accuracy…"), tr("Accuracy…"),
        tr("See how well each place of the floor will be known, also with cameras that are only planned"), &CheckTools::showAccuracy);
    add(Revisions, QStringLiteral("revisions"), tr("&Older calibrations…"), tr("Revisions…"),
        tr("See every calibration and registration of a camera, put an older one in force, measure trials again"), &CheckTools::showRevisions);
    nameCommands({{action(Moved), "checkMoved"}, {action(Length), "checkLength"}, {action(Accuracy), "expectedAccuracy"}, {action(Revisions), "revisions"}});
}

void CheckTools::add(Tool tool, const QString &icon, const QString &text, const QString &shortText, const QString &tip,
                     void (CheckTools::*slot)())
{
    Q_ASSERT(m_actions.size() == tool);
    QAction *action = toolAction(icon, text, shortText, tip, this);
    connect(action, &QAction::triggered, this, slot);
    m_actions.append(action);
}

void CheckTools::setCurrent(const QString &camera, const std::optional<LayoutRecord> &layout, bool isRegistered)
{
    m_camera = camera;
    m_layout = layout;
    m_actions.at(Moved)->setEnabled(isRegistered);
    m_actions.at(Length)->setEnabled(isRegistered);
    m_actions.at(Revisions)->setEnabled(!camera.isEmpty());
    m_actions.at(Accuracy)->setEnabled(layout.has_value());
}

void CheckTools::checkLength()
{
    auto cameras = checkCameras(m_project);
    if (!cameras) {
        Q_EMIT failed(cameras.error());
        return;
    }
    if (cameras->empty())
        return;
    m_live.look();
    LengthWizard(std::move(*cameras), m_camera, m_live, &m_window).exec();
}

void CheckTools::showAccuracy()
{
    auto cameras = checkCameras(m_project);
    const auto robots = m_project.robots().all();
    if (!cameras || !robots) {
        Q_EMIT failed(cameras ? robots.error() : cameras.error());
        return;
    }
    std::erase_if(*cameras, [this](const CheckCamera &camera) { return camera.layout.name != m_layout->layout.name; });
    double heightM = 0; // of a robot that was told; the figures hardly depend on it
    for (const RobotRecord &robot : *robots)
        heightM = std::max(heightM, robot.heightM.value_or(0));
    AccuracyDialog(m_layout->layout, *cameras, heightM, &m_window).exec();
}

void CheckTools::checkMoved()
{
    auto cameras = checkCameras(m_project);
    if (!cameras) {
        Q_EMIT failed(cameras.error());
        return;
    }
    m_live.look();
    MovedDialog dialog(m_project, std::move(*cameras), m_live, &m_window);
    dialog.exec();
    if (dialog.hasChecked())
        Q_EMIT changed(tr("The cameras are checked: see their badges."));
    if (!dialog.toRegister().isEmpty())
        Q_EMIT registerRequested(dialog.toRegister());
}

void CheckTools::showRevisions()
{
    QStringList names;
    for (const CameraRecord &camera : m_project.cameras().all().value_or(std::vector<CameraRecord>()))
        names << QString::fromStdString(camera.name);
    RevisionsDialog dialog(m_project, names, m_camera, &m_window);
    dialog.exec();
    if (dialog.hasChanged())
        Q_EMIT changed(tr("Calibrations and trials are as they were chosen."));
}

} // namespace odo
