// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/metric_differences.h"
#include "core/trajectory/sector_times.h"
#include "ui/models/comparison_scene.h"
#include "ui/models/explanation.h"

namespace odo {

/// "How was this computed?" of what Compare shows of a run against the first one. run: 1 or more. distances as in the comparison, metres.

/// A line of the figures: the difference of both, and whether it is more than their errors.
Explanation explainDifference(const ComparisonScene &scene, std::size_t run, const MetricDifference &metric);
/// A line of the sectors.
Explanation explainSector(const ComparisonScene &scene, std::size_t run, const SectorTimes &sector);
/// How much later it is at a place of the way.
Explanation explainTimeDifference(const ComparisonScene &scene, std::size_t run, double distanceM, const Difference &difference);
/// A run's speed where it first came to a place of the way; value: as it is shown. run: 0 or more.
Explanation explainSpeedOnWay(const ComparisonScene &scene, std::size_t run, double distanceM, const QString &value);

} // namespace odo
