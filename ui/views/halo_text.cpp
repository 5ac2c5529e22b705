// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/halo_text.h"

#include <QPainter>
#include <QPainterPath>

namespace odo {

void drawHaloText(QPainter &painter, const QPointF &baseline, const QString &text, const QColor &colour)
{
    QPainterPath path;
    path.addText(baseline, painter.font(), text);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.strokePath(path, QPen(QColor(0, 0, 0, 170), 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, colour);
    painter.restore();
}

} // namespace odo
