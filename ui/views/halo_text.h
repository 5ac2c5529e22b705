// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>

class QPainter;

namespace odo {

/// Text that can be read on any picture: a dark rim around it. The point is the left end of the base line.
void drawHaloText(QPainter &painter, const QPointF &baseline, const QString &text, const QColor &colour);

} // namespace odo
