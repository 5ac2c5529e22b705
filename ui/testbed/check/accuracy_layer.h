// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/accuracy_map.h"

#include <QFontMetrics>
#include <QPalette>
#include <QPointF>
#include <QRect>
#include <QSize>
#include <functional>
#include <vector>

class QPainter;

namespace odo {

/// σ over the floor as it is painted: one value a place of the grid, NaN where it is not seen. Metres.
struct SketchedAccuracy
{
    FloorGrid grid;
    std::vector<double> sigmaM;
};

/// World metres to widget pixels.
using ToScreen = std::function<QPointF(const Eigen::Vector2d &)>;

/// Lines of equal σ: of 1, 2, 5, 10... mm, those that lie within the map.
std::vector<double> accuracyLevelsM(const SketchedAccuracy &accuracy);

/// Paints σ in the colours of cividis (the darker the better known), hatched where nothing is seen, with lines of equal σ
/// and their millimetres.
void drawAccuracy(QPainter &painter, const SketchedAccuracy &accuracy, const ToScreen &toScreen, const QPalette &palette);

/// How large the key is.
QSize accuracyKeySize(const QFontMetrics &metrics);

/// What the colours mean, as a bar in the lower left corner of the area.
void drawAccuracyKey(QPainter &painter, const SketchedAccuracy &accuracy, const QRect &area, const QPalette &palette);

} // namespace odo
