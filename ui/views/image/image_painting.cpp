// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/image/image_painting.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

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
    const QString text = metrics.elidedText(
        fullText, Qt::ElideRight, std::min(frame.width() - 14, std::max(shortest, frame.width() / 2)));
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

QRectF fittedRect(const QSize &imagePx, const QSizeF &widget, double devicePixelRatio)
{
    if (imagePx.isEmpty())
        return {QPointF(0, 0), widget};
    const QSizeF size = QSizeF(imagePx).scaled(widget, Qt::KeepAspectRatio);
    const auto whole = [devicePixelRatio](double length) {
        return std::round(length * devicePixelRatio) / devicePixelRatio;
    };
    return {whole((widget.width() - size.width()) / 2), whole((widget.height() - size.height()) / 2),
            whole(size.width()), whole(size.height())};
}

QPointF fromImagePixel(const QPointF &pixel, const QSize &imagePx, const QRectF &fitted)
{
    return imagePx.isEmpty()
               ? pixel
               : fitted.topLeft() + (pixel + QPointF(0.5, 0.5)) * (fitted.width() / imagePx.width());
}

QPointF toImagePixel(const QPointF &position, const QSize &imagePx, const QRectF &fitted)
{
    return imagePx.isEmpty()
               ? position
               : (position - fitted.topLeft()) * (imagePx.width() / fitted.width()) - QPointF(0.5, 0.5);
}

QImage toImage(ScreenImage &&image)
{
    if (!image.pixels)
        return {};
    auto *owned = new ScreenImage(std::move(image)); // freed by the image's last copy
    return QImage(
        reinterpret_cast<const uchar *>(owned->pixels.get()), owned->width, owned->height,
        owned->width * qsizetype(sizeof(std::uint32_t)), QImage::Format_RGB32,
        [](void *pointer) { delete static_cast<ScreenImage *>(pointer); }, owned);
}

} // namespace odo
