// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/internal/kalman_smoother.h"

#include <span>
#include <vector>

namespace odo {

/// Noise by maximum likelihood of the innovations (prediction error decomposition: Harvey 1989, § 3.4) over
/// all segments: the measurement scale in closed form, the jerk density by a logarithmic grid and a golden
/// section. The scale is drawn to that of `measurement` as by so many more innovations as its trust, so that
/// few samples change little; its slow part is taken over. robust: an innovation beyond refusalGate counts as
/// the gate and is not taken in (for data with spikes), and the scale stays.
MotionNoise estimateMotionNoise(const std::vector<std::span<const TrackNode>> &segments, bool robust,
                                const MeasurementNoise &measurement = {});

/// The measurement's noise with the wobble or drift that the track shows, at the scale of `measurement`: by
/// maximum likelihood again, with the jerk density; without one where it does not explain the track much
/// better. Of what a robot does itself it takes nothing: a smooth wobble is faster than a third of a second,
/// and a few millimetres; a drift changes in steps that no mass can follow. A drift is as wide as the track
/// lets it be. still: the noise if nothing wobbles, as estimateMotionNoise gives it.
MeasurementNoise withWobble(const std::vector<std::span<const TrackNode>> &segments,
                            const MeasurementNoise &measurement, const MotionNoise &still);

} // namespace odo
