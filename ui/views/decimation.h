// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPointF>

namespace odo {

/// What a curve looks like between left and right in so many pixel columns: of each column the first, lowest,
/// highest and last point, in order, and the next point beyond either end. Points must be sorted by x. Where there
/// are up to four points a column, they come back as they are; no extreme is lost.
QList<QPointF> decimated(const QList<QPointF> &points, double left, double right, int columns);

} // namespace odo
