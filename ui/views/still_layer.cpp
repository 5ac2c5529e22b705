// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/still_layer.h"

#include <QPainter>
#include <QWidget>

namespace odo {

void StillLayer::paint(QPainter &painter, const QWidget &view, const QColor &ground, const Draw &draw)
{
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
    painter.setFont(view.font());
    painter.setRenderHint(QPainter::Antialiasing);
    draw(painter);
}

} // namespace odo
