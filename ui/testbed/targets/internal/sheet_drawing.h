// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/tag_pattern.h"

#include <QPainterPath>
#include <QRectF>
#include <QString>

class QPainter;

namespace odo {

// What all sheets that are printed have in common. Millimetres.

inline constexpr double sheetLineMm = 0.25, sheetTextMm = 3.1;

/// The dark cells as one outline, in cells: drawn one by one they would leave hairlines on the screen and on
/// paper.
QPainterPath darkCells(const TagPattern &pattern);

/// An AprilTag 36h11 of side 1 between (0,0) and (1,1); its white rim lies outside.
QPainterPath tagInk(int tag);

/// Text whose letters are so high in the painter's unit, which fonts of their own would round.
void paintText(QPainter &painter, const QRectF &positionMm, double heightMm, int flags, const QString &text,
               bool bold = false);

} // namespace odo
