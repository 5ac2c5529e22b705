// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/motion_stretches.h"

#include <vector>

namespace odo {

/// The way driven from the start of a stretch of motion to each of its instants, metres: the integral of the
/// speed by the trapezoidal rule, with the ramp from the threshold to the first instant. As long as the
/// stretch.
std::vector<double> waysOf(const MotionStretch &motion, const std::vector<RunInstant> &instants);

/// The length of a stretch of motion: waysOf and the ramp at its end, metres.
double lengthOf(const MotionStretch &motion, const std::vector<RunInstant> &instants);

/// The way that was driven up to each sample, metres; it never falls, and ends with the metric path_length.
/// While the robot stands, and where its points are not valid, it stays. As long as samples.
std::vector<double> drivenWay(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points);

} // namespace odo
