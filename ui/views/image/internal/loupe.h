// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/image/image_overlay.h"

#include <functional>

namespace odo {

/// Paints the surroundings of a point of the recording into the upper right corner of a frame, eight logical
/// pixels for one of the recording, with what paintOver paints through the map that it gets. image: of the
/// recording, at any size. Nothing where the frame is too small.
void drawLoupe(QPainter &painter, const QRectF &frame, const QImage &image, const QSize &recordingPx,
               const QPointF &centrePx, const std::function<void(const ImageMap &map)> &paintOver);

} // namespace odo
