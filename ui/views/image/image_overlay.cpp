// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/image/image_overlay.h"

#include "core/geometry/silhouette.h"
#include "ui/models/shown_message.h"
#include "ui/models/trial_scene.h"
#include "ui/views/charts/chart_axis.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/curves/simplified_line.h"
#include "ui/views/widgets/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <QTransform>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double lineWidth = 1.6, casingWidth = 3.6;
const QColor casing(0, 0, 0, 170);

QPainterPath ellipsePath(const Ellipse &ellipse, const ImageMap &map, double scale, double outside)
{
    const QPointF centre = map({ellipse.centrePx.x(), ellipse.centrePx.y()});
    QPainterPath path;
    path.addEllipse(QPointF(0, 0), ellipse.semiMajorPx * scale + outside,
                    ellipse.semiMinorPx * scale + outside);
    QTransform turned;
    turned.translate(centre.x(), centre.y());
    turned.rotate(ellipse.angleRad * 180 / std::numbers::pi);
    return turned.map(path);
}

} // namespace

QPainterPath outlinePath(const Observation &observation, const ImageMap &map, double outside)
{
    const double scale = map({1, 0}).x() - map({0, 0}).x();
    if (!observation.found || scale <= 0)
        return {};
    const std::vector<float> &support = observation.supportPx;
    if (supportPolygon(support, observation.ellipse.centrePx).empty())
        return ellipsePath(observation.ellipse, map, scale, outside);
    std::vector<float> wider;
    for (const float reach : support)
        wider.push_back(reach + float(outside / scale));
    const std::vector<Eigen::Vector2d> corners = supportPolygon(wider, observation.ellipse.centrePx);
    QPolygonF polygon;
    for (const Eigen::Vector2d &corner : corners)
        polygon << map({corner.x(), corner.y()});
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    return path;
}

