// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/run_comparison.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// A figure of two runs; nullopt where a run has none.
struct MetricDifference
{
    std::string name, unit;
    std::optional<double> a, b;
    std::optional<double> sigmaA, sigmaB;
    std::optional<Difference> difference; ///< b − a, where both have one
};

/// The figures of two runs side by side, in the order of the first, then those of the second alone. σ of a
/// difference: both σ as independent (JCGM 100:2008, 5.1.2). Where the runs share their calibration, its
/// error of scale (sigmaOfScale), which all lengths, speeds and accelerations contain, is the same for both
/// and leaves only its part of the difference; what else they share counts as independent, which makes σ
/// rather too large. Counts are exact; path_completed is known to its resolution. sameTask: the figures of
/// the task mean the same in both; else they are left out. Pure; any thread.
std::vector<MetricDifference> metricDifferences(const Profile &a, const Profile &b, bool shareCalibration,
                                                bool sameTask);

} // namespace odo
