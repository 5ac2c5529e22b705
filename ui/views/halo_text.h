// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <QString>

class QPainter;

namespace odo {

/// Text that can be read on any picture: a dark rim around it. The point is the left end of the base line.
void drawHaloText(QPainter &painter, const QPointF &baseline, const QString &text, const QColor &colour);

/// Text in a dark, slightly transparent box that is kept inside `frame`; a long one is cut off, so that it leaves the picture
/// to be seen. The point is the middle of its left
/// edge.
void drawTag(QPainter &painter, const QPointF &leftMiddle, const QString &text, const QColor &colour,
             const QRectF &frame);

} // namespace odo
