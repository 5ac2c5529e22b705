// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/simulation/scene.h"
#include "core/video/frame.h"
#include "core/video/video_writer.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace odo {

/// Paints what one camera of a scene sees, frame by frame, with edges antialiased to a small part of a pixel.
/// The still floor is painted once; a frame costs only what moves. Not thread-safe; make one a thread.
class SceneRenderer
{
public:
    SceneRenderer(SimulatedScene scene, int camera);
    ~SceneRenderer();
    SceneRenderer(const SceneRenderer &) = delete;
    SceneRenderer &operator=(const SceneRenderer &) = delete;

    std::int64_t frameCount() const;
    /// The scene's robots are others from the next frame on.
    void setRobots(std::vector<SimulatedRobot> robots);
    /// 4:2:0, limited range, BT.601, with the sensor's siting, noise and blur. The sensor is linear: an
    /// edge's pixels are the mean, in code values, of what they cover. About 2 ms for 1280×720.
    Frame render(std::int64_t frame);

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Renders one camera to a video file. Errors: those of VideoWriter; Cancelled, leaving no file behind.
Result<void> renderVideo(const SimulatedScene &scene, int camera, const OutputTarget &target,
                         const VideoWriterOptions &options, const JobControl &control);

/// A calibration board held before a camera, painted through its lens. Checkerboard or ChArUco 6X6_250; the
/// latter in OpenCV 4.6's layout, with an odd number of squares down (an even number of inner rows), for
/// which all versions agree.
struct SimulatedBoard
{
    bool charuco = false;
    int columns = 9, rows = 6; ///< inner corners
    double squareM = 0.025;
    double markerRatio = 0.5;       ///< ChArUco: marker side / square side
    RigidTransform cameraFromBoard; ///< board: origin at the first inner corner, x along columns, y along
                                    ///< rows; seen from the front, x to the right and y down
};
/// Noise of sigma noiseSigma (of 255), sampled as a camera does (4:2:0, Left, limited range).
Frame renderBoard(const CameraModel &camera, const SimulatedBoard &board, double noiseSigma,
                  std::uint32_t seed);

/// Poses (cameraFromBoard) as a careful person would hold a board: spread over the frame, near and far,
/// tilted up to 40° to all sides, all corners in the frame. The same for a seed.
std::vector<RigidTransform> heldBoardPoses(const CameraModel &camera, const SimulatedBoard &board, int count,
                                           std::uint32_t seed);

} // namespace odo
