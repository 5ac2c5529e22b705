// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/internal/fused_track.h"
#include "core/trajectory/internal/kalman_smoother.h"

#include <vector>

namespace odo {

/// How lively the motion is along a run: sets each node's liveliness, relative to usualDensity, the jerk
/// density of the whole run. Filters of several densities run over each segment in both directions; each step
/// is explained by one of them, which changes seldom (a hidden Markov model: Rabiner 1989, § III), and gets
/// the mean of their logarithms by their probabilities. How likely each of them is beforehand is learnt from
/// the run (Rabiner's § III.C). Hence an impact does not roughen the slide before it, a robot at rest is
/// averaged for as long as it rests, and of a motion that is the same throughout all of it is evidence.
void adaptToMotion(std::vector<TrackSegment> &segments, const MotionNoise &noise, double usualDensity);

} // namespace odo
