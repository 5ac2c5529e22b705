// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/image/internal/loupe.h"

#include <QPainter>
#include <algorithm>
#include <utility>

namespace odo {

void drawLoupe(QPainter &painter, const QRectF &frame, const QImage &image, const QSize &recordingPx,
               const QPointF &centrePx, const std::function<void(const ImageMap &map)> &paintOver)
{
    constexpr double scale = 8, largest = 200, least = 64, margin = 8, part = 0.45;
    const double side = std::min(largest, part * std::min(frame.width(), frame.height()));
    if (side < least || image.isNull() || recordingPx.isEmpty())
        return;
    const QRectF inset(frame.right() - margin - side, frame.top() + margin, side, side);
    const QPointF half(0.5, 0.5); // a pixel's centre is its position
    const QPointF corner = centrePx + half - QPointF(side, side) / (2 * scale);
    const double across = double(image.width()) / recordingPx.width(),
                 down = double(image.height()) / recordingPx.height();
    painter.save();
    painter.setClipRect(inset);
    painter.fillRect(inset, Qt::black); // beyond the recording
    painter.setRenderHint(QPainter::SmoothPixmapTransform, image.width() != recordingPx.width());
    const QRectF seen =
        QRectF(corner, QSizeF(side, side) / scale).intersected(QRectF(QPointF(), recordingPx));
    painter.drawImage(
        QRectF(inset.topLeft() + (seen.topLeft() - corner) * scale, seen.size() * scale), image,
        QRectF(seen.left() * across, seen.top() * down, seen.width() * across, seen.height() * down));
    painter.setRenderHint(QPainter::Antialiasing);
    paintOver([&](const QPointF &pixel) { return inset.topLeft() + (pixel + half - corner) * scale; });
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (const auto &[colour, width] :
         {std::pair(QColor(20, 24, 28), 3.0), std::pair(QColor(Qt::white), 1.0)}) {
        painter.setPen(QPen(colour, width)); // to be seen on any floor
        painter.drawRect(inset);
    }
}

} // namespace odo
