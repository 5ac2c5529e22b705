// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/robot_pointing.h"

#include "core/tracking/colour_tracker.h"
#include "ui/models/timeline.h"

#include <QAction>
#include <QMenu>
#include <algorithm>

namespace odo {

RobotPointing::RobotPointing(Timeline &timeline, QObject *parent) : QObject(parent), m_timeline(timeline), m_action(new QAction(tr("&Point out a robot"), this))
{
    m_action->setObjectName(QStringLiteral("pointOutRobot"));
    m_action->setCheckable(true);
    m_action->setShortcut(Qt::Key_P);
    m_action->setToolTip(tr("The wrong thing is outlined: click the robot in a picture, and the trial is tracked again (%1)").arg(m_action->shortcut().toString(QKeySequence::NativeText)));
    m_action->setEnabled(false);
    connect(m_action, &QAction::toggled, &m_timeline, &Timeline::pause);
}

RobotPointing::~RobotPointing() = default;

void RobotPointing::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    m_action->setEnabled(!robots().empty());
    m_action->setChecked(false);
}

/// Those that are found by their look may be something else.
std::vector<std::string> RobotPointing::robots() const
{
    std::vector<std::string> names;
    if (!m_scene || !m_scene->imported.empty())
        return names;
    for (const SceneRobot &one : m_scene->robots)
        if (!isFoundByColour({one.robot.name, one.robot.colour}))
            names.push_back(one.robot.name);
    return names;
}

bool RobotPointing::isPointedOut(const std::string &robot) const
{
    return std::ranges::any_of(m_scene->robots, [&](const SceneRobot &one) {
        return one.robot.name == robot && std::ranges::find(m_scene->pointedOut, one.robot.id, &PointedOutRobot::robot) != m_scene->pointedOut.end();
    });
}

void RobotPointing::fill(QMenu &menu, std::size_t view, const QPointF &pixel)
{
    const std::vector<std::string> all = robots();
    if (all.empty() || view >= m_scene->views.size())
        return;
    const auto shown = [](const std::string &robot) { return QString::fromStdString(robot).replace(u'&', QStringLiteral("&&")); };
    for (const std::string &robot : all) {
        const RobotPointer pointer{robot, m_scene->views[view].camera, toSeconds(m_timeline.currentTime()), {pixel.x(), pixel.y()}};
        connect(menu.addAction(tr("This is %1: track it again").arg(shown(robot))), &QAction::triggered, this, [this, pointer] { say(pointer); });
    }
    menu.addSeparator();
    for (const std::string &robot : all)
        if (isPointedOut(robot))
            connect(menu.addAction(tr("Find %1 without help").arg(shown(robot))), &QAction::triggered, this, [this, robot] { say({robot}); });
}

void RobotPointing::ask(std::size_t view, const QPointF &pixel, const QPoint &global)
{
    m_timeline.pause();
    QMenu menu;
    fill(menu, view, pixel);
    if (!menu.isEmpty())
        menu.exec(global);
}

void RobotPointing::say(RobotPointer pointer)
{
    m_action->setChecked(false);
    Q_EMIT said(QString::fromStdString(m_scene->trial.name), pointer);
}

} // namespace odo
