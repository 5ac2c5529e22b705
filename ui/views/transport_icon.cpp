// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/transport_icon.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>

namespace odo {

namespace {

/// A triangle that points to the right, in a unit square.
QPainterPath triangle(double left, double right)
{
    QPainterPath path(QPointF(left, 0.14));
    path.lineTo(right, 0.5);
    path.lineTo(left, 0.86);
    path.closeSubpath();
    return path;
}

QPainterPath signPath(TransportSign sign)
{
    QPainterPath path;
    switch (sign) {
    case TransportSign::Play:
        return triangle(0.22, 0.88);
    case TransportSign::Pause:
        path.addRect(0.22, 0.14, 0.2, 0.72);
        path.addRect(0.58, 0.14, 0.2, 0.72);
        return path;
    case TransportSign::Last:
        path = triangle(0.14, 0.7);
        path.addRect(0.74, 0.14, 0.13, 0.72);
        return path;
    case TransportSign::First:
        return QTransform(-1, 0, 0, 1, 1, 0).map(signPath(TransportSign::Last));
    }
    return path;
}

class SignEngine : public QIconEngine
{
public:
    SignEngine(TransportSign sign, const QColor &colour) : m_sign(sign), m_colour(colour) {}

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override
    {
        QColor colour = m_colour;
        if (mode == QIcon::Disabled)
            colour.setAlphaF(0.4F);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(rect.width(), rect.height());
        painter->fillPath(signPath(m_sign), colour);
        painter->restore();
    }
    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }
    QIconEngine *clone() const override { return new SignEngine(m_sign, m_colour); }

private:
    TransportSign m_sign;
    QColor m_colour;
};

} // namespace

QIcon transportIcon(TransportSign sign, const QColor &colour)
{
    return QIcon(new SignEngine(sign, colour));
}

} // namespace odo
