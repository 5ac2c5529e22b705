// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/comparison_scene.h"
#include "ui/report/trial_report.h"

namespace odo {

/// The report of a comparison: the first run at the left, the second at the right, between them the ways of
/// both; below the speed and the time difference along the way, the sectors, and the figures with what is
/// within the error in grey. Of more runs each is compared with the first on a page of its own. Takes the
/// pictures of the views now (slow); the pages themselves are pure.
ReportPages comparisonPages(const ComparisonScenePtr &scene, const ReportOptions &options);

} // namespace odo
