// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"

#include <string>
#include <vector>

namespace odo {

/// So many of a run's metrics, the most telling ones first: the time of the task before all; what else there
/// is fills up.
std::vector<Metric> tellingMetrics(const std::vector<Metric> &all, std::size_t count);

/// Names of metrics in that order.
std::vector<std::string> tellingNames(const std::vector<std::string> &names);

} // namespace odo
