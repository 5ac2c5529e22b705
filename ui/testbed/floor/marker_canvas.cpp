// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/marker_canvas.h"

#include "ui/testbed/floor/floor_camera.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

const QColor markerColour(86, 180, 233), currentColour(240, 228, 66), gridColour(255, 255, 255, 90),
    axisColour(255, 255, 255, 220);
constexpr double keyStepPx = 0.1, largeKeyStepPx = 1, leapPx = 20;
constexpr double magnifierPx = 132, magnification = 5;
constexpr int piecesOfALine = 24; // a straight line of the floor is bent by the lens

} // namespace

MarkerCanvas::MarkerCanvas(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setAccessibleName(tr("Image with the markers; arrow keys move the selected one"));
}

void MarkerCanvas::setImage(const QImage &image, QSize size)
{
    m_image = image;
    m_size = size;
    update();
}

void MarkerCanvas::setMarkers(std::vector<MarkerPixel> markers)
{
    m_markers = std::move(markers);
    update();
}

void MarkerCanvas::setCurrent(const QString &label)
{
    m_current = label;
    update();
}

void MarkerCanvas::setFloor(const std::optional<FloorView> &view, const MarkerLayout &layout)
{
    m_view = view;
    m_layout = layout;
    update();
}

void MarkerCanvas::setJoined(bool joined)
{
    m_joined = joined;
    update();
}

void MarkerCanvas::setEmptyText(const QString &text)
{
    m_emptyText = text;
    update();
}

QRectF MarkerCanvas::imageRect() const
{
    const QSizeF room = QSizeF(m_size).scaled(size(), Qt::KeepAspectRatio);
    return QRectF(QPointF(0.5 * (width() - room.width()), 0.5 * (height() - room.height())), room);
}

/// Pixel (0,0) is the centre of the first.
QPointF MarkerCanvas::fromPixel(const Eigen::Vector2d &pixel) const
{
    const QRectF position = imageRect();
    return position.topLeft() + QPointF((pixel.x() + 0.5) * position.width() / m_size.width(),
                                        (pixel.y() + 0.5) * position.height() / m_size.height());
}

Eigen::Vector2d MarkerCanvas::toPixel(const QPointF &position) const
{
    const QRectF shown = imageRect();
    const Eigen::Vector2d pixel((position.x() - shown.x()) * m_size.width() / shown.width() - 0.5,
                                (position.y() - shown.y()) * m_size.height() / shown.height() - 0.5);
    return pixel.cwiseMax(0).cwiseMin(Eigen::Vector2d(m_size.width() - 1, m_size.height() - 1));
}

MarkerPixel *MarkerCanvas::markerAt(const QPointF &position)
{
    MarkerPixel *nearest = nullptr;
    double distance = floorGrabPx;
    for (MarkerPixel &marker : m_markers) {
        const double away = QLineF(fromPixel(marker.pixel), position).length();
        if (away < distance) {
            nearest = &marker;
            distance = away;
        }
    }
    return nearest;
}

MarkerPixel *MarkerCanvas::current()
{
    const auto found = std::ranges::find(m_markers, m_current.toStdString(), &MarkerPixel::label);
    return found == m_markers.end() ? nullptr : &*found;
}

