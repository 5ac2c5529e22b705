// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/image.h"

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QRectF>
#include <QSize>
#include <QString>

class QPainter;

namespace odo {

/// Text legible on any image: it has a dark rim. The point is the left end of the base line.
void drawHaloText(QPainter &painter, const QPointF &baseline, const QString &text, const QColor &colour);

/// Text in a dark, slightly transparent box that is kept inside `frame`; a long one is cut off, so that it
/// leaves the image to be seen. The point is the middle of its left edge.
void drawTag(QPainter &painter, const QPointF &leftMiddle, const QString &text, const QColor &colour,
             const QRectF &frame);

/// The position of an image of a size in pixels in a widget, as large as fits, on whole device pixels, so
/// that it is not resampled once more. All of the widget for an empty size.
QRectF fittedRect(const QSize &imagePx, const QSizeF &widget, double devicePixelRatio);

/// Where a pixel of it lies; pixel (0,0) is the centre of the top-left one.
QPointF fromImagePixel(const QPointF &pixel, const QSize &imagePx, const QRectF &fitted);
/// The other way.
QPointF toImagePixel(const QPointF &position, const QSize &imagePx, const QRectF &fitted);

/// Hands the pixels over to a QImage without copying them.
QImage toImage(ScreenImage &&image);

} // namespace odo
