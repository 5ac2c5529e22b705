// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <string_view>
#include <vector>

namespace odo {

/// All that is known of a metric besides its value: from here tables, reports, scoring, comparisons and
/// explanations take it. The formulas are those of core/analysis/metrics.h and task_metrics.h.
struct MetricKind
{
    enum class Better { Less, More };
    /// What it is used for; bits of uses.
    static constexpr unsigned ofTask = 1;  ///< it compares runs of one task only
    static constexpr unsigned scored = 2;  ///< a rubric usually scores it
    static constexpr unsigned atLeast = 4; ///< what a robot does unmeasured can only make it larger

    std::string_view id;   ///< "max_speed": stable, in projects, exports and rubrics
    std::string_view unit; ///< of its value: "s", "m", "m/s", "m/s²", "rad/s", "mm", "points", "1"
    Better better = Better::More;
    unsigned uses = 0;
    Message name;                 ///< "Top speed"
    Message formula = {};         ///< how it is computed; empty: its name says so
    Message uncertainty = {};     ///< what its ± contains; empty: it has none
    std::string_view source = {}; ///< publication; may be empty

    bool isOfTask() const { return (uses & ofTask) != 0; }
    bool isScored() const { return (uses & scored) != 0; }
    bool growsInGaps() const { return (uses & atLeast) != 0; }
};

/// Of all metrics, the most informative first. Made once; any thread.
const std::vector<MetricKind> &metricKinds();
/// nullptr: of a later version.
const MetricKind *metricKind(std::string_view id);

} // namespace odo
