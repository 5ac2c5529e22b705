// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/benchmark/benchmark_clips.h"

namespace odo::test {

/// What tracking a clip cost, in CPU seconds of its thread, and where the robots were seen.
struct TrackedClip
{
    std::int64_t frames = 0;
    double decodeS = 0, afterS = 0;
    std::vector<std::vector<std::optional<Eigen::Vector2d>>> centres; ///< by frame and robot

    double seconds() const { return decodeS + afterS; }
    double afterPerFrameS() const { return afterS / static_cast<double>(frames); }
};

/// Decodes and tracks as the program does, on one thread, the two clocked apart frame by frame. `shown`:
/// every picture is decoded as a whole, for the screen. No frames when the clip cannot be read.
TrackedClip trackClip(const BenchmarkClip &clip, std::size_t robots, bool shown);

/// Distances to the true centres; those of robots that were not found are left out and counted.
struct CentreErrors
{
    double meanPx = 0, p95Px = 0;
    std::int64_t places = 0, notFound = 0;
};
CentreErrors centreErrors(const BenchmarkClip &clip, const TrackedClip &tracked);

} // namespace odo::test
