// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/map/map_canvas.h"

#include "ui/views/widgets/theme.h"

#include <QEvent>

namespace odo {

MapCanvas::MapCanvas(QWidget *parent) : QWidget(parent)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void MapCanvas::drawStill(QPainter &painter)
{
    m_still.paint(painter, *this, ThemeColours::of(palette()).mapGround,
                  [this](QPainter &still) { paintStill(still); });
}

void MapCanvas::addToStill(const std::function<void(QPainter &)> &paint)
{
    m_still.add(*this, paint);
}

void MapCanvas::forgetStill()
{
    m_still.forget();
    update();
}

void MapCanvas::resizeEvent(QResizeEvent *)
{
    m_still.forget();
}

void MapCanvas::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        m_still.forget();
    QWidget::changeEvent(event);
}

} // namespace odo
