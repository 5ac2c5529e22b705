// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>

namespace odo {

/// A line through fewer of its points, from its first to its last: none of those left out is farther from it
/// than the tolerance across, and as much along it. For painting: strokes cost by the point, and thousands of
/// them lie within a fraction of a pixel of one another. In one pass, by a cone that every point narrows
/// (K. Reumann, A. Witkam 1974, with the tolerance kept as a bound).
QPolygonF simplified(const QPolygonF &line, double tolerance);

} // namespace odo
