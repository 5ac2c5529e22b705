// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/floor_sketch.h"

#include "ui/models/number_text.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/theme.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>

namespace odo {
namespace {

constexpr double borderPx = 34, markerSidePx = 8;
constexpr double axisM = 0.4;

Eigen::AlignedBox2d boundsOf(const std::optional<MarkerLayout> &layout,
                             const std::vector<SketchedCamera> &cameras,
                             const std::optional<SketchedAccuracy> &accuracy)
{
    Eigen::AlignedBox2d box;
    if (layout)
        for (const Marker &marker : layout->markers)
            box.extend(marker.pointInWorld);
    for (const SketchedCamera &camera : cameras)
        box.extend(Eigen::Vector2d(camera.pointInWorld.head<2>()));
    if (accuracy && accuracy->grid.columns > 0) {
        box.extend(accuracy->grid.lowerM);
        box.extend(accuracy->grid.at(accuracy->grid.columns - 1, accuracy->grid.rows - 1));
    }
    if (box.isEmpty())
        box = Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1));
    return box;
}

Eigen::Vector2d footOf(const SketchedCamera &camera)
{
    return camera.pointInWorld.head<2>();
}

} // namespace

FloorSketch::FloorSketch(QWidget *parent) : QWidget(parent)
{
    setMinimumSize(220, 180);
    setAccessibleName(tr("Sketch of the testbed from above"));
}

void FloorSketch::setTestbed(std::optional<MarkerLayout> layout, std::vector<SketchedCamera> cameras)
{
    m_layout = std::move(layout);
    m_cameras = std::move(cameras);
    setAccessibleDescription(
        tr("%1 markers, %2 cameras").arg(m_layout ? m_layout->markers.size() : 0).arg(m_cameras.size()));
    fit();
}

void FloorSketch::setAccuracy(std::optional<SketchedAccuracy> accuracy)
{
    m_accuracy = std::move(accuracy);
    fit();
}

/// The same scale on both axes, X to the right, Y up.
void FloorSketch::fit()
{
    update();
    if (m_held != Held::Nothing) // the ground must not move under the hand
        return;
    const Eigen::AlignedBox2d box = boundsOf(m_layout, m_cameras, m_accuracy);
    const Eigen::Vector2d extent = box.sizes().cwiseMax(0.1), centre = box.center();
    // The key must not hide a camera: it has a strip of its own, beneath or on the left, wherever that leaves
    // more room.
    const QSizeF all(width(), height()), key = m_accuracy ? accuracyKeySize(fontMetrics()) : QSize(0, 0);
    const auto scaleIn = [&](const QSizeF &room) {
        return std::max(1.0, std::min((room.width() - 2 * borderPx) / extent.x(),
                                      (room.height() - 2 * borderPx) / extent.y()));
    };
    const QSizeF above(all.width(), all.height() - key.height()),
        beside(all.width() - key.width(), all.height());
    const bool isBeside = scaleIn(beside) > scaleIn(above);
    const QSizeF room = isBeside ? beside : above;
    m_pixelsPerMetre = scaleIn(room);
    const double left = isBeside ? key.width() : 0;
    m_origin = {left + room.width() / 2 - centre.x() * m_pixelsPerMetre,
                room.height() / 2 + centre.y() * m_pixelsPerMetre};
}

QPointF FloorSketch::fromWorld(const Eigen::Vector2d &point) const
{
    return m_origin + QPointF(point.x(), -point.y()) * m_pixelsPerMetre;
}

bool FloorSketch::paintGrid(QPainter &painter) const
{
    painter.setPen(QPen(ThemeColours::of(palette()).mapGrid, 1));
    const double left = -m_origin.x() / m_pixelsPerMetre, right = (width() - m_origin.x()) / m_pixelsPerMetre;
    const double bottom = (m_origin.y() - height()) / m_pixelsPerMetre, top = m_origin.y() / m_pixelsPerMetre;
    const std::vector<double> columns = floorGridLines(left, right), rows = floorGridLines(bottom, top);
    for (const double x : columns)
        painter.drawLine(QPointF(fromWorld({x, 0}).x(), 0), QPointF(fromWorld({x, 0}).x(), height()));
    for (const double y : rows)
        painter.drawLine(QPointF(0, fromWorld({0, y}).y()), QPointF(width(), fromWorld({0, y}).y()));
    return !columns.empty() && !rows.empty();
}

