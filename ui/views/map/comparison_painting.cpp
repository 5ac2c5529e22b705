// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/map/comparison_painting.h"

#include "ui/views/widgets/theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <optional>

namespace odo {

namespace {

constexpr double gateHalfPx = 17, closestPx = 0.8;
constexpr int mostDashed = 20000; // points of a way

QPainterPath runWayOf(const Profile &profile, const MapPlan &plan)
{
    QPainterPath way;
    std::optional<QPointF> last;
    for (const ProfilePoint &point : profile.points) {
        if (!point.valid) {
            last.reset();
            continue;
        }
        const QPointF at = plan.fromWorld(point.position);
        if (!last)
            way.moveTo(at);
        else if (QLineF(*last, at).length() < closestPx)
            continue;
        else
            way.lineTo(at);
        last = at;
    }
    return way;
}

} // namespace

void drawWays(QPainter &painter, const MapPlan &plan, const ComparisonScene &scene,
              const std::vector<std::size_t> &runs, const QPalette &palette)
{
    for (auto each = runs.rbegin(); each != runs.rend(); ++each) {
        const std::size_t run = *each;
        const QPainterPath way = runWayOf(scene.profile(run), plan);
        // Dashes of a very long way take long to paint, and cover one another.
        const Qt::PenStyle dash = way.elementCount() < mostDashed ? seriesDash(int(run)) : Qt::SolidLine;
        QColor rim = ThemeColours::of(palette).mapGround;
        rim.setAlpha(170);
        painter.strokePath(way, QPen(rim, 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.strokePath(way,
                           QPen(seriesColour(int(run), palette), 2.2, dash, Qt::RoundCap, Qt::RoundJoin));
    }
}

QLineF pathGateLine(const MapPlan &plan, const ReferencePath &path, const PathGate &gate)
{
    const PathPoint at = pointAt(path, gate.stationM);
    const QPointF middle = plan.fromWorld(at.position),
                  across(-at.direction.y(), -at.direction.x()); // Y is up on the floor
    return {middle - gateHalfPx * across, middle + gateHalfPx * across};
}

void drawPathGate(QPainter &painter, const QLineF &line, const QString &name, bool isChosen,
                  const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    const QColor colour = isChosen ? colours.accent : colours.text;
    painter.setPen(QPen(colours.mapGround, 5.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line);
    painter.setPen(QPen(colour, isChosen ? 3.5 : 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line);
    painter.setBrush(colours.card);
    painter.drawEllipse(line.center(), 4, 4);
    const QFontMetricsF metrics(painter.font());
    const QPointF end = line.y1() < line.y2() ? line.p1() : line.p2();
    const QRectF box(end.x() - metrics.horizontalAdvance(name) / 2 - 3, end.y() - metrics.height() - 2,
                     metrics.horizontalAdvance(name) + 6, metrics.height());
    QColor ground = colours.mapGround;
    ground.setAlpha(200);
    painter.fillRect(box, ground);
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter, name);
}

} // namespace odo
