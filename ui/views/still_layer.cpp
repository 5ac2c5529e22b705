// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/still_layer.h"

#include "ui/views/chart_picture.h"

#include <QPainter>
#include <QWidget>

namespace odo {
namespace {

void drawOn(QPainter &painter, const QWidget &view, const StillLayer::Draw &draw)
{
    painter.setFont(view.font());
    painter.setRenderHint(QPainter::Antialiasing);
    draw(painter);
}

} // namespace

void StillLayer::paint(QPainter &painter, const QWidget &view, const QColor &ground, const Draw &draw)
{
    if (ChartPicture::isPaintedBy(painter, view)) {
        painter.fillRect(view.rect(), ground);
        drawOn(painter, view, draw);
        return;
    }
    if (m_picture.isNull()) {
        m_picture = QPixmap((QSizeF(view.size()) * view.devicePixelRatioF()).toSize());
        m_picture.setDevicePixelRatio(view.devicePixelRatioF());
        m_picture.fill(ground);
        add(view, draw);
    }
    painter.drawPixmap(0, 0, m_picture);
}

void StillLayer::add(const QWidget &view, const Draw &draw)
{
    if (m_picture.isNull())
        return;
    QPainter painter(&m_picture);
    drawOn(painter, view, draw);
}

} // namespace odo
