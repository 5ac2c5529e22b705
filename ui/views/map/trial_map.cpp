// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/map/trial_map.h"

#include "core/analysis/motion_stretches.h"
#include "core/analysis/quantity_curve.h"
#include "ui/models/number_text.h"
#include "ui/models/scene_uncertainty.h"
#include "ui/models/trial_scene.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/curves/simplified_line.h"
#include "ui/views/map/floor_image.h"
#include "ui/views/map/map_painting.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace odo {

namespace {

constexpr int colourSteps = 48; // more of them cannot be distinguished

class TrailPaintingWords
{
    Q_DECLARE_TR_FUNCTIONS(TrailPainting)
};

constexpr double tolerancePx = 0.2; // less cannot be seen, and strokes cost by the point

/// Between two points next to one another: as the metrics bridge it.
void addCubic(const Profile &profile, const ProfilePiece &piece, const MapPlan &plan, SeenLine &line)
{
    const auto instantOf = [&profile](std::size_t i) {
        return RunInstant{toSeconds(profile.samples[i].time), &profile.points[i]};
    };
    const RunInstant from = instantOf(piece.first), to = instantOf(piece.last);
    if (!(to.timeS > from.timeS))
        return;
    const CubicPath cubic(from, to);
    for (int i = 1; i < CubicPath::parts; ++i) {
        const double part = double(i) / CubicPath::parts;
        line.add(plan.fromWorld({cubic.x.value(part), cubic.y.value(part)}));
    }
}

/// The path of the smoothed positions, in pieces without gaps.
QPainterPath pathOf(const Profile &profile, const std::vector<ProfilePiece> &pieces, const MapPlan &plan,
                    bool bridged)
{
    QPainterPath pathLine;
    SeenLine line(tolerancePx, plan.seen(),
                  [&pathLine](const QPolygonF &part) { pathLine.addPolygon(part); });
    for (const ProfilePiece &piece : pieces) {
        if (piece.isBridged != bridged)
            continue;
        line.add(plan.fromWorld(profile.points[piece.first].position));
        if (piece.last == piece.first + 1)
            addCubic(profile, piece, plan, line);
        for (std::size_t i = piece.first + 1; i <= piece.last; ++i)
            line.add(plan.fromWorld(profile.points[i].position));
        line.end();
    }
    return pathLine;
}

/// A piece of a track, coloured by speed.
void drawColoured(QPainter &painter, const MapPlan &plan, std::span<const ProfilePoint> points, double topMps)
{
    int stretchColour = 0;
    SeenLine stretch(tolerancePx, plan.seen(), [&](const QPolygonF &part) { // of one colour
        painter.setPen(QPen(scaleColour(double(stretchColour) / colourSteps), 3, Qt::SolidLine, Qt::RoundCap,
                            Qt::RoundJoin));
        painter.drawPolyline(part);
    });
    for (const ProfilePoint &point : points) {
        const int colour =
            static_cast<int>(std::lround(topMps > 0 ? colourSteps * point.speedMps / topMps : 0));
        if (colour != stretchColour)
            stretch.cut();
        stretchColour = colour;
        stretch.add(plan.fromWorld(point.position));
    }
    stretch.end();
}

} // namespace

double topSpeedMps(const TrialScene &scene)
{
    double top = 0;
    for (const SceneRobot &robot : scene.robots) {
        if (!robot.analysis)
            continue;
        for (const ProfilePoint &point : robot.analysis->profile.points) {
            if (point.valid)
                top = std::max(top, point.speedMps);
        }
    }
    return top;
}

