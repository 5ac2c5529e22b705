// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/picture_fit.h"

#include <cmath>

namespace odo {

QRectF fittedRect(const QSize &picturePx, const QSizeF &widget, double devicePixelRatio)
{
    if (picturePx.isEmpty())
        return {QPointF(0, 0), widget};
    const QSizeF size = QSizeF(picturePx).scaled(widget, Qt::KeepAspectRatio);
    const auto whole = [devicePixelRatio](double length) {
        return std::round(length * devicePixelRatio) / devicePixelRatio;
    };
    return {whole((widget.width() - size.width()) / 2), whole((widget.height() - size.height()) / 2),
            whole(size.width()), whole(size.height())};
}

QPointF fromPicturePixel(const QPointF &pixel, const QSize &picturePx, const QRectF &fitted)
{
    return picturePx.isEmpty()
               ? pixel
               : fitted.topLeft() + (pixel + QPointF(0.5, 0.5)) * (fitted.width() / picturePx.width());
}

QPointF toPicturePixel(const QPointF &place, const QSize &picturePx, const QRectF &fitted)
{
    return picturePx.isEmpty() ? place : (place - fitted.topLeft()) * (picturePx.width() / fitted.width()) - QPointF(0.5, 0.5);
}

} // namespace odo
