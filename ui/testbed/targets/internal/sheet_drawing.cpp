// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/targets/internal/sheet_drawing.h"

#include <QFont>
#include <QPainter>
#include <QTransform>

namespace odo {

QPainterPath darkCells(const TagPattern &pattern)
{
    QPainterPath path;
    for (int row = 0; row < pattern.side; ++row) {
        for (int column = 0; column < pattern.side; ++column)
            if (pattern.isBlack(column, row))
                path.addRect(column, row, 1, 1);
    }
    return path.simplified();
}

QPainterPath tagInk(int tag)
{
    const TagPattern pattern = aprilTagPattern(tag);
    const double cell = 1.0 / (pattern.side - 2);
    return QTransform(cell, 0, 0, cell, -cell, -cell).map(darkCells(pattern));
}

/// Fonts are asked for in whole units, hence the scale.
void paintText(QPainter &painter, const QRectF &positionMm, double heightMm, int flags, const QString &text,
               bool bold)
{
    constexpr double scale = 0.01;
    painter.save();
    painter.translate(positionMm.topLeft());
    painter.scale(scale, scale);
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(qRound(heightMm / scale));
    font.setBold(bold);
    painter.setFont(font);
    painter.drawText(QRectF(QPointF(0, 0), positionMm.size() / scale), flags, text);
    painter.restore();
}

} // namespace odo