void MarkerCanvas::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.imageBackground);
    if (m_image.isNull()) {
        painter.setPen(colours.muted);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
        return;
    }
    painter.drawImage(imageRect(), m_image);
    painter.save();
    painter.setClipRect(imageRect());
    paintFloor(painter);
    paintMarkers(painter);
    painter.restore();
    if (m_dragging || m_movedByKeys)
        paintMagnifier(painter);
    if (hasFocus()) {
        painter.setPen(QPen(colours.accent, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void MarkerCanvas::paintFloor(QPainter &painter) const
{
    if (!m_view || m_layout.markers.empty())
        return;
    Eigen::Vector2d lower = m_layout.markers.front().pointInWorld, upper = lower;
    for (const Marker &marker : m_layout.markers) {
        lower = lower.cwiseMin(marker.pointInWorld);
        upper = upper.cwiseMax(marker.pointInWorld);
    }
    const auto line = [&](const Eigen::Vector2d &from, const Eigen::Vector2d &to, const QPen &pen) {
        QPolygonF points;
        for (int i = 0; i <= piecesOfALine; ++i) {
            const Eigen::Vector2d at = from + (to - from) * i / piecesOfALine;
            if (const auto pixel = m_view->pixelFromWorld({at.x(), at.y(), 0}))
                points << fromPixel(*pixel);
        }
        painter.setPen(pen);
        painter.drawPolyline(points);
    };
    for (const double x : floorGridLines(lower.x(), upper.x()))
        line({x, lower.y()}, {x, upper.y()}, QPen(gridColour, 1));
    for (const double y : floorGridLines(lower.y(), upper.y()))
        line({lower.x(), y}, {upper.x(), y}, QPen(gridColour, 1));
    const double reach = 0.35 * (upper - lower).maxCoeff();
    for (const auto &[axis, name] : {std::pair(Eigen::Vector2d(reach, 0), QStringLiteral("X")),
                                     std::pair(Eigen::Vector2d(0, reach), QStringLiteral("Y"))}) {
        line({0, 0}, axis, QPen(QColor(0, 0, 0, 150), 5));
        line({0, 0}, axis, QPen(axisColour, 2.5));
        if (const auto end = m_view->pixelFromWorld({axis.x(), axis.y(), 0}))
            drawHaloText(painter, fromPixel(*end) + QPointF(6, 4), name, Qt::white);
    }
}

void MarkerCanvas::paintMarkers(QPainter &painter) const
{
    for (const auto &[colour, width] :
         {std::pair(QColor(0, 0, 0, 150), 5.0), std::pair(QColor(Qt::white), 2.0)}) {
        painter.setPen(QPen(colour, width));
        if (m_joined && m_markers.size() >= 2)
            painter.drawLine(fromPixel(m_markers[0].pixel), fromPixel(m_markers[1].pixel));
    }
    for (const MarkerPixel &marker : m_markers) {
        const QString label = QString::fromStdString(marker.label);
        const QPointF at = fromPixel(marker.pixel);
        const bool isCurrent = label == m_current;
        for (const auto &[colour, width] : {std::pair(QColor(0, 0, 0, 180), 4.0),
                                            std::pair(isCurrent ? currentColour : markerColour, 1.8)}) {
            painter.setPen(QPen(colour, width));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(at, 9, 9);
            for (const QPointF &arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
                painter.drawLine(at + 3 * arm, at + 9 * arm);
        }
        drawHaloText(painter, at + QPointF(13, 5), label, isCurrent ? currentColour : QColor(Qt::white));
    }
}

/// Magnifier round the dragged marker, in the farther corner of the image.
void MarkerCanvas::paintMagnifier(QPainter &painter) const
{
    const auto found = std::ranges::find(m_markers, m_current.toStdString(), &MarkerPixel::label);
    if (found == m_markers.end())
        return;
    const QPointF at = fromPixel(found->pixel);
    const bool onLeft = at.x() < 0.5 * width();
    const QRectF glass(onLeft ? width() - magnifierPx - 12 : 12, 12, magnifierPx, magnifierPx);
    const double imagePerPixel = double(m_image.width()) / m_size.width();
    const double side = magnifierPx / magnification * imagePerPixel * m_size.width() / imageRect().width();
    const QPointF middle((found->pixel.x() + 0.5) * imagePerPixel, (found->pixel.y() + 0.5) * imagePerPixel);
    QPainterPath round;
    round.addEllipse(glass);
    painter.save();
    painter.setClipPath(round);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter.fillRect(glass, Qt::black);
    painter.drawImage(glass, m_image, QRectF(middle.x() - side / 2, middle.y() - side / 2, side, side));
    painter.setPen(QPen(currentColour, 1));
    painter.drawLine(QPointF(glass.left(), glass.center().y()), QPointF(glass.right(), glass.center().y()));
    painter.drawLine(QPointF(glass.center().x(), glass.top()), QPointF(glass.center().x(), glass.bottom()));
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, 4));
    painter.drawEllipse(glass);
    painter.setPen(QPen(Qt::white, 2));
    painter.drawEllipse(glass);
}

void MarkerCanvas::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || m_image.isNull() || !imageRect().contains(event->position()))
        return;
    m_dragging = true;
    m_movedByKeys = false;
    if (const MarkerPixel *there = markerAt(event->position())) {
        m_current = QString::fromStdString(there->label);
        Q_EMIT picked(m_current);
    } else if (!m_current.isEmpty()) {
        const Eigen::Vector2d pixel = toPixel(event->position());
        if (MarkerPixel *marker = current())
            marker->pixel = pixel;
        else
            m_markers.push_back({m_current.toStdString(), pixel});
    }
    update();
}

