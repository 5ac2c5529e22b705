// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/compare/standings.h"

#include <QRectF>

class QPainter;
class QPalette;

namespace odo {

/// A team's runs through the term: a point each, the line of progress through them (dashed where the spread
/// explains it), and the band of the spread about it; with axes and the name of the figure. The team must
/// have a run.
void drawTrend(QPainter &painter, const QRectF &rect, const TeamStanding &team, const QPalette &palette);

} // namespace odo
