// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/analysis/task.h"

#include <string>
#include <vector>

namespace odo {

/// What a task adds to a run's metrics.
struct TaskMetrics
{
    std::vector<GatePassage> passages;
    std::vector<Metric> metrics;
};

/// Times at the gates, and how well the reference path was kept; of each only what the task has and the run
/// gave. Metrics, in this order: with a start and a finish apart gate_time (s, the first whole run); with one
/// gate for both laps (1), best_lap and mean_lap (s); with a path cross_track_mean, cross_track_rms,
/// cross_track_max (mm, of the distance without its sign), cross_track_bias (mm, its mean with it, to the
/// left positive) and path_completed (1); with zones those of measureZones. Distances are weighted by the
/// distance travelled, while the robot moves and is not beyond an end of the path; the maximum is the largest
/// significant one. σ of a distance metric: the track's own noise to first order with its correlation along
/// the run, what that noise alone adds to a mean of magnitudes and by selection to a maximum, and the
/// calibration's part as if it were fully correlated.
TaskMetrics measureTask(const Task &task, const std::vector<Sample> &samples,
                        const std::vector<ProfilePoint> &points);

/// A stretch in which the robot's reference point broke a zone's rule: outside a zone to stay in, or inside
/// one to keep out of.
struct ZoneBreach
{
    std::string zone;           ///< its name
    Nanoseconds from{0}, to{0}; ///< since the first view's first frame, interpolated between frames
    Nanoseconds deepest{0};     ///< when it was furthest from where it should have been
    double depthM = 0;          ///< how far that was, to the zone's edge
    double sigmaDepthM = 0;     ///< all of it
};

/// Breaches of all zones by the smoothed track, in order of their beginnings. A breach is significant:
/// somewhere in it the point is beyond the edge by more than six σ of the track's own noise (and 0.5 mm), and
/// it ends where the point is back by as much. A gap of the profile is not judged: a breach ends before it.
std::vector<ZoneBreach> findZoneBreaches(const std::vector<Zone> &zones, const std::vector<Sample> &samples,
                                         const std::vector<ProfilePoint> &points);

/// Metrics of the zones, all three if the task has a zone: zone_breaches (1), zone_time (s, in breaches; in
/// two zones at once it counts twice) and zone_depth (mm, of the deepest one, 0 without any). σ of the time:
/// half of its difference when all edges move in or out by the calibration's σ, and at each end of a breach
/// the track's own noise over the speed across the edge, as independent, or half of the difference by that
/// noise. σ of a depth of 0 is not known.
std::vector<Metric> measureZones(const std::vector<Zone> &zones, const std::vector<Sample> &samples,
                                 const std::vector<ProfilePoint> &points);

/// How far a point lies within a zone, from its nearest edge; below zero: outside of it.
double depthWithin(const Zone &zone, const Eigen::Vector2d &point);

} // namespace odo
