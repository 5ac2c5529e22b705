// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/map_canvas.h"

#include "ui/views/theme.h"

#include <QEvent>
#include <QPainter>

namespace odo {

MapCanvas::MapCanvas(QWidget *parent) : QWidget(parent)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void MapCanvas::drawStill(QPainter &painter)
{
    if (m_still.isNull()) {
        m_still = QPixmap((QSizeF(size()) * devicePixelRatioF()).toSize());
        m_still.setDevicePixelRatio(devicePixelRatioF());
        m_still.fill(ThemeColours::of(palette()).mapGround);
        addToStill([this](QPainter &still) { paintStill(still); });
    }
    painter.drawPixmap(0, 0, m_still);
}

void MapCanvas::addToStill(const std::function<void(QPainter &)> &paint)
{
    if (m_still.isNull())
        return;
    QPainter painter(&m_still);
    painter.setFont(font());
    painter.setRenderHint(QPainter::Antialiasing);
    paint(painter);
}

void MapCanvas::forgetStill()
{
    m_still = {};
    update();
}

void MapCanvas::resizeEvent(QResizeEvent *)
{
    m_still = {};
}

void MapCanvas::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        m_still = {};
    QWidget::changeEvent(event);
}

} // namespace odo
