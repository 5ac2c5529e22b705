// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/robot_footprint.h"

#include "ui/views/map_painting.h"
#include "ui/views/robot_colours.h"
#include "ui/views/theme.h"

#include <QLocale>
#include <QPainter>

namespace odo {
namespace {

constexpr double usualLengthM = 0.22, usualWidthM = 0.16;

} // namespace

RobotFootprint::RobotFootprint(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("The robot from above, heading to the right"));
    setRobot({});
}

void RobotFootprint::setRobot(const RobotRecord &robot)
{
    m_robot = robot;
    m_isSizeGiven = robot.lengthM && robot.widthM;
    if (!m_isSizeGiven) {
        m_robot.lengthM = usualLengthM;
        m_robot.widthM = usualWidthM;
    }
    setAccessibleDescription(words());
    update();
}

QString RobotFootprint::words() const
{
    const QLocale locale;
    const QString length = locale.toString(toMillimetres(*m_robot.lengthM), 'f', 0), width = locale.toString(toMillimetres(*m_robot.widthM), 'f', 0);
    return m_isSizeGiven ? tr("%1 × %2 mm").arg(length, width) : tr("No size given. Drawn as %1 × %2 mm").arg(length, width);
}

void RobotFootprint::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.mapGround);
    const Eigen::Vector2d corner(*m_robot.lengthM / 2, *m_robot.widthM / 2);
    MapPlan plan;
    plan.size = size();
    plan.bounds = Eigen::AlignedBox2d(-corner, corner).extend(m_robot.referenceM);
    MapRobot sign;
    sign.robot = &m_robot;
    sign.position = sign.referenceM = m_robot.referenceM; // its centre is the origin
    sign.headingRad = 0;
    sign.colour = drawnColour(m_robot.drawingColour, colours.spike, palette());
    drawMapRobot(painter, plan, sign, palette());
    painter.setPen(colours.muted);
    constexpr double margin = 6;
    painter.drawText(QRectF(rect()).adjusted(margin, 0, -margin, -margin), Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, words());
}

} // namespace odo
