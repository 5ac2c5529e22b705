// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/task.h"

namespace odo {

/// How large a template is made and where it lies. World frame, metres and radians.
struct TemplateSizes
{
    Eigen::Vector2d centre = Eigen::Vector2d(1.5, 1.0);
    double directionRad = 0; ///< of driving: straight line and slalom; from +X to the left
    double lengthM = 2; ///< straight line and slalom: from end to end; circle: its diameter; eight: its width
    double widthM = 0.6; ///< eight: its height; slalom: how far it swings, from side to side
    int poles = 4;       ///< slalom
    double gateM = 0.4;  ///< width of each gate
};

/// A task of a template with path and gates: the straight line with start, half-way and finish, start and
/// finish a tenth of its length from the ends; circle and eight with a line for laps where they are furthest
/// along +X, and one opposite; the slalom with start and finish at its ends; the free one with start and
/// finish alone, as far apart as its length. InvalidInput for sizes that are not above 1 mm, more than 100
/// poles, or what checkTask refuses.
Result<Task> taskFromTemplate(TaskTemplate kind, const TemplateSizes &sizes);

/// The sizes that a task's gates and path suggest, to rebuild it; for a task without any, the usual ones
/// about the position.
TemplateSizes suggestedSizes(const Task &task, const Eigen::Vector2d &position);

} // namespace odo
