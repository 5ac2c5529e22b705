// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/benchmark/metrics.h"

namespace odo::test {

/// Runs everything side by side, `rounds` times over after one that is not counted; each ratio is taken
/// within its round, and the median of the rounds is what counts. Empty when a clip cannot be read.
std::vector<Measurement> measureSpeed(const BenchmarkClips &clips, int rounds);

/// Centre errors against the truth beside those of CamShift.
std::vector<Measurement> measureCentres(const BenchmarkClips &clips);

/// Whole pictures are searched anew, every tenth frame by a tracker that has seen nothing: the share of
/// robots that are found within 3 px.
Measurement measureColdSearch(const BenchmarkClip &clip);

} // namespace odo::test
