// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/halo_text.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace odo {

void drawHaloText(QPainter &painter, const QPointF &baseline, const QString &text, const QColor &colour)
{
    QPainterPath path;
    path.addText(baseline, painter.font(), text);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.strokePath(path, QPen(QColor(0, 0, 0, 150), 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, colour);
    painter.restore();
}

void drawTag(QPainter &painter, const QPointF &leftMiddle, const QString &fullText, const QColor &colour,
             const QRectF &frame)
{
    constexpr double shortest = 160;
    const QFontMetricsF metrics(painter.font());
    const QString text = metrics.elidedText(fullText, Qt::ElideRight,
                                            std::min(frame.width() - 14, std::max(shortest, frame.width() / 2)));
    QRectF box(leftMiddle.x(), leftMiddle.y() - metrics.height() / 2 - 1,
               metrics.horizontalAdvance(text) + 10, metrics.height() + 2);
    box.moveLeft(std::max(frame.left() + 2, std::min(box.left(), frame.right() - 2 - box.width())));
    box.moveTop(std::max(frame.top() + 2, std::min(box.top(), frame.bottom() - 2 - box.height())));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 24, 28, 190));
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace odo
