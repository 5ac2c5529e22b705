// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/trial_table.h"

#include <span>
#include <string>
#include <vector>

namespace odo {

/// A metric that a person defined by a formula from other metrics and from variables of the trials, such as
/// energy, J, 0.5 * mass * max_speed^2.
struct OwnMetric
{
    std::string name, unit, formula;
};

/// Errors: InvalidInput for a formula that cannot be read, or a name that is empty, no single word, or a
/// metric's.
Result<void> checkOwnMetric(const OwnMetric &metric);

/// Adds a column for each of them, of every row that has all that it needs: metrics in the unit of their
/// column (the first that the row has of several units; SI, but mm for distances from the path), variables as
/// numbers, assumed to be exact. Each can use those before it. σ to first order, of metrics that are
/// independent of each other; none where one of them has none. Where a metric is a lower bound the result is
/// one, too, if it grows with it, and left out if it falls with it. NotFound for a formula with a name that
/// the table does not have, AlreadyExists for a name that it has. Any thread.
Result<void> addOwnMetrics(ResultTable &table, std::span<const OwnMetric> metrics);

} // namespace odo
