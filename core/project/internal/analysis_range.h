// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <vector>

namespace odo {

/// Leaves what is within a range, cut at its ends.
void keepWithin(const TimeSpan &range, std::vector<AmbiguousName> &names);

} // namespace odo
