// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/compare/standings.h"
#include "ui/views/curves/chart_content.h"

namespace odo {

/// A team's runs through the term as a chart: a point each, the line of progress through them (dashed where
/// the spread explains it), and the band of the spread about it; days below, the name of the metric with its
/// unit at the left. The team must have a run. A value; any thread.
ChartDrawing trendDrawing(const TeamStanding &team);

} // namespace odo
