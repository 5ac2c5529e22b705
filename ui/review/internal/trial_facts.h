// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/widgets/fact_list.h"

namespace odo {

/// What the Trial card says of a trial: task, robots, testbed, views, synchronisation, smoother, notes. Facts
/// that are not known are left out; a missing video has a badge.
QList<Fact> trialFacts(const TrialScene &scene);

} // namespace odo
