// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/internal/run_comparison.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// A gate as a position on the common path: the line across it there. On a closed path it comes again in each
/// lap.
struct PathGate
{
    std::string name;
    double stationM = 0; ///< along the path, from 0 to its length
};

/// Where the gates of a task cut a path, each at its first cut, in the order of the path; those that do not
/// cut it are left out.
std::vector<PathGate> gatesOnPath(const ReferencePath &path, const std::vector<Gate> &gates);

/// Two gates that part the stretch in common, or one lap of a closed path, into three: where a task has none.
std::vector<PathGate> thirdsOf(const RunComparison &comparison);

/// The point of a path at a way along it, and the direction there. Beyond an end: that of the end.
struct PathPoint
{
    Eigen::Vector2d position = Eigen::Vector2d::Zero(), direction = Eigen::Vector2d::UnitX();
};
PathPoint pointAt(const ReferencePath &path, double pathM);

/// A stretch of the path between two neighbouring gates, or from where all have started, or to where the last
/// of them got.
struct SectorTimes
{
    std::string from, to; ///< gates; empty: the beginning or the end of what the runs have in common
    double fromM = 0, toM = 0;
    std::vector<std::optional<Difference>>
        times; ///< of each run, with σ; nullopt where it was not seen at an end
    std::vector<std::optional<Difference>>
        differences; ///< each run's less the first one's; of the first nullopt
};

/// The time that each run takes from gate to gate, by first arrival: the sectors' differences add up to the
/// time difference at the end. σ as of compareRuns: displacements at two positions count as independent.
/// Sectors of less than 10 mm are left out. Pure; any thread.
std::vector<SectorTimes> sectorTimes(const RunComparison &comparison, const std::vector<PathGate> &gates);

/// A metric of two runs; nullopt where a run has none.
struct MetricDifference
{
    std::string name, unit;
    std::optional<double> a, b;
    std::optional<double> sigmaA, sigmaB;
    std::optional<Difference> difference;        ///< b − a, where both have one that is not a lower bound
    bool isAtLeastA = false, isAtLeastB = false; ///< Metric::isAtLeast
};

/// The metrics of two runs side by side, in the order of the first, then those of the second alone. σ of a
/// difference: both σ as independent (JCGM 100:2008, 5.1.2). If the runs share their calibration, its scale
/// uncertainty (sigmaOfScale), which all lengths, speeds and accelerations contain, is the same for both and
/// leaves only its part of the difference; everything else they share counts as independent, which makes σ
/// rather too large. Counts are exact; path_completed is known to its resolution. sameTask: the task's
/// metrics mean the same in both; otherwise they are left out. Pure; any thread.
std::vector<MetricDifference> metricDifferences(const Profile &a, const Profile &b, bool shareCalibration,
                                                bool sameTask);

} // namespace odo