void FloorSketch::paintCamera(QPainter &painter, const SketchedCamera &camera, const QColor &colour) const
{
    constexpr double halfAngle = 0.42, wedgePx = 46;
    const QPointF position = fromWorld(footOf(camera)), aim = fromWorld(camera.lookAtInWorld);
    const double angle = std::atan2(aim.y() - position.y(), aim.x() - position.x());
    const auto corner = [&](double by) {
        return position + wedgePx * QPointF(std::cos(angle + by), std::sin(angle + by));
    };
    QColor ground = colour;
    ground.setAlphaF(0.22f);
    painter.setPen(QPen(colour, 1, camera.isPlanned ? Qt::DashLine : Qt::SolidLine));
    painter.setBrush(ground);
    painter.drawPolygon(QPolygonF{position, corner(-halfAngle), corner(halfAngle)});
    if (camera.isPlanned) {
        painter.drawLine(position, aim);
        for (const auto &[pen, width] : {std::pair(QColor(Qt::white), 4.0), std::pair(colour, 2.0)}) {
            painter.setPen(QPen(pen, width));
            painter.drawLine(aim - QPointF(7, 0), aim + QPointF(7, 0));
            painter.drawLine(aim - QPointF(0, 7), aim + QPointF(0, 7));
        }
    }
    painter.setPen(QPen(colour, 2));
    painter.setBrush(camera.isPlanned ? ThemeColours::of(palette()).card : colour);
    painter.drawEllipse(position, 6, 6);
    painter.setPen(ThemeColours::of(palette()).text);
    const QString text =
        tr("%1, %2 m high").arg(camera.name, QLocale().toString(camera.pointInWorld.z(), 'f', 2));
    QRectF box = painter.fontMetrics().boundingRect(text);
    box.moveCenter(position + QPointF(0, 17));
    box.moveLeft(std::clamp(box.left(), 4.0, std::max(4.0, width() - box.width() - 4)));
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
}

void FloorSketch::paintMarkers(QPainter &painter) const
{
    const ThemeColours colours = ThemeColours::of(palette());
    const bool onMap = m_accuracy.has_value(); // whose colours are dark and bright: rims are read on both
    const QColor ink = onMap ? QColor(Qt::white) : colours.text;
    const auto text = [&](const QPointF &at, const QString &words) {
        if (onMap)
            return drawHaloText(painter, at, words, ink);
        painter.setPen(ink);
        painter.drawText(at, words);
    };
    for (const auto &[colour, width] :
         {std::pair(QColor(0, 0, 0, onMap ? 160 : 0), 4.0), std::pair(ink, 1.6)}) {
        painter.setPen(QPen(colour, width));
        painter.drawLine(fromWorld({0, 0}), fromWorld({axisM, 0}));
        painter.drawLine(fromWorld({0, 0}), fromWorld({0, axisM}));
    }
    text(fromWorld({axisM, 0}) + QPointF(4, 4), QStringLiteral("X"));
    text(fromWorld({0, axisM}) + QPointF(-4, -5), QStringLiteral("Y"));
    if (!m_layout)
        return;
    for (const Marker &marker : m_layout->markers) {
        const QPointF position = fromWorld(marker.pointInWorld);
        const QRectF square(position - QPointF(markerSidePx, markerSidePx) / 2,
                            QSizeF(markerSidePx, markerSidePx));
        painter.fillRect(square.adjusted(-1, -1, 1, 1), onMap ? QColor(Qt::black) : ink);
        painter.fillRect(square, ink);
        text(position + QPointF(8, 14), QString::fromStdString(marker.label));
    }
}

void FloorSketch::paintEvent(QPaintEvent *)
{
    const ThemeColours colours = ThemeColours::of(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), colours.mapGround);
    if (!m_layout && m_cameras.empty()) {
        painter.setPen(colours.muted);
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("This sketch shows markers and cameras once the testbed has a layout or a "
                            "registered camera."));
        return;
    }
    const bool hasGrid = paintGrid(painter);
    if (m_accuracy)
        drawAccuracy(
            painter, *m_accuracy, [this](const Eigen::Vector2d &point) { return fromWorld(point); },
            palette());
    paintMarkers(painter);
    for (std::size_t i = 0; i < m_cameras.size(); ++i)
        paintCamera(painter, m_cameras[i], seriesColour(static_cast<int>(i), palette()));
    painter.setPen(colours.muted);
    painter.drawText(rect().adjusted(8, 4, -8, -4), Qt::AlignRight | Qt::AlignBottom,
                     hasGrid ? tr("grid %1 m").arg(QLocale().toString(floorGridM)) : QString());
    if (m_accuracy)
        drawAccuracyKey(painter, *m_accuracy, rect(), palette());
}

void FloorSketch::resizeEvent(QResizeEvent *)
{
    fit();
}

void FloorSketch::mousePressEvent(QMouseEvent *event)
{
    for (std::size_t i = 0; i < m_cameras.size(); ++i) {
        if (!m_cameras[i].isPlanned)
            continue;
        const auto isNear = [&](const Eigen::Vector2d &point) {
            return QLineF(fromWorld(point), event->position()).length() <= floorGrabPx;
        };
        m_held = isNear(footOf(m_cameras[i]))         ? Held::Camera
                 : isNear(m_cameras[i].lookAtInWorld) ? Held::Aim
                                                      : Held::Nothing;
        if (m_held == Held::Nothing)
            continue;
        m_heldCamera = static_cast<int>(i);
        Q_EMIT picked(m_heldCamera);
        return;
    }
}

void FloorSketch::mouseMoveEvent(QMouseEvent *event)
{
    if (m_held == Held::Nothing)
        return;
    const QPointF from = (event->position() - m_origin) / m_pixelsPerMetre;
    const Eigen::Vector2d position = onDragStep({from.x(), -from.y()});
    if (m_held == Held::Camera)
        Q_EMIT cameraDragged(m_heldCamera, position);
    else
        Q_EMIT aimDragged(m_heldCamera, position);
}

void FloorSketch::mouseReleaseEvent(QMouseEvent *)
{
    m_held = Held::Nothing;
    fit();
}

} // namespace odo
