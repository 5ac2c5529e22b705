// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/simulation/scene.h"
#include "core/tracking/colour_tracker.h"

#include <filesystem>

namespace odo::test {

/// One rendered video of three coloured discs, and where they truly are in it.
struct BenchmarkClip
{
    SimulatedScene scene;
    std::filesystem::path file;

    std::int64_t frames() const { return frameCount(scene, 0); }
    std::vector<TrackTarget> targets(std::size_t robots) const;
    /// Centroid of what the camera sees of a robot, in luma pixels, in the middle of the exposure.
    Eigen::Vector2d trueCentre(std::size_t robot, std::int64_t frame) const;
    /// Half the size of its bounding box.
    Eigen::Vector2d trueHalfSize(std::size_t robot, std::int64_t frame) const;
};

struct BenchmarkClips
{
    BenchmarkClip h264, mjpeg;
};

/// The same scene as H.264 of 8 Mbit/s and as MJPEG of quality 3, 1280x720, 30 frames/s, in a folder; files
/// that are there are used again. The chroma of each is sited as its standard has it: left in H.264, centred
/// in JPEG.
Result<BenchmarkClips> provideClips(const std::filesystem::path &folder, double durationS);

} // namespace odo::test
