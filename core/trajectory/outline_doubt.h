// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/observation.h"
#include "core/trajectory/internal/floor_positions.h"
#include "core/trajectory/internal/kalman_smoother.h"

#include <vector>

namespace odo {

/// How large the errors of the outlines are, and how they hang together, from the disagreement of the views,
/// in which the robot's motion cancels: half the mean squared change of the whitened disagreement over a way
/// s is σ²w + σ²s (1 − exp(−s/ℓ)) (the variogram of an Ornstein–Uhlenbeck process beside white noise:
/// Matheron 1963), fitted over the ways up to 0.4 m; longer ones show the calibration's change over the
/// floor.
/// views: sightings at the same times. With too few that two views share, or too short a way, what is usual.
MeasurementNoise estimateOutlineNoise(const std::vector<std::vector<Sighting>> &views);

/// Doubts the whole outlines of a robot whose thin parts (a cable, a mast) were left out of many others:
/// there they lie before or behind its body and cannot be told from it. Such outlines are not used to learn
/// its form, and tell its place only roughly. views: what each view saw of one robot, as tracked. Pure.
void doubtUntrimmed(const std::vector<std::vector<Observation> *> &views);

} // namespace odo
