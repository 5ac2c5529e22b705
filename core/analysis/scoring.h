// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/base/error.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// One line of a scoring rubric: all its points where the metric is at fullAt or beyond, none at noneAt or
/// beyond, evenly between them. Which of the bounds is the smaller one says whether less or more is better.
/// Points below zero are a penalty: it is full at fullAt.
struct Criterion
{
    std::string metric;            ///< its stable identifier, one of Profile::metrics or of scoringMetrics
    double fullAt = 0, noneAt = 0; ///< in the metric's unit
    double points = 0;
    bool operator==(const Criterion &) const = default;
};

/// What one line gave.
struct CriterionScore
{
    Criterion criterion;
    std::optional<Metric>
        metric;       ///< nullopt: the run has none of that name; it gives no points, and no penalty
    double share = 0; ///< of its points, 0 to 1
    double points = 0;
    double sigma = 0; ///< of the points: half of what they differ by when the metric is one σ more or less
};

/// What a run is worth, with how it comes about. Pure values.
struct Score
{
    std::vector<CriterionScore> lines;
    double points = 0; ///< the sum of the lines
    double most = 0;   ///< that can be had: the sum of the points above zero
    double sigma = 0;  ///< root of the sum of the squares: the lines' errors are assumed independent
};

/// The counts that a rubric can use beside the metrics, always all three: spikes (1, flagged samples),
/// limit_breaches (1, those beyond the task's limits) and gates_passed (1, different ones).
std::vector<Metric> scoringMetrics(const std::vector<Spike> &spikes,
                                   const std::vector<GatePassage> &passages);

Score scoreOf(const std::vector<Criterion> &criteria, const std::vector<Metric> &metrics);

/// Whether a task has anything that metrics depend on: gates, a path, limits or zones.
bool hasCourse(const Task &task);

/// Whether a rubric can be computed, InvalidInput where not: numbers that are none, bounds that are equal, no
/// points or more than 1000, a metric without a name, more than 30 lines.
Result<void> checkScoring(const std::vector<Criterion> &criteria);

} // namespace odo
