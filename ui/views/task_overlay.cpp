// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/task_overlay.h"

#include "ui/views/theme.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPolygonF>
#include <algorithm>

namespace odo {

namespace {

constexpr double postRadius = 3, arrowLength = 13, arrowHead = 5;
constexpr double toothApart = 14, toothLength = 5, longestTeethPx = 20000;
constexpr int hatchAlpha = 150;

void drawArrow(QPainter &painter, const QPointF &from, const QPointF &direction)
{
    const QPointF tip = from + arrowLength * direction, aside(-direction.y(), direction.x());
    painter.drawLine(from, tip);
    painter.drawLine(tip, tip - arrowHead * direction + 0.7 * arrowHead * aside);
    painter.drawLine(tip, tip - arrowHead * direction - 0.7 * arrowHead * aside);
}

/// Beyond the post that is further up, so that the name does not lie on the line.
void drawName(QPainter &painter, const QString &name, const QLineF &line, const ThemeColours &colours)
{
    const bool firstIsUpper = line.y1() <= line.y2();
    const QPointF post = firstIsUpper ? line.p1() : line.p2(), other = firstIsUpper ? line.p2() : line.p1();
    const QLineF outwards = QLineF(post, post + (post - other)).unitVector();
    const QFontMetricsF metrics(painter.font());
    const double wide = metrics.horizontalAdvance(name);
    const QPointF middle = post + (outwards.p2() - outwards.p1()) * (postRadius + 6);
    const double left = outwards.dx() > 0.5 ? middle.x() : outwards.dx() < -0.5 ? middle.x() - wide : middle.x() - wide / 2;
    const QRectF box(left - 3, middle.y() - metrics.height() + metrics.descent(), wide + 6, metrics.height());
    QColor ground = colours.mapGround;
    ground.setAlpha(190);
    painter.fillRect(box, ground);
    painter.setPen(colours.text);
    painter.drawText(QPointF(left, middle.y()), name);
}

/// Short strokes on the outer side of an outline.
void drawTeeth(QPainter &painter, const QPolygonF &outline)
{
    double area = 0;
    for (qsizetype i = 0; i < outline.size(); ++i) {
        const QPointF a = outline[i], b = outline[(i + 1) % outline.size()];
        area += a.x() * b.y() - b.x() * a.y();
    }
    for (qsizetype i = 0; i < outline.size(); ++i) {
        const QLineF edge(outline[i], outline[(i + 1) % outline.size()]);
        const QLineF unit = edge.unitVector();
        const QPointF outwards = (area > 0 ? 1 : -1) * QPointF(unit.dy(), -unit.dx());
        const int count = static_cast<int>(std::min(edge.length(), longestTeethPx) / toothApart);
        for (int tooth = 1; tooth <= count; ++tooth) {
            const QPointF root = edge.pointAt(tooth / (count + 1.0));
            painter.drawLine(root, root + toothLength * outwards);
        }
    }
}

/// Beside the uppermost corner, within the outline as a rule.
void drawZoneName(QPainter &painter, const QString &name, const QPolygonF &outline, const ThemeColours &colours)
{
    const QPointF top = *std::ranges::min_element(outline, {}, [](const QPointF &corner) { return corner.y() + 0.01 * corner.x(); });
    const QFontMetricsF metrics(painter.font());
    const QString shown = metrics.elidedText(name, Qt::ElideRight, std::max(80.0, outline.boundingRect().width() - 12));
    const QPointF base(top.x() + 6, top.y() + metrics.ascent() + 4);
    QColor ground = colours.mapGround;
    ground.setAlpha(190);
    painter.fillRect(QRectF(base.x() - 3, base.y() - metrics.ascent(), metrics.horizontalAdvance(shown) + 6, metrics.height()), ground);
    painter.setPen(colours.text);
    painter.drawText(base, shown);
}

} // namespace

void drawReferencePath(QPainter &painter, const ReferencePath &path, const FloorToScreen &toScreen,
                       const QPalette &palette)
{
    if (path.points.empty())
        return;
    QPainterPath drawn(toScreen(path.points.front()));
    for (const Eigen::Vector2d &point : path.points)
        drawn.lineTo(toScreen(point));
    if (path.closed)
        drawn.closeSubpath();
    QPen pen(ThemeColours::of(palette).text, 1.5);
    pen.setDashPattern({5, 4});
    pen.setCapStyle(Qt::FlatCap);
    painter.strokePath(drawn, pen);
}

void drawZones(QPainter &painter, const std::vector<Zone> &zones, const FloorToScreen &toScreen, const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    for (const Zone &zone : zones) {
        QPolygonF outline;
        for (const Eigen::Vector2d &corner : zone.corners)
            outline << toScreen(corner);
        const bool isForbidden = zone.rule == ZoneRule::StayOutside;
        QColor faint = colours.spike;
        faint.setAlpha(isForbidden ? hatchAlpha : 0);
        painter.setPen(QPen(isForbidden ? colours.spike : colours.accent, 1.5));
        painter.setBrush(isForbidden ? QBrush(faint, Qt::BDiagPattern) : QBrush(Qt::NoBrush));
        painter.drawPolygon(outline);
        if (!isForbidden)
            drawTeeth(painter, outline);
        drawZoneName(painter, QString::fromStdString(zone.name), outline, colours);
    }
}

void drawGates(QPainter &painter, const std::vector<Gate> &gates, const FloorToScreen &toScreen,
               const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    for (const Gate &gate : gates) {
        const QLineF line(toScreen(gate.from), toScreen(gate.to));
        const Eigen::Vector2d along = (gate.to - gate.from).normalized();
        const QPointF direction(along.y(), along.x()); // the right side; Y is up on the floor, down on the screen
        const double width = gate.role == GateRole::Split ? 2 : 3.5;
        // A rim, so that the line stands out from any floor and trail.
        painter.setPen(QPen(colours.mapGround, width + 2.5, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(line);
        painter.setPen(QPen(colours.text, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(line);
        painter.setPen(QPen(colours.text, 1.5, Qt::SolidLine, Qt::RoundCap));
        drawArrow(painter, line.pointAt(0.25), direction);
        painter.setBrush(colours.card);
        painter.drawEllipse(line.p1(), postRadius, postRadius);
        painter.drawEllipse(line.p2(), postRadius, postRadius);
        drawName(painter, QString::fromStdString(gate.name), line, colours);
    }
}

} // namespace odo
