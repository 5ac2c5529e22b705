// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/certificate/certificate.h"

#include <Eigen/Geometry>
#include <QRectF>
#include <vector>

class QPainter;

namespace odo {

/// A known run from above: its truth dashed, and strokes from it as far as the errors of each run, enlarged;
/// gives how many times. task: null: none.
double drawTruthMap(QPainter &painter, const QRectF &rect, const Eigen::AlignedBox2d &bounds,
                    const MarkerLayout &layout, const Task *task, const std::vector<CertificateRun> &runs);

} // namespace odo
