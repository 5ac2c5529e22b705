// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPointF>

namespace odo {

/// What a curve looks like in so many pixel columns: of each column the first, lowest, highest and last
/// point, in order. Points must be sorted by x. Curves of up to four points a column come back as they are;
/// no extreme is lost.
QList<QPointF> decimated(const QList<QPointF> &points, double left, double right, int columns);

} // namespace odo