QPointF paintOutline(QPainter &painter, const Observation &observation, const QString &name,
                     const QColor &colour, const ImageMap &map, bool withLine)
{
    // beside the robot, which may be small, not on it
    const QPainterPath path = outlinePath(observation, map, casingWidth / 2);
    if (path.isEmpty())
        return map({observation.ellipse.centrePx.x(), observation.ellipse.centrePx.y()});
    if (withLine) {
        QPen line(colour, lineWidth, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
        if (observation.touchesBorder)
            line.setDashPattern({3, 2.5});
        painter.strokePath(path, QPen(casing, casingWidth, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
        painter.strokePath(path, line);
    }
    constexpr double clearance = 6; // beside the line
    const QRectF box = path.boundingRect();
    drawTag(painter, QPointF(box.right() + clearance, box.center().y()), name, colour,
            painter.clipBoundingRect());
    return {box.center().x(), box.top() - clearance / 2};
}

namespace {

// On images the colours do not follow the palette: the ground is whatever the camera saw.
const QColor spikeColour(0xfff0803c), rim(0, 0, 0, 120);

std::optional<QPointF> seen(const FloorView &view, const Eigen::Vector2d &point, double heightM,
                            const ImageMap &map)
{
    const auto pixel = view.pixelFromWorld({point.x(), point.y(), heightM});
    if (!pixel)
        return std::nullopt;
    const Intrinsics &image = view.camera().intrinsics();
    // Far outside of the image a long line costs much and shows nothing.
    const double reach = 2.0 * std::max(image.widthPx, image.heightPx);
    if (!pixel->allFinite() || pixel->cwiseAbs().maxCoeff() > 2 * reach)
        return std::nullopt;
    return map(QPointF(pixel->x(), pixel->y()));
}

/// A straight line of the floor; bent by the lens, so in pieces.
QPainterPath floorLine(const FloorView &view, const Eigen::Vector2d &from, const Eigen::Vector2d &to,
                       const ImageMap &map)
{
    constexpr int pieces = 24;
    QPainterPath path;
    bool penDown = false;
    for (int i = 0; i <= pieces; ++i) {
        const auto point = seen(view, from + (to - from) * (double(i) / pieces), 0.0, map);
        if (point && penDown)
            path.lineTo(*point);
        else if (point)
            path.moveTo(*point);
        penDown = point.has_value();
    }
    return path;
}

void strokeWithRim(QPainter &painter, const QPainterPath &path, const QColor &colour, double width)
{
    painter.strokePath(path, QPen(rim, width + 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(path, QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

const Spike *spikeAt(const Profile &profile, Nanoseconds time)
{
    const auto spike = std::find_if(profile.spikes.begin(), profile.spikes.end(),
                                    [time](const Spike &each) { return each.time == time; });
    return spike == profile.spikes.end() ? nullptr : &*spike;
}

void paintSpike(QPainter &painter, const QPointF &top, const QString &reason)
{
    const QPolygonF triangle({top + QPointF(-6, -4), top + QPointF(6, -4), top + QPointF(0, -15)});
    drawTag(painter, top + QPointF(11, -10), reason, spikeColour, painter.clipBoundingRect());
    painter.setPen(QPen(QColor(0, 0, 0, 170), 1));
    painter.setBrush(spikeColour);
    painter.drawPolygon(triangle);
}

} // namespace

void paintFloorGrid(QPainter &painter, const TrialScene &scene, const FloorView &view, const ImageMap &map)
{
    if (!scene.layout || scene.layout->markers.empty())
        return;
    Eigen::AlignedBox2d box;
    for (const Marker &marker : scene.layout->markers)
        box.extend(marker.pointInWorld);
    if (box.sizes().minCoeff() <= 0)
        return;
    constexpr int mostLines = 8;
    QPainterPath lines;
    const double step = niceTicks(0, box.sizes().maxCoeff(), mostLines).step;
    const auto linesAlong = [&](int axis) {
        return static_cast<int>(std::ceil(box.sizes()[axis] / step + 0.5));
    };
    for (int i = 0; i < linesAlong(0); ++i) {
        const double inside = std::min(box.min().x() + i * step, box.max().x());
        lines.addPath(floorLine(view, {inside, box.min().y()}, {inside, box.max().y()}, map));
    }
    for (int i = 0; i < linesAlong(1); ++i) {
        const double inside = std::min(box.min().y() + i * step, box.max().y());
        lines.addPath(floorLine(view, {box.min().x(), inside}, {box.max().x(), inside}, map));
    }
    painter.strokePath(lines, QPen(QColor(255, 255, 255, 70), 1));
}

void paintAxes(QPainter &painter, const TrialScene &scene, const FloorView &view, const ImageMap &map)
{
    if (!scene.layout)
        return;
    const auto origin = scene.marker("O");
    for (const char *label : {"U", "V"}) {
        const auto end = scene.marker(label);
        if (origin && end)
            strokeWithRim(painter, floorLine(view, *origin, *end, map), Qt::white, 1.6);
    }
    const Eigen::Vector2d centre = scene.floorBounds().center();
    const auto middle = seen(view, centre, 0, map);
    for (const Marker &marker : scene.layout->markers) {
        const auto at = seen(view, marker.pointInWorld, 0, map);
        if (!at)
            continue;
        // Labels stand outside of the field, away from its middle.
        QPointF away = middle ? *at - *middle : QPointF(0, 1);
        const double length = std::hypot(away.x(), away.y());
        away = length > 0 ? away * (13 / length) : QPointF(0, 13);
        const QString text = QString::fromStdString(marker.label);
        const QFontMetricsF metrics(painter.font());
        drawHaloText(painter,
                     *at + away + QPointF(-metrics.horizontalAdvance(text) / 2, metrics.capHeight() / 2),
                     text, Qt::white);
    }
}

void paintPath(QPainter &painter, const std::vector<std::optional<Eigen::Vector2d>> &positions,
               double heightM, const FloorView &view, const ImageMap &map, const QColor &colour)
{
    constexpr double tolerancePx = 0.2; // less cannot be seen, and strokes cost by the point
    constexpr double widestPx = 8;
    QPainterPath path;
    const QRectF shown = painter.hasClipping()
                             ? painter.clipBoundingRect().adjusted(-widestPx, -widestPx, widestPx, widestPx)
                             : QRectF();
    SeenLine line(tolerancePx, shown, [&path](const QPolygonF &part) { path.addPolygon(part); });
    for (const auto &position : positions) {
        const auto at = position ? seen(view, *position, heightM, map) : std::nullopt;
        if (at)
            line.add(*at);
        else
            line.end();
    }
    line.end();
    strokeWithRim(painter, path, colour, 1.8);
}

void paintTrail(QPainter &painter, const TrialScene &scene, std::size_t robot, const FloorView &view,
                const ImageMap &map, const QColor &colour)
{
    const auto &analysis = scene.robots[robot].analysis;
    if (!analysis)
        return;
    std::vector<std::optional<Eigen::Vector2d>> positions;
    for (const ProfilePoint &point : analysis->profile.points)
        positions.push_back(point.valid ? std::optional(point.position) : std::nullopt);
    paintPath(painter, positions, analysis->profile.heightM, view, map, colour);
}

bool hasLongTrail(const TrialScene &scene)
{
    constexpr std::size_t most = 1000;
    std::size_t points = 0;
    for (const SceneRobot &robot : scene.robots)
        points += robot.analysis ? robot.analysis->profile.points.size() : 0;
    return points > most;
}

void paintGhost(QPainter &painter, const GhostRobot &ghost, const FloorView &view, const ImageMap &map)
{
    constexpr double usualM = 0.2, usualHeightM = 0.1;
    const double halfLength = ghost.robot->lengthM.value_or(usualM) / 2,
                 halfWidth = ghost.robot->widthM.value_or(usualM) / 2;
    const Eigen::Rotation2Dd turn(ghost.headingRad);
    const double heights[] = {0, ghost.heightM > 0 ? ghost.heightM : usualHeightM};
    QPolygonF faces[2];
    for (std::size_t face = 0; face < 2; ++face)
        for (const Eigen::Vector2d &corner :
             {Eigen::Vector2d(halfLength, halfWidth), Eigen::Vector2d(-halfLength, halfWidth),
              Eigen::Vector2d(-halfLength, -halfWidth), Eigen::Vector2d(halfLength, -halfWidth)}) {
            const auto at = seen(view, ghost.position + turn * corner, heights[face], map);
            if (!at)
                return;
            faces[face].append(*at);
        }
    QColor haze = ghost.colour;
    haze.setAlpha(80);
    painter.setPen(Qt::NoPen);
    painter.setBrush(haze);
    for (const QPolygonF &face : faces)
        painter.drawPolygon(face);
    QPainterPath edges;
    for (const QPolygonF &face : faces) {
        edges.addPolygon(face);
        edges.closeSubpath();
    }
    for (qsizetype i = 0; i < 4; ++i) {
        edges.moveTo(faces[0][i]);
        edges.lineTo(faces[1][i]);
    }
    painter.strokePath(edges, QPen(rim, 3.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(edges, QPen(ghost.colour, 1.6, Qt::DashLine, Qt::RoundCap, Qt::RoundJoin));
    const QRectF box = faces[0].boundingRect().united(faces[1].boundingRect());
    drawTag(painter, QPointF(box.left(), box.bottom() + 14), ghost.name, ghost.colour,
            painter.clipBoundingRect());
}

namespace {

QColor colourOf(const TrialScene &scene, std::size_t robot, const RobotMarkStyle &style)
{
    return style.colour ? *style.colour : colourOnImage(paletteIndices(scene)[robot]);
}

/// Where a robot must be that this view does not show, and why it does not.
void paintHidden(QPainter &painter, const TrialScene &scene, std::size_t view, std::size_t robot,
                 Nanoseconds time, const ImageMap &map, const QColor &colour)
{
    const SceneRobot &its = scene.robots[robot];
    const auto hidden = std::ranges::find_if(its.occlusions, [&](const Occlusion &one) {
        return one.view == scene.views[view].camera && one.span.contains(time);
    });
    const std::ptrdiff_t index =
        hidden == its.occlusions.end() ? -1 : pointIndexAt(its.analysis->profile, time);
    const auto &floorView = scene.views[view].floorView;
    if (index < 0 || !floorView)
        return;
    const Profile &profile = its.analysis->profile;
    if (const auto at = seen(*floorView, profile.points[static_cast<std::size_t>(index)].position,
                             silhouettePlaneM(profile.heightM), map))
        drawTag(painter, *at,
                joinedWords(QString::fromStdString(its.robot.name), shownWords(occlusionWords(*hidden))),
                colour, painter.clipBoundingRect());
}

} // namespace

void paintFloor(QPainter &painter, const TrialScene &scene, std::size_t view, const ImageMap &map,
                const RobotMarkStyle &style)
{
    const auto &floorView = scene.views.at(view).floorView;
    if (!floorView)
        return;
    paintFloorGrid(painter, scene, *floorView, map);
    for (std::size_t robot = 0; robot < scene.robots.size(); ++robot)
        paintTrail(painter, scene, robot, *floorView, map, colourOf(scene, robot, style));
    paintAxes(painter, scene, *floorView, map);
}

void paintRobot(QPainter &painter, const TrialScene &scene, std::size_t view, std::size_t robot,
                std::int64_t frame, const ImageMap &map, const RobotMarkStyle &style)
{
    const Observation *observation = scene.observationAt(view, robot, frame);
    if (!observation) {
        paintHidden(painter, scene, view, robot, scene.timeOf(view, frame), map,
                    colourOf(scene, robot, style));
        return;
    }
    const QPointF top =
        paintOutline(painter, *observation, QString::fromStdString(scene.robots[robot].robot.name),
                     colourOf(scene, robot, style), map, style.withOutlines);
    const auto &analysis = scene.robots[robot].analysis;
    if (!analysis)
        return;
    const Nanoseconds time = scene.timeOf(view, frame);
    const auto first = scene.frameAt(0, time);
    const Nanoseconds sampleTime = first ? scene.frameTimes()[static_cast<std::size_t>(*first)] : time;
    if (const Spike *spike = spikeAt(analysis->profile, sampleTime))
        paintSpike(painter, top, shownWords(reasonAmong(scene.robots[robot].occlusions, *spike)));
}

void drawHaloText(QPainter &painter, const QPointF &baseline, const QString &text, const QColor &colour)
{
    QPainterPath path;
    path.addText(baseline, painter.font(), text);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.strokePath(path, QPen(QColor(0, 0, 0, 150), 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, colour);
    painter.restore();
}

void drawTag(QPainter &painter, const QPointF &leftMiddle, const QString &fullText, const QColor &colour,
             const QRectF &frame)
{
    constexpr double shortest = 160;
    const QFontMetricsF metrics(painter.font());
    const QString text = metrics.elidedText(
        fullText, Qt::ElideRight, std::min(frame.width() - 14, std::max(shortest, frame.width() / 2)));
    QRectF box(leftMiddle.x(), leftMiddle.y() - metrics.height() / 2 - 1,
               metrics.horizontalAdvance(text) + 10, metrics.height() + 2);
    box.moveLeft(std::max(frame.left() + 2, std::min(box.left(), frame.right() - 2 - box.width())));
    box.moveTop(std::max(frame.top() + 2, std::min(box.top(), frame.bottom() - 2 - box.height())));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 24, 28, 190));
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter, text);
}

void drawReadOut(QPainter &painter, const QRectF &frame, const QString &fullText)
{
    constexpr qreal margin = 6;
    const QFontMetricsF metrics(painter.font());
    const QString text = metrics.elidedText(fullText, Qt::ElideRight, frame.width() - 4 * margin);
    QRectF box(QPointF(), QSizeF(metrics.horizontalAdvance(text), metrics.height()));
    box.adjust(-margin, -margin / 2, margin, margin / 2);
    box.moveBottomLeft(frame.bottomLeft() + QPointF(margin, -margin));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 180)); // readable on any floor, in both themes
    painter.drawRoundedRect(box, margin / 2, margin / 2);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
}

QRectF fittedRect(const QSize &imagePx, const QSizeF &widget, double devicePixelRatio)
{
    if (imagePx.isEmpty())
        return {QPointF(0, 0), widget};
    const QSizeF size = QSizeF(imagePx).scaled(widget, Qt::KeepAspectRatio);
    const auto whole = [devicePixelRatio](double length) {
        return std::round(length * devicePixelRatio) / devicePixelRatio;
    };
    return {whole((widget.width() - size.width()) / 2), whole((widget.height() - size.height()) / 2),
            whole(size.width()), whole(size.height())};
}

QPointF fromImagePixel(const QPointF &pixel, const QSize &imagePx, const QRectF &fitted)
{
    return imagePx.isEmpty()
               ? pixel
               : fitted.topLeft() + (pixel + QPointF(0.5, 0.5)) * (fitted.width() / imagePx.width());
}

QPointF toImagePixel(const QPointF &position, const QSize &imagePx, const QRectF &fitted)
{
    return imagePx.isEmpty()
               ? position
               : (position - fitted.topLeft()) * (imagePx.width() / fitted.width()) - QPointF(0.5, 0.5);
}

QImage toImage(ScreenImage &&image)
{
    if (!image.pixels)
        return {};
    auto *owned = new ScreenImage(std::move(image)); // freed by the image's last copy
    return QImage(
        reinterpret_cast<const uchar *>(owned->pixels.get()), owned->width, owned->height,
        owned->width * qsizetype(sizeof(std::uint32_t)), QImage::Format_RGB32,
        [](void *pointer) { delete static_cast<ScreenImage *>(pointer); }, owned);
}

} // namespace odo
