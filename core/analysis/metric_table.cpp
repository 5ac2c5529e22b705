// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/metric_table.h"

#include <algorithm>

namespace odo {

namespace {

Message ofTheCurve()
{
    return ODO_TEXT("analysis.uncertainty_of_curve",
                    "that of the smoothed curve there; how far the largest of n equal values exceeds them, "
                    "σ√(2 ln n) at most, of the n peaks within 2σ; and the calibration's scale uncertainty");
}

Message ofCorrelatedErrors()
{
    return ODO_TEXT("analysis.uncertainty_correlated",
                    "the bound for fully correlated errors, and the calibration's scale uncertainty");
}

Message ofItsIntervals()
{
    return ODO_TEXT("analysis.uncertainty_of_intervals",
                    "of the intervals within 1.5 σ of it, each by its mean");
}

std::vector<MetricKind> allKinds()
{
    using Better = MetricKind::Better;
    constexpr unsigned ofTask = MetricKind::ofTask, scored = MetricKind::scored,
                       atLeast = MetricKind::atLeast;
    return {
        {"gate_time", "s", Better::Less, ofTask | scored,
         ODO_TEXT("analysis.metric_gate_time", "Start to finish"),
         ODO_TEXT("analysis.formula_gate_time",
                  "From passing the start gate to passing the finish, each interpolated between frames."),
         ODO_TEXT("analysis.uncertainty_gate_time",
                  "of both passages: σ of the position across the gate divided by the speed")},
        {"best_lap", "s", Better::Less, ofTask | scored, ODO_TEXT("analysis.metric_best_lap", "Best lap"),
         ODO_TEXT("analysis.formula_best_lap", "The shortest lap."),
         ODO_TEXT("analysis.uncertainty_best_lap",
                  "of its two passages; the calibration uncertainty of a gate passed twice cancels")},
        {"laps", "1", Better::More, ofTask | scored | atLeast, ODO_TEXT("analysis.metric_laps", "Laps"),
         ODO_TEXT("analysis.formula_laps", "Complete laps or runs, counted by the passages of the gates.")},
        {"cross_track_rms", "mm", Better::Less, ofTask | scored,
         ODO_TEXT("analysis.metric_cross_track_rms", "Off the path (RMS)"),
         ODO_TEXT("analysis.formula_cross_track_rms",
                  "√(mean of the squared distance from the reference path), averaged along the path"),
         ODO_TEXT("analysis.uncertainty_cross_track_rms", "of the position across the path")},
        {"duration", "s", Better::Less, scored, ODO_TEXT("analysis.metric_duration", "Time"),
         ODO_TEXT("analysis.formula_duration",
                  "From the onset of motion to the last stop. Moving means faster than three σ of the speed, "
                  "for at "
                  "least three frames, and further than noise explains; the moment between two frames is "
                  "interpolated."),
         ODO_TEXT("analysis.uncertainty_duration",
                  "of both moments: σ of the speed divided by its slope there, and how far smoothing blurs "
                  "them")},
        {"path_length", "m", Better::Less, scored | atLeast, ODO_TEXT("analysis.metric_path_length", "Path"),
         ODO_TEXT("analysis.formula_path_length",
                  "∫|v|dt while it moves, by the trapezoidal rule over the smoothed speed. A gap that is not "
                  "bridged adds nothing."),
         ODO_TEXT(
             "analysis.uncertainty_path_length",
             "of the end positions, of lateral errors where the path turns, of what the robot could have "
             "done where it was bridged, and the calibration's scale uncertainty")},
        {"max_speed", "m/s", Better::More, scored | atLeast,
         ODO_TEXT("analysis.metric_max_speed", "Top speed"),
         ODO_TEXT("analysis.formula_max_speed",
                  "The speed |v| of the smoothed curve where |v| − 3σ is largest. A point does not win only "
                  "because its uncertainty is large."),
         ofTheCurve()},
        {"mean_speed", "m/s", Better::More, scored, ODO_TEXT("analysis.metric_mean_speed", "Mean speed"),
         ODO_TEXT("analysis.formula_mean_speed", "path length / time, both without gaps"),
         ODO_TEXT("analysis.uncertainty_mean_speed",
                  "of both, treated as independent, and of gaps: from straight through them to the top speed "
                  "in them")},
        {"max_accel", "m/s²", Better::More, atLeast,
         ODO_TEXT("analysis.metric_max_accel", "Top acceleration"),
         ODO_TEXT("analysis.formula_max_accel",
                  "The acceleration |a| of the smoothed curve where |a| − 3σ is largest."),
         ofTheCurve()},
        {"moving_time", "s", Better::Less, atLeast, ODO_TEXT("analysis.metric_moving_time", "Time in motion"),
         ODO_TEXT("analysis.formula_moving_time", "The time in which it moves: faster than three σ of the "
                                                  "speed, and further than noise explains."),
         ODO_TEXT("analysis.uncertainty_moving_time",
                  "of each start and stop: σ of the speed divided by its slope")},
        {"mean_lap", "s", Better::Less, ofTask | scored, ODO_TEXT("analysis.metric_mean_lap", "Mean lap"),
         ODO_TEXT("analysis.formula_mean_lap", "The mean of the laps' times."),
         ODO_TEXT("analysis.uncertainty_mean_lap",
                  "of the first and the last passage, over the number of laps")},
        {"cross_track_mean", "mm", Better::Less, ofTask | scored,
         ODO_TEXT("analysis.metric_cross_track_mean", "Off the path (mean)"),
         ODO_TEXT("analysis.formula_cross_track_mean",
                  "The distance from the reference path, averaged along the path."),
         ODO_TEXT("analysis.uncertainty_cross_track_mean",
                  "of the position across the path, and of its noise: the distance has no sign, so noise "
                  "does not cancel")},
        {"cross_track_max", "mm", Better::Less, ofTask | scored | atLeast,
         ODO_TEXT("analysis.metric_cross_track_max", "Off the path (most)"),
         ODO_TEXT("analysis.formula_cross_track_max", "The largest distance from the reference path."),
         ODO_TEXT("analysis.uncertainty_cross_track_max", "of the position across the path, there")},
        {"cross_track_bias", "mm", Better::More, ofTask,
         ODO_TEXT("analysis.metric_cross_track_bias", "Left of the path"),
         ODO_TEXT("analysis.formula_cross_track_bias",
                  "The mean of the distance from the reference path, to the left positive."),
         ODO_TEXT("analysis.uncertainty_cross_track_bias",
                  "of the position across the path, mostly the calibration's")},
        {"path_completed", "1", Better::More, ofTask | scored | atLeast,
         ODO_TEXT("analysis.metric_path_completed", "Path completed"),
         ODO_TEXT("analysis.formula_path_completed",
                  "The share of the reference path that the robot followed.")},
        {"gates_passed", "1", Better::More, scored, ODO_TEXT("analysis.metric_gates_passed", "Gates passed")},
        {"zone_breaches", "1", Better::Less, ofTask | scored | atLeast,
         ODO_TEXT("analysis.metric_zone_breaches", "Zones broken"),
         ODO_TEXT(
             "analysis.formula_zone_breaches",
             "How often the robot's reference point left a zone to stay in or entered a zone to keep out of. "
             "It counts if the point is beyond the edge by more than six σ of the track's noise.")},
        {"zone_time", "s", Better::Less, ofTask | scored | atLeast,
         ODO_TEXT("analysis.metric_zone_time", "Time beyond zones"),
         ODO_TEXT("analysis.formula_zone_time",
                  "The time for which the robot's reference point was beyond the edge of a zone, "
                  "interpolated between frames; in two zones at once it counts twice."),
         ODO_TEXT("analysis.uncertainty_zone_time",
                  "of each crossing of an edge: σ of the position across it divided by the speed; and the "
                  "change of the time when the calibration uncertainty shifts the track")},
        {"zone_depth", "mm", Better::Less, ofTask | scored | atLeast,
         ODO_TEXT("analysis.metric_zone_depth", "Beyond zones (most)"),
         ODO_TEXT("analysis.formula_zone_depth",
                  "The largest distance of the robot's reference point beyond the edge of a zone."),
         ODO_TEXT("analysis.uncertainty_zone_depth", "of the position across the edge, there")},
        {"rms_speed", "m/s", Better::More, 0, ODO_TEXT("analysis.metric_rms_speed", "Speed (RMS)"),
         ODO_TEXT("analysis.formula_rms_speed", "√(mean of |v|²) while it moves"), ofCorrelatedErrors()},
        {"rms_accel", "m/s²", Better::More, 0, ODO_TEXT("analysis.metric_rms_accel", "Acceleration (RMS)"),
         ODO_TEXT("analysis.formula_rms_accel", "√(mean of |a|²) while it moves"), ofCorrelatedErrors()},
        {"straightness", "1", Better::More, scored, ODO_TEXT("analysis.metric_straightness", "Straightness"),
         ODO_TEXT("analysis.formula_straightness",
                  "distance from the first to the last position of the motion / path length"),
         ODO_TEXT("analysis.uncertainty_straightness", "of the end positions")},
        {"stops", "1", Better::Less, scored | atLeast, ODO_TEXT("analysis.metric_stops", "Stops"),
         ODO_TEXT("analysis.formula_stops",
                  "The pauses between the onset of motion and the last stop, counted where the robot was "
                  "measured at rest.")},
        {"standing_time", "s", Better::Less, scored | atLeast,
         ODO_TEXT("analysis.metric_standing_time", "Standing time"),
         ODO_TEXT("analysis.formula_standing_time", "time − time in motion"),
         ODO_TEXT("analysis.uncertainty_standing_time", "of each start and stop")},
        {"median_speed", "m/s", Better::More, 0, ODO_TEXT("analysis.metric_median_speed", "Median speed"),
         ODO_TEXT("analysis.formula_median_speed", "The speed that half of the time in motion stays below."),
         ofItsIntervals()},
        {"p95_speed", "m/s", Better::More, 0, ODO_TEXT("analysis.metric_p95_speed", "P95 speed"),
         ODO_TEXT("analysis.formula_p95_speed", "The speed that 95 % of the time in motion stays below."),
         ofItsIntervals()},
        {"p95_accel", "m/s²", Better::More, 0, ODO_TEXT("analysis.metric_p95_accel", "P95 acceleration"),
         ODO_TEXT("analysis.formula_p95_accel",
                  "The acceleration that 95 % of the time in motion stays below."),
         ofItsIntervals()},
        {"max_turn_rate", "rad/s", Better::More, atLeast,
         ODO_TEXT("analysis.metric_max_turn_rate", "Fastest turn"),
         ODO_TEXT("analysis.formula_max_turn_rate",
                  "How fast the robot turns, to the left or right, where the amount minus 3σ is largest. Of "
                  "the body where its heading was measured, also on the spot: the rate of the smoothed "
                  "heading. Elsewhere of the direction of motion: (vx·ay − vy·ax)/|v|² of the smoothed "
                  "curve. \"At least\" where it may have turned faster because the rate is hardly known."),
         ODO_TEXT("analysis.uncertainty_max_turn_rate",
                  "of the body: that of the smoothed heading's rate; of the direction of motion: "
                  "σ² = σa²/|v|² + |a|²σv²/|v|⁴, first order; of n peaks within 2σ also σ√(2 ln n)")},
        {"circle_radius", "m", Better::More, 0, ODO_TEXT("analysis.metric_circle_radius", "Circle's radius"),
         ODO_TEXT("analysis.formula_circle_radius",
                  "The least-squares circle through the positions of the motion."),
         ODO_TEXT("analysis.uncertainty_circle_radius",
                  "of the scatter of the distances, with their number divided by 1 + 2Σρ for correlated "
                  "neighbours, and the calibration's scale uncertainty"),
         "Kåsa 1976; Gauss–Newton"},
        {"displacement", "m", Better::More, 0, ODO_TEXT("analysis.metric_displacement", "Displacement")},
        {"spikes", "1", Better::More, scored, ODO_TEXT("analysis.metric_spikes", "Spikes")},
        {"limit_breaches", "1", Better::More, scored,
         ODO_TEXT("analysis.metric_limit_breaches", "Limits broken")},
        {"mean_view_disagreement", "m", Better::More, 0,
         ODO_TEXT("analysis.metric_mean_view_disagreement", "Views disagree by")},
        {"height", "m", Better::More, 0, ODO_TEXT("analysis.metric_height", "Robot's height")},
        {"score", "points", Better::More, 0, ODO_TEXT("analysis.metric_score", "Score")},
    };
}

} // namespace

const std::vector<MetricKind> &metricKinds()
{
    static const std::vector<MetricKind> kinds = allKinds();
    return kinds;
}

const MetricKind *metricKind(std::string_view id)
{
    const auto found = std::ranges::find(metricKinds(), id, &MetricKind::id);
    return found == metricKinds().end() ? nullptr : &*found;
}

} // namespace odo
