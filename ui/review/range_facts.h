// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/range_report.h"
#include "ui/views/fact_list.h"

namespace odo {

/// A range's figures in words, each with how it was computed: times and path, then a fact a quantity.
QList<Fact> rangeFacts(const RangeReport &report);
/// The fit in words: coefficients with ±, residual, and what χ² says; or why there is none. Empty: none was
/// wanted.
QList<Fact> fitFacts(const RangeReport &report);

} // namespace odo
