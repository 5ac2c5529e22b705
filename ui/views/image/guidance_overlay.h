// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/guidance_repository.h"
#include "ui/views/image/image_overlay.h"

#include <QPolygonF>
#include <optional>

namespace odo {

/// What guides the tracker in a view, over its image: ignored areas hatched, all else than the searched ones
/// dimmed, and in the frame shown where a person marked a robot.
void paintGuidance(QPainter &painter, const TrialScene &scene, std::size_t view, std::int64_t frame,
                   const ImageMap &map);

/// An area while it is drawn: its corners in image pixels, and where the mouse is.
void paintDrawnArea(QPainter &painter, GuidanceItem::Kind kind, const QPolygonF &corners,
                    const std::optional<QPointF> &mouse, const ImageMap &map);

} // namespace odo
