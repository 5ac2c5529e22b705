// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/map/map_painting.h"

#include "ui/models/number_text.h"
#include "ui/views/charts/chart_axis.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFontMetricsF>
#include <QLineF>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPolygonF>
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

/// Heading to the right, where the arm is longer if the heading is known. The halo keeps it apart from any
/// footprint and floor.
void drawReferenceCross(QPainter &painter, bool isHeadingKnown, const ThemeColours &colours)
{
    constexpr double arm = 5;
    const double forwardArm = isHeadingKnown ? 9 : arm;
    for (const QPen &pen : {QPen(colours.card, 4.5, Qt::SolidLine, Qt::RoundCap),
                            QPen(colours.text, 1.8, Qt::SolidLine, Qt::RoundCap)}) {
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
    return zoom *
           std::min(wide / std::max(1e-6, bounds.sizes().x()), high / std::max(1e-6, bounds.sizes().y()));
}

double MapPlan::mostZoom() const
{
    constexpr double mostPxPerM = 4000;
    return std::max(1.0, zoom * mostPxPerM / scalePx());
}

QRectF MapPlan::seen() const
{
    constexpr double widestPx = 16;
    return QRectF(QPointF(0, 0), size).adjusted(-widestPx, -widestPx, widestPx, widestPx);
}

QPointF MapPlan::fromWorld(const Eigen::Vector2d &point) const
{
    const Eigen::Vector2d apart = (point - bounds.center()) * scalePx();
    const QPointF middle(size.width() / 2.0,
                         topMargin + (size.height() - topMargin - footHeight - sideMargin) / 2.0);
    return zoom * middle + shift + QPointF(apart.x(), -apart.y());
}

Eigen::Vector2d MapPlan::toWorld(const QPointF &position) const
{
    const QPointF apart = position - fromWorld(bounds.center());
    return bounds.center() + Eigen::Vector2d(apart.x(), -apart.y()) / scalePx();
}

void drawMapGrid(QPainter &painter, const MapPlan &plan, const QPalette &palette, bool overImage)
{
    const ThemeColours colours = ThemeColours::of(palette);
    const ShownUnit &unit = shownUnits().distance;
    const AxisTicks ticks = niceTicks(0, unit.perSi * plan.bounds.sizes().maxCoeff() / plan.zoom, 7);
    const double step = ticks.step / unit.perSi;
    painter.setRenderHint(QPainter::Antialiasing, false);
    QColor line = overImage ? colours.muted : colours.mapGrid;
    if (overImage)
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
    const QString words = MapPaintingWords::tr("grid %1 %2").arg(ticks.label(ticks.step), unit.name);
    const QFontMetrics metrics = painter.fontMetrics();
    const int ofLegend = 110 + 14 * metrics.averageCharWidth(); // the scale of speeds comes first
    if (metrics.horizontalAdvance(words) + ofLegend > plan.size.width())
        return;
    painter.drawText(
        QRectF(0, plan.size.height() - MapPlan::footHeight, plan.size.width() - 10, MapPlan::footHeight - 6),
        Qt::AlignRight | Qt::AlignBottom, words);
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
    const QPointF centre =
        hasFootprint(robot) ? scale * QPointF(-robot.referenceM.x(), robot.referenceM.y()) : QPointF();
    painter.drawPath(robotSign(robot, scale).translated(centre));
    if (!robot.referenceM.isZero())
        drawReferenceCross(painter, robot.headingRad.has_value(), colours);
    painter.restore();
    if (robot.label.isEmpty())
        return;
    painter.setPen(colours.text);
    painter.drawText(at + QPointF(dotRadius + 9, -dotRadius), robot.label);
}

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
    const QString length = locale.toString(toMillimetres(*m_robot.lengthM), 'f', 0),
                  width = locale.toString(toMillimetres(*m_robot.widthM), 'f', 0);
    return m_isSizeGiven ? tr("%1 × %2 mm").arg(length, width)
                         : tr("No size given. Drawn as %1 × %2 mm").arg(length, width);
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
    painter.drawText(QRectF(rect()).adjusted(margin, 0, -margin, -margin),
                     Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, words());
}

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
    const double left = outwards.dx() > 0.5    ? middle.x()
                        : outwards.dx() < -0.5 ? middle.x() - wide
                                               : middle.x() - wide / 2;
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
void drawZoneName(QPainter &painter, const QString &name, const QPolygonF &outline,
                  const ThemeColours &colours)
{
    const QPointF top = *std::ranges::min_element(
        outline, {}, [](const QPointF &corner) { return corner.y() + 0.01 * corner.x(); });
    const QFontMetricsF metrics(painter.font());
    const QString shown =
        metrics.elidedText(name, Qt::ElideRight, std::max(80.0, outline.boundingRect().width() - 12));
    const QPointF base(top.x() + 6, top.y() + metrics.ascent() + 4);
    QColor ground = colours.mapGround;
    ground.setAlpha(190);
    painter.fillRect(QRectF(base.x() - 3, base.y() - metrics.ascent(), metrics.horizontalAdvance(shown) + 6,
                            metrics.height()),
                     ground);
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

void drawZones(QPainter &painter, const std::vector<Zone> &zones, const FloorToScreen &toScreen,
               const QPalette &palette)
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
        // the right side; Y is up on the floor, down on the screen
        const QPointF direction(along.y(), along.x());
        const double width = gate.role == GateRole::Split ? 2 : 3.5;
        // A rim, to contrast with any floor and trail.
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

MapCanvas::MapCanvas(QWidget *parent) : QWidget(parent)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void MapCanvas::drawStill(QPainter &painter)
{
    m_still.paint(painter, *this, ThemeColours::of(palette()).mapGround,
                  [this](QPainter &still) { paintStill(still); });
}

void MapCanvas::addToStill(const std::function<void(QPainter &)> &paint)
{
    m_still.add(*this, paint);
}

void MapCanvas::forgetStill()
{
    m_still.forget();
    update();
}

void MapCanvas::resizeEvent(QResizeEvent *)
{
    m_still.forget();
}

void MapCanvas::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        m_still.forget();
    QWidget::changeEvent(event);
}

} // namespace odo
