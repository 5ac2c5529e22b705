// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSize>

namespace odo {

/// Where a picture of a size in pixels stands in a widget, as large as fits, on whole device pixels, so that
/// it is not resampled once more. All of the widget for an empty size.
QRectF fittedRect(const QSize &picturePx, const QSizeF &widget, double devicePixelRatio);

/// Where a pixel of it lies; pixel (0,0) is the centre of the top-left one.
QPointF fromPicturePixel(const QPointF &pixel, const QSize &picturePx, const QRectF &fitted);
/// The other way.
QPointF toPicturePixel(const QPointF &place, const QSize &picturePx, const QRectF &fitted);

} // namespace odo
