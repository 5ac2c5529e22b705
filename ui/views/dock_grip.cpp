// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/dock_grip.h"

#include <QPainter>

namespace odo {
namespace {
constexpr int gripHeight = 8;
constexpr int dots = 5;
constexpr double dotSide = 2.5, dotDistance = 6;
} // namespace

DockGrip::DockGrip(QWidget *parent) : QWidget(parent)
{
    setCursor(Qt::SizeAllCursor);
    setToolTip(tr("Drag to move, double click to float"));
}

QSize DockGrip::sizeHint() const
{
    return {60, gripHeight};
}

void DockGrip::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    QColor colour = palette().color(QPalette::WindowText);
    colour.setAlphaF(0.25f);
    painter.setBrush(colour);
    const QPointF first(width() / 2.0 - (dots - 1) * dotDistance / 2, height() / 2.0);
    for (int i = 0; i < dots; ++i)
        painter.drawEllipse(first + QPointF(i * dotDistance, 0), dotSide / 2, dotSide / 2);
}

} // namespace odo
