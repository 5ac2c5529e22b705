// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor_sketch.h"

#include "ui/models/figure_text.h"
#include "ui/views/theme.h"

#include <Eigen/Geometry>
#include <QPainter>
#include <cmath>

namespace odo {
namespace {

constexpr double gridM = 0.5;
constexpr double borderPx = 34;
constexpr double markerSidePx = 8;
constexpr double axisM = 0.4;

/// World metres to widget pixels: X to the right, Y up, the same scale on both.
struct Sheet
{
    Eigen::AlignedBox2d world;
    double scale = 1;
    QPointF origin; ///< of the world

    Sheet(const Eigen::AlignedBox2d &box, const QSizeF &size) : world(box)
    {
        const Eigen::Vector2d extent = box.sizes().cwiseMax(0.1);
        scale = std::max(1.0, std::min((size.width() - 2 * borderPx) / extent.x(),
                                       (size.height() - 2 * borderPx) / extent.y()));
        const Eigen::Vector2d centre = box.center();
        origin = {size.width() / 2 - centre.x() * scale, size.height() / 2 + centre.y() * scale};
    }
    QPointF at(const Eigen::Vector2d &point) const { return origin + QPointF(point.x(), -point.y()) * scale; }
};

Eigen::AlignedBox2d boundsOf(const std::optional<MarkerLayout> &layout,
                             const std::vector<SketchedCamera> &cameras)
{
    Eigen::AlignedBox2d box;
    if (layout)
        for (const Marker &marker : layout->markers)
            box.extend(marker.pointInWorld);
    for (const SketchedCamera &camera : cameras)
        box.extend(Eigen::Vector2d(camera.pointInWorld.head<2>()));
    if (box.isEmpty())
        box = Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1));
    return box;
}

void drawGrid(QPainter &painter, const Sheet &sheet, const QSize &size, const ThemeColours &colours)
{
    painter.setPen(QPen(colours.mapGrid, 1));
    const double left = -sheet.origin.x() / sheet.scale,
                 right = (size.width() - sheet.origin.x()) / sheet.scale;
    const double bottom = (sheet.origin.y() - size.height()) / sheet.scale,
                 top = sheet.origin.y() / sheet.scale;
    for (double x = std::ceil(left / gridM) * gridM; x <= right; x += gridM)
        painter.drawLine(QPointF(sheet.at({x, 0}).x(), 0), QPointF(sheet.at({x, 0}).x(), size.height()));
    for (double y = std::ceil(bottom / gridM) * gridM; y <= top; y += gridM)
        painter.drawLine(QPointF(0, sheet.at({0, y}).y()), QPointF(size.width(), sheet.at({0, y}).y()));
}

void drawAxes(QPainter &painter, const Sheet &sheet, const ThemeColours &colours)
{
    painter.setPen(QPen(colours.text, 1.6));
    painter.drawLine(sheet.at({0, 0}), sheet.at({axisM, 0}));
    painter.drawLine(sheet.at({0, 0}), sheet.at({0, axisM}));
    painter.drawText(sheet.at({axisM, 0}) + QPointF(4, 4), QStringLiteral("X"));
    painter.drawText(sheet.at({0, axisM}) + QPointF(-4, -5), QStringLiteral("Y"));
}

void drawCamera(QPainter &painter, const Sheet &sheet, const SketchedCamera &camera, const QColor &colour)
{
    constexpr double halfAngle = 0.42, wedgePx = 46;
    const QPointF place = sheet.at(Eigen::Vector2d(camera.pointInWorld.head<2>()));
    const QPointF aim = sheet.at(camera.lookAtInWorld) - place;
    const double angle = std::atan2(aim.y(), aim.x());
    const auto corner = [&](double by) {
        return place + wedgePx * QPointF(std::cos(angle + by), std::sin(angle + by));
    };
    QColor ground = colour;
    ground.setAlphaF(0.22f);
    painter.setPen(QPen(colour, 1));
    painter.setBrush(ground);
    painter.drawPolygon(QPolygonF{place, corner(-halfAngle), corner(halfAngle)});
    painter.setBrush(colour);
    painter.drawEllipse(place, 5, 5);
}

void drawCameraName(QPainter &painter, const Sheet &sheet, const SketchedCamera &camera, const QRect &area)
{
    const QPointF place = sheet.at(Eigen::Vector2d(camera.pointInWorld.head<2>()));
    const QString text = FloorSketch::tr("%1, %2 m high")
                             .arg(camera.name, QLocale().toString(camera.pointInWorld.z(), 'f', 2));
    QRectF box = painter.fontMetrics().boundingRect(text);
    box.moveCenter(place + QPointF(0, 17));
    box.moveLeft(std::clamp(box.left(), 4.0, std::max(4.0, area.width() - box.width() - 4)));
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
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
    update();
}

void FloorSketch::paintEvent(QPaintEvent *)
{
    const ThemeColours colours = ThemeColours::of(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), colours.mapGround);
    if (!m_layout && m_cameras.empty()) {
        painter.setPen(colours.muted);
        painter.drawText(
            rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
            tr("Markers and cameras are drawn here once there is a layout or a registered camera."));
        return;
    }
    const Sheet sheet(boundsOf(m_layout, m_cameras), size());
    drawGrid(painter, sheet, size(), colours);
    for (std::size_t i = 0; i < m_cameras.size(); ++i)
        drawCamera(painter, sheet, m_cameras[i], seriesColour(static_cast<int>(i), palette()));
    drawAxes(painter, sheet, colours);
    painter.setPen(colours.text);
    if (m_layout) {
        for (const Marker &marker : m_layout->markers) {
            const QPointF place = sheet.at(marker.pointInWorld);
            painter.fillRect(
                QRectF(place - QPointF(markerSidePx, markerSidePx) / 2, QSizeF(markerSidePx, markerSidePx)),
                colours.text);
            painter.drawText(place + QPointF(8, 14), QString::fromStdString(marker.label));
        }
    }
    for (const SketchedCamera &camera : m_cameras)
        drawCameraName(painter, sheet, camera, rect());
    painter.setPen(colours.muted);
    painter.drawText(rect().adjusted(8, 4, -8, -4), Qt::AlignRight | Qt::AlignBottom, tr("grid 0.5 m"));
}

} // namespace odo
