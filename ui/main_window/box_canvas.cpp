// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/box_canvas.h"

#include "ui/views/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <utility>

namespace odo {
namespace {

const QColor boxColour(240, 228, 66);
constexpr int leastSidePx = 3; // of the picture; less is a click
constexpr int stepsAcross = 160, leapsAcross = 20, boxesAcross = 8;

} // namespace

BoxCanvas::BoxCanvas(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setAccessibleName(
        tr("Picture; arrow keys move the box round the robot, with Shift they change its size"));
}

void BoxCanvas::setSourceSize(QSize size)
{
    if (size == m_size)
        return;
    m_size = size;
    m_picture = {};
    m_box = {};
    update();
}

void BoxCanvas::setPicture(const QImage &picture)
{
    m_picture = picture;
    update();
}

void BoxCanvas::setEmptyText(const QString &text)
{
    m_emptyText = text;
    update();
}

QRectF BoxCanvas::pictureRect() const
{
    const QSizeF room = QSizeF(m_size).scaled(size(), Qt::KeepAspectRatio);
    return {QPointF(0.5 * (width() - room.width()), 0.5 * (height() - room.height())), room};
}

QPoint BoxCanvas::toPixel(const QPointF &place) const
{
    const QRectF picture = pictureRect();
    const auto inside = [](double part, int size) {
        return std::clamp(static_cast<int>(part * size), 0, size - 1);
    };
    return {inside((place.x() - picture.x()) / picture.width(), m_size.width()),
            inside((place.y() - picture.y()) / picture.height(), m_size.height())};
}

QRectF BoxCanvas::placeOf(const QRect &box) const
{
    const QRectF picture = pictureRect();
    const double scale = picture.width() / m_size.width();
    return {picture.topLeft() + QPointF(box.topLeft()) * scale, QSizeF(box.size()) * scale};
}

void BoxCanvas::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.pictureGround);
    if (m_picture.isNull()) {
        painter.setPen(colours.muted);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
    } else {
        painter.drawImage(pictureRect(), m_picture);
    }
    if (!m_box.isEmpty() && !m_picture.isNull()) {
        for (const auto &[colour, width] :
             {std::pair(QColor(0, 0, 0, 180), 4.0), std::pair(boxColour, 2.0)}) {
            painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
            painter.drawRect(placeOf(m_box));
        }
    }
    if (hasFocus()) {
        painter.setPen(QPen(colours.accent, 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void BoxCanvas::resizeEvent(QResizeEvent *)
{
    Q_EMIT resized();
}

void BoxCanvas::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || m_picture.isNull())
        return;
    m_drawing = true;
    m_boxBefore = m_box;
    m_corner = toPixel(event->position());
    m_box = {};
    update();
}

void BoxCanvas::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_drawing)
        return;
    m_box = QRect(m_corner, toPixel(event->position())).normalized();
    update();
}

void BoxCanvas::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || !std::exchange(m_drawing, false))
        return;
    const QRect drawn = QRect(m_corner, toPixel(event->position())).normalized();
    const bool isBox = drawn.width() >= leastSidePx && drawn.height() >= leastSidePx;
    m_box = isBox ? drawn : m_boxBefore;
    update();
    if (isBox)
        Q_EMIT boxChanged(m_box);
}

void BoxCanvas::keyPressEvent(QKeyEvent *event)
{
    const int step =
        std::max(1, m_size.width() / (event->modifiers() & Qt::ControlModifier ? leapsAcross : stepsAcross));
    QPoint by;
    switch (event->key()) {
    case Qt::Key_Left:
        by.setX(-step);
        break;
    case Qt::Key_Right:
        by.setX(step);
        break;
    case Qt::Key_Up:
        by.setY(-step);
        break;
    case Qt::Key_Down:
        by.setY(step);
        break;
    default:
        QWidget::keyPressEvent(event);
        return;
    }
    if (m_picture.isNull())
        return;
    const QRect picture(QPoint(0, 0), m_size);
    if (m_box.isEmpty()) {
        const QSize side(m_size.width() / boxesAcross, m_size.height() / boxesAcross);
        m_box = QRect(picture.center() - QPoint(side.width() / 2, side.height() / 2), side);
    } else if (event->modifiers() & Qt::ShiftModifier) {
        const QPoint least = m_box.topLeft() + QPoint(leastSidePx, leastSidePx),
                     wanted = m_box.bottomRight() + by;
        m_box.setBottomRight(
            {std::clamp(wanted.x(), std::min(least.x(), picture.right()), picture.right()),
             std::clamp(wanted.y(), std::min(least.y(), picture.bottom()), picture.bottom())});
    } else {
        m_box.moveTo(std::clamp(m_box.x() + by.x(), 0, std::max(0, m_size.width() - m_box.width())),
                     std::clamp(m_box.y() + by.y(), 0, std::max(0, m_size.height() - m_box.height())));
    }
    update();
    Q_EMIT boxChanged(m_box);
}

} // namespace odo