void drawSpeedTrail(QPainter &painter, const MapPlan &plan, const Profile &profile, double topMps,
                    const QPalette &palette)
{
    const QColor rim = isDark(palette) ? QColor(235, 238, 240, 150) : QColor(25, 30, 35, 110);
    const std::vector<ProfilePiece> pieces = piecesOf(profile);
    painter.strokePath(pathOf(profile, pieces, plan, false),
                       QPen(rim, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(pathOf(profile, pieces, plan, true),
                       QPen(rim, 2.5, Qt::DotLine, Qt::RoundCap, Qt::RoundJoin));
    for (const ProfilePiece &piece : pieces)
        if (!piece.isBridged)
            drawColoured(painter, plan,
                         std::span(profile.points).subspan(piece.first, piece.last + 1 - piece.first),
                         topMps);
}

void drawMapUncertainIntervals(QPainter &painter, const MapPlan &plan, const TrialScene &scene,
                               const QPalette &palette)
{
    constexpr double width = 14;
    QColor haze = ThemeColours::of(palette).muted;
    haze.setAlpha(90);
    for (const UncertainInterval &one : uncertainIntervals(scene)) {
        const Profile &profile = scene.robots[one.robot].analysis->profile;
        painter.setPen(QPen(haze, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        SeenLine pathLine(tolerancePx, plan.seen(),
                          [&painter](const QPolygonF &part) { painter.drawPolyline(part); });
        for (auto i = std::ranges::lower_bound(profile.samples, one.span.begin, {}, &Sample::time) -
                      profile.samples.begin();
             i < std::ssize(profile.points) && profile.samples[std::size_t(i)].time <= one.span.end; ++i)
            if (profile.points[std::size_t(i)].valid && one.kind == UncertainInterval::Kind::Gap)
                painter.drawPoint(plan.fromWorld(profile.points[std::size_t(i)].position));
            else if (profile.points[std::size_t(i)].valid)
                pathLine.add(plan.fromWorld(profile.points[std::size_t(i)].position));
        pathLine.end();
    }
}

void drawMapSpikes(QPainter &painter, const MapPlan &plan, const Profile &profile, const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    painter.setPen(QPen(colours.card, 1));
    painter.setBrush(colours.spike);
    for (const Spike &spike : profile.spikes) {
        const auto index = static_cast<std::size_t>(spike.sampleIndex);
        if (index >= profile.samples.size())
            continue;
        const auto &measured = profile.samples[index].position;
        if (!measured && !profile.points[index].valid)
            continue;
        const QPointF at = plan.fromWorld(measured ? *measured : profile.points[index].position);
        const QPointF triangle[] = {at + QPointF(-6, 5), at + QPointF(6, 5), at + QPointF(0, -6)};
        painter.drawConvexPolygon(triangle, 3);
    }
}

void drawScaleLegend(QPainter &painter, const MapPlan &plan, const QString &words, const QPalette &palette)
{
    constexpr int barWidth = 76, barHeight = 7;
    const double left = 12, middle = plan.size.height() - MapPlan::footHeight / 2.0 + 1;
    const ThemeColours colours = ThemeColours::of(palette);
    QLinearGradient gradient(left, 0, left + barWidth, 0);
    for (int i = 0; i <= 8; ++i)
        gradient.setColorAt(i / 8.0, scaleColour(i / 8.0));
    painter.setPen(QPen(colours.border, 1));
    painter.setBrush(gradient);
    painter.drawRect(QRectF(left, middle - barHeight / 2.0, barWidth, barHeight));
    painter.setPen(colours.muted);
    painter.drawText(QPointF(left + barWidth + 7, middle + QFontMetricsF(painter.font()).capHeight() / 2),
                     words);
}

void drawSpeedLegend(QPainter &painter, const MapPlan &plan, double topMps, const QPalette &palette)
{
    if (topMps <= 0)
        return;
    const ShownUnit &speed = shownUnits().speed;
    const double top = speed.perSi * topMps;
    drawScaleLegend(
        painter, plan,
        TrailPaintingWords::tr("0 to %1 %2").arg(QLocale().toString(top, 'f', top < 1 ? 2 : 1), speed.name),
        palette);
}

void drawMapFloor(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const FloorImage &floor,
                  double opacity, const QPalette &palette)
{
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!floor.image.isNull()) {
        painter.setOpacity(opacity);
        painter.drawImage(QRectF(plan.fromWorld({floor.extent.min().x(), floor.extent.max().y()}),
                                 plan.fromWorld({floor.extent.max().x(), floor.extent.min().y()})),
                          floor.image);
        painter.setOpacity(1);
    }
    drawMapFoot(painter, plan, palette);
    drawMapGrid(painter, plan, palette, !floor.image.isNull());
    if (scene.layout)
        drawMapMarkers(painter, plan, *scene.layout, palette);
    if (scene.task)
        drawZones(
            painter, scene.task->zones,
            [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); }, palette);
}

void drawMapGround(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const FloorImage &floor,
                   const QPalette &palette)
{
    constexpr double muted = 0.55; // the trail comes first
    drawMapFloor(painter, plan, scene, floor, muted, palette);
    if (scene.task)
        drawReferencePath(
            painter, scene.task->path,
            [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); }, palette);
    drawMapUncertainIntervals(painter, plan, scene, palette);
}

void drawMapMarks(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const QPalette &palette)
{
    if (scene.task)
        drawGates(
            painter, scene.task->gates,
            [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); }, palette);
    for (const SceneRobot &robot : scene.robots) {
        if (robot.analysis)
            drawMapSpikes(painter, plan, robot.analysis->profile, palette);
    }
}

