// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/layout_drawing.h"

#include "ui/testbed/floor/floor_drawing.h"
#include "ui/views/theme.h"

#include <QMouseEvent>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace odo {
namespace {

constexpr double leastExtentM = 1, filledPart = 0.7;

} // namespace

LayoutDrawing::LayoutDrawing(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("Markers from above"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void LayoutDrawing::setLayout(const MarkerLayout &layout, int current)
{
    m_layout = layout;
    m_current = current;
    if (!m_dragging) // the ground must not move under the hand
        fit();
    update();
}

void LayoutDrawing::fit()
{
    Eigen::Vector2d lower(0, 0), upper(0, 0); // the axes begin in the origin
    for (const Marker &marker : m_layout.markers) {
        if (!marker.pointInWorld.allFinite())
            continue;
        lower = lower.cwiseMin(marker.pointInWorld);
        upper = upper.cwiseMax(marker.pointInWorld);
    }
    m_middle = 0.5 * (lower + upper);
    const Eigen::Vector2d extent = (upper - lower).cwiseMax(leastExtentM);
    m_pixelsPerMetre = filledPart * std::min(width() / extent.x(), height() / extent.y());
}

QPointF LayoutDrawing::toScreen(const Eigen::Vector2d &point) const
{
    const Eigen::Vector2d from = m_pixelsPerMetre * (point - m_middle);
    return {0.5 * width() + from.x(), 0.5 * height() - from.y()};
}

Eigen::Vector2d LayoutDrawing::toWorld(const QPointF &place) const
{
    return m_middle + Eigen::Vector2d(place.x() - 0.5 * width(), 0.5 * height() - place.y()) / m_pixelsPerMetre;
}

void LayoutDrawing::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.mapGround);
    painter.setPen(colours.mapGrid);
    const Eigen::Vector2d lower = toWorld({0, double(height())}), upper = toWorld({double(width()), 0});
    const std::vector<double> columns = floorGridLines(lower.x(), upper.x());
    for (const double x : columns)
        painter.drawLine(QPointF(toScreen({x, 0}).x(), 0), QPointF(toScreen({x, 0}).x(), height()));
    for (const double y : columns.empty() ? std::vector<double>() : floorGridLines(lower.y(), upper.y()))
        painter.drawLine(QPointF(0, toScreen({0, y}).y()), QPointF(width(), toScreen({0, y}).y()));
    const QPointF origin = toScreen({0, 0});
    const double axis = 46;
    painter.setPen(QPen(colours.text, 1.6));
    painter.drawLine(origin, origin + QPointF(axis, 0));
    painter.drawLine(origin, origin - QPointF(0, axis));
    painter.drawText(origin + QPointF(axis + 4, 4), QStringLiteral("X"));
    painter.drawText(origin + QPointF(-4, -axis - 5), QStringLiteral("Y"));
    for (int i = 0; i < int(m_layout.markers.size()); ++i) {
        const Marker &marker = m_layout.markers[std::size_t(i)];
        if (!marker.pointInWorld.allFinite())
            continue;
        const QPointF at = toScreen(marker.pointInWorld);
        painter.setPen(QPen(i == m_current ? colours.accent : colours.text, i == m_current ? 2.5 : 1));
        painter.setBrush(i == m_current ? colours.card : colours.text);
        painter.drawRect(QRectF(at.x() - 6, at.y() - 6, 12, 12));
        painter.setPen(colours.text);
        painter.drawText(at + QPointF(10, 16), QString::fromStdString(marker.label));
    }
    painter.setPen(colours.muted);
    painter.drawText(rect().adjusted(8, 6, -8, -6), Qt::AlignRight | Qt::AlignBottom,
                     !columns.empty() ? tr("grid %1 m").arg(QLocale().toString(floorGridM)) : QString());
}

void LayoutDrawing::mousePressEvent(QMouseEvent *event)
{
    for (int i = 0; i < int(m_layout.markers.size()); ++i) {
        if (QLineF(toScreen(m_layout.markers[std::size_t(i)].pointInWorld), event->position()).length() >
            floorGrabPx)
            continue;
        m_current = i;
        m_dragging = true;
        Q_EMIT picked(i);
        update();
        return;
    }
}

void LayoutDrawing::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_dragging)
        return;
    Q_EMIT moved(m_current, onDragStep(toWorld(event->position())));
}

void LayoutDrawing::mouseReleaseEvent(QMouseEvent *)
{
    m_dragging = false;
    fit();
    update();
}

void LayoutDrawing::resizeEvent(QResizeEvent *) { fit(); }

} // namespace odo
