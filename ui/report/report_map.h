// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/comparison_scene.h"
#include "ui/models/trial_scene.h"
#include "ui/report/run_events.h"

#include <QRectF>

class QPainter;

namespace odo {

/// The floor from above with a robot's way coloured by speed, the gates and the course of the task, spikes, and
/// the events' numbers; the ways of other robots are thin and grey. Painted by what the map of the screen is
/// painted by, without the floor's picture: paper stays light.
void drawRunMap(QPainter &painter, const QRectF &rect, const TrialScene &scene, std::size_t robot,
                const std::vector<RunEvent> &events);

/// The ways of these runs in their colours and dashes, with the gates across the common path.
void drawComparedMap(QPainter &painter, const QRectF &rect, const ComparisonScene &scene,
                     const std::vector<std::size_t> &runs);

} // namespace odo
