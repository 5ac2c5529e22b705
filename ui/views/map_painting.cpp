// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/map_painting.h"

#include "ui/models/shown_units.h"
#include "ui/views/axis_ticks.h"
#include "ui/views/theme.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {
namespace {

constexpr double dotRadius = 7;

class MapPaintingWords
{
    Q_DECLARE_TR_FUNCTIONS(MapPainting)
};

/// The footprint is drawn as one, not as a dot.
bool hasFootprint(const MapRobot &robot)
{
    return robot.headingRad && robot.robot->lengthM && robot.robot->widthM;
}

/// Heading to the right.
QPainterPath robotSign(const MapRobot &robot, double scalePx)
{
    QPainterPath sign;
    const double halfLength = std::max(dotRadius, robot.robot->lengthM.value_or(0) * scalePx / 2);
    const double halfWidth = std::max(dotRadius, robot.robot->widthM.value_or(0) * scalePx / 2);
    if (hasFootprint(robot))
        sign.addRoundedRect(QRectF(-halfLength, -halfWidth, 2 * halfLength, 2 * halfWidth), 2, 2);
    else
        sign.addEllipse(QPointF(0, 0), dotRadius, dotRadius);
    if (!robot.headingRad)
        return sign;
    QPainterPath point(QPointF(halfLength + 7, 0));
    point.lineTo(halfLength - 3, -5.5);
    point.lineTo(halfLength - 3, 5.5);
    point.closeSubpath();
    return sign.united(point);
}

/// Heading to the right, where the arm is longer if the heading is known. The halo keeps it apart from any footprint and floor.
void drawReferenceCross(QPainter &painter, bool isHeadingKnown, const ThemeColours &colours)
{
    constexpr double arm = 5;
    const double forwardArm = isHeadingKnown ? 9 : arm;
    for (const QPen &pen : {QPen(colours.card, 4.5, Qt::SolidLine, Qt::RoundCap), QPen(colours.text, 1.8, Qt::SolidLine, Qt::RoundCap)}) {
        painter.setPen(pen);
        painter.drawLine(QPointF(-arm, 0), QPointF(forwardArm, 0));
        painter.drawLine(QPointF(0, -arm), QPointF(0, arm));
    }
}

} // namespace

double MapPlan::scalePx() const
{
    const double wide = std::max(10.0, size.width() - 2 * sideMargin);
    const double high = std::max(10.0, size.height() - topMargin - footHeight - sideMargin);
    return std::min(wide / std::max(1e-6, bounds.sizes().x()), high / std::max(1e-6, bounds.sizes().y()));
}

QPointF MapPlan::fromWorld(const Eigen::Vector2d &point) const
{
    const Eigen::Vector2d apart = (point - bounds.center()) * scalePx();
    return {size.width() / 2.0 + apart.x(),
            topMargin + (size.height() - topMargin - footHeight - sideMargin) / 2.0 - apart.y()};
}

Eigen::Vector2d MapPlan::toWorld(const QPointF &place) const
{
    const QPointF apart = place - fromWorld(bounds.center());
    return bounds.center() + Eigen::Vector2d(apart.x(), -apart.y()) / scalePx();
}

void drawMapGrid(QPainter &painter, const MapPlan &plan, const QPalette &palette, bool overPicture)
{
    const ThemeColours colours = ThemeColours::of(palette);
    const ShownUnit &unit = shownUnits().distance;
    const AxisTicks ticks = niceTicks(0, unit.perSi * plan.bounds.sizes().maxCoeff(), 7);
    const double step = ticks.step / unit.perSi;
    painter.setRenderHint(QPainter::Antialiasing, false);
    QColor line = overPicture ? colours.muted : colours.mapGrid;
    if (overPicture)
        line.setAlpha(60);
    painter.setPen(QPen(line, 1));
    constexpr double leastApartPx = 4;
    const double apart = step * plan.scalePx();
    const QPointF origin = plan.fromWorld({0, 0});
    for (double x = std::fmod(origin.x(), apart); apart >= leastApartPx && x < plan.size.width(); x += apart)
        painter.drawLine(QPointF(x, 0), QPointF(x, plan.size.height()));
    for (double y = std::fmod(origin.y(), apart); apart >= leastApartPx && y < plan.size.height(); y += apart)
        painter.drawLine(QPointF(0, y), QPointF(plan.size.width(), y));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(colours.muted);
    painter.drawText(
        QRectF(0, plan.size.height() - MapPlan::footHeight, plan.size.width() - 10, MapPlan::footHeight - 6),
        Qt::AlignRight | Qt::AlignBottom,
        MapPaintingWords::tr("grid %1 %2").arg(ticks.label(ticks.step), unit.name));
}

void drawMapFoot(QPainter &painter, const MapPlan &plan, const QPalette &palette)
{
    QColor foot = ThemeColours::of(palette).mapGround;
    foot.setAlpha(215);
    painter.fillRect(
        QRectF(0, plan.size.height() - MapPlan::footHeight, plan.size.width(), MapPlan::footHeight), foot);
}

void drawMapMarkers(QPainter &painter, const MapPlan &plan, const MarkerLayout &layout,
                    const QPalette &palette)
{
    const QColor colour = ThemeColours::of(palette).text;
    const QFontMetricsF metrics(painter.font());
    for (const Marker &marker : layout.markers) {
        const QPointF at = plan.fromWorld(marker.pointInWorld);
        painter.fillRect(QRectF(at.x() - 4, at.y() - 4, 8, 8), colour);
        painter.setPen(colour);
        const QString label = QString::fromStdString(marker.label);
        const bool above = marker.pointInWorld.y() > plan.bounds.center().y();
        const double baseline = above ? at.y() - 8 : at.y() + 8 + metrics.ascent();
        painter.drawText(QPointF(at.x() - metrics.horizontalAdvance(label) / 2, baseline), label);
    }
}

void drawMapRobot(QPainter &painter, const MapPlan &plan, const MapRobot &robot, const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    const double scale = plan.scalePx();
    const QPointF at = plan.fromWorld(robot.position);
    QColor haze = robot.colour;
    haze.setAlpha(60);
    painter.setPen(Qt::NoPen);
    painter.setBrush(haze);
    painter.drawEllipse(at, 2 * robot.sigmaXM * scale, 2 * robot.sigmaYM * scale);

    painter.setPen(QPen(colours.card, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(robot.colour);
    painter.save();
    painter.translate(at);
    if (robot.headingRad)
        painter.rotate(-*robot.headingRad * 180 /
                       std::numbers::pi); // Y is up on the floor, down on the screen
    const QPointF centre = hasFootprint(robot) ? scale * QPointF(-robot.referenceM.x(), robot.referenceM.y()) : QPointF();
    painter.drawPath(robotSign(robot, scale).translated(centre));
    if (!robot.referenceM.isZero())
        drawReferenceCross(painter, robot.headingRad.has_value(), colours);
    painter.restore();
    if (robot.label.isEmpty())
        return;
    painter.setPen(colours.text);
    painter.drawText(at + QPointF(dotRadius + 9, -dotRadius), robot.label);
}

} // namespace odo