void MarkerCanvas::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_dragging)
        return;
    if (MarkerPixel *marker = current())
        marker->pixel = toPixel(event->position());
    update();
}

void MarkerCanvas::mouseReleaseEvent(QMouseEvent *event)
{
    if (!std::exchange(m_dragging, false))
        return;
    update();
    if (current())
        Q_EMIT markerSet(m_current, toPixel(event->position()), true);
}

void MarkerCanvas::keyPressEvent(QKeyEvent *event)
{
    const auto modifiers = event->modifiers();
    const double step = modifiers & Qt::ControlModifier ? leapPx
                        : modifiers & Qt::ShiftModifier ? largeKeyStepPx
                                                        : keyStepPx;
    Eigen::Vector2d move(0, 0);
    switch (event->key()) {
    case Qt::Key_Left:
        move.x() = -step;
        break;
    case Qt::Key_Right:
        move.x() = step;
        break;
    case Qt::Key_Up:
        move.y() = -step;
        break;
    case Qt::Key_Down:
        move.y() = step;
        break;
    case Qt::Key_Space:
        break;
    default:
        return QWidget::keyPressEvent(event);
    }
    if (m_image.isNull() || m_current.isEmpty())
        return;
    // A marker that is nowhere yet begins in the middle, for those who have no mouse.
    const Eigen::Vector2d last(m_size.width() - 1, m_size.height() - 1);
    const MarkerPixel *marker = current();
    const Eigen::Vector2d from = marker ? marker->pixel : 0.5 * last;
    m_movedByKeys = true;
    Q_EMIT markerSet(m_current, (from + move).cwiseMax(0).cwiseMin(last), event->key() == Qt::Key_Space);
    update();
}

void MarkerCanvas::focusOutEvent(QFocusEvent *event)
{
    m_movedByKeys = false;
    QWidget::focusOutEvent(event);
    update();
}

namespace {

class SnappedMarkerWords
{
    Q_DECLARE_TR_FUNCTIONS(SnappedMarker)
};

} // namespace

QString snappedWords(SnappedMarker::Kind kind)
{
    switch (kind) {
    case SnappedMarker::Kind::Tag:
        return SnappedMarkerWords::tr("tag");
    case SnappedMarker::Kind::Ring:
        return SnappedMarkerWords::tr("ring");
    case SnappedMarker::Kind::Dot:
        return SnappedMarkerWords::tr("dot");
    case SnappedMarker::Kind::TapeCrossing:
        return SnappedMarkerWords::tr("tape crossing");
    case SnappedMarker::Kind::TapeCorner:
        return SnappedMarkerWords::tr("corner");
    case SnappedMarker::Kind::Saddle:
        return SnappedMarkerWords::tr("crossing fields");
    case SnappedMarker::Kind::None:
        break;
    }
    return SnappedMarkerWords::tr("by hand");
}

} // namespace odo