void drawTrialRobots(QPainter &painter, const MapPlan &plan, const TrialScene &scene, Nanoseconds time,
                     const QPalette &palette)
{
    const bool alone = scene.robots.size() == 1;
    const std::vector<int> positions = paletteIndices(scene);
    for (std::size_t robot = 0; robot < scene.robots.size(); ++robot) {
        const SceneRobot &shown = scene.robots[robot];
        if (!shown.analysis)
            continue;
        const Profile &profile = partAt(*shown.analysis, time);
        const std::ptrdiff_t index = pointIndexAt(profile, time);
        if (index < 0)
            continue;
        const ProfilePoint &point = profile.points[static_cast<std::size_t>(index)];
        MapRobot sign{&shown.robot,
                      point.position,
                      point.sigmaXM,
                      point.sigmaYM,
                      drivenHeadingAt(profile, index),
                      &profile != &shown.analysis->profile ? ThemeColours::of(palette).muted
                      : alone
                          ? drawnColour(shown.robot.drawingColour, ThemeColours::of(palette).spike, palette)
                          : seriesColour(positions[robot], palette),
                      {},
                      scene.referenceM(robot)};
        if (!alone)
            sign.label = QString::fromStdString(shown.robot.name);
        drawMapRobot(painter, plan, sign, palette);
    }
}

namespace {

constexpr double gateHalfPx = 17, closestPx = 0.8;
constexpr int mostDashed = 20000; // points of a way

QPainterPath runPathOf(const Profile &profile, const MapPlan &plan)
{
    QPainterPath pathLine;
    std::size_t next = 0;
    QPointF last;
    for (const ProfilePiece &piece : piecesOf(profile)) {
        for (std::size_t i = piece.first; i <= piece.last; ++i) {
            const QPointF at = plan.fromWorld(profile.points[i].position);
            if (i == piece.first && (next == 0 || piece.first != next))
                pathLine.moveTo(at);
            else if (QLineF(last, at).length() < closestPx)
                continue;
            else
                pathLine.lineTo(at);
            last = at;
        }
        next = piece.last;
    }
    return pathLine;
}

} // namespace

void drawPaths(QPainter &painter, const MapPlan &plan, const ComparisonScene &scene,
               const std::vector<std::size_t> &runs, const QPalette &palette)
{
    for (auto each = runs.rbegin(); each != runs.rend(); ++each) {
        const std::size_t run = *each;
        const QPainterPath pathLine = runPathOf(scene.profile(run), plan);
        // Dashes of a very long way take long to paint, and cover one another.
        const Qt::PenStyle dash = pathLine.elementCount() < mostDashed ? seriesDash(int(run)) : Qt::SolidLine;
        QColor rim = ThemeColours::of(palette).mapGround;
        rim.setAlpha(170);
        painter.strokePath(pathLine, QPen(rim, 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.strokePath(pathLine,
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
