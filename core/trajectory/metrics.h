// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/motion_stretches.h"
#include "core/trajectory/profile.h"

#include <vector>

namespace odo {

/// Figures of a whole run, always in this order and with these names:
/// duration (s, from the onset of motion to the last stop), path_length (m), mean_speed (m/s, path_length
/// over duration), max_speed, rms_speed (m/s), max_accel, rms_accel (m/s²), straightness (1, end to end over
/// path_length), moving_time (s), stops (1, pauses between onset and end), standing_time (s, in those
/// pauses), median_speed, p95_speed (m/s), p95_accel (m/s²; half and 95 % of the moving time stay below
/// them), max_turn_rate (rad/s, either way), and where the path is a circle circle_radius (m, fitCircle). Moving means faster than 20 mm/s and
/// than three σ of the speed, for at least three valid points in a row; the moments between frames are
/// interpolated. Only the speed while moving is integrated, so noise adds nothing to the path of a robot that
/// stands. Gaps that are not bridged contribute their straight line. σ: from the profile's σ; the
/// calibration's part as a common error of scale. A maximum is that of the smoothed curve (see largest). A
/// robot that never moves has a duration of 0, and 0 for all that hangs on it.
std::vector<Metric> measureRun(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points);
std::vector<Metric> measureRun(const std::vector<RunInstant> &instants);

/// The calibration's error of scale, relative: in σ of each of those figures that is a length or a speed or an
/// acceleration it is contained with its value times this. 0 without a valid point.
double sigmaOfScale(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points);

} // namespace odo
