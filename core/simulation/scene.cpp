// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/scene.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace odo {
namespace {

const SimulatedCamera &cameraOf(const SimulatedScene &scene, int camera)
{
    assert(camera >= 0 && camera < static_cast<int>(scene.cameras.size()));
    return scene.cameras[static_cast<std::size_t>(camera)];
}

bool contains(const std::vector<std::int64_t> &frames, std::int64_t frame)
{
    return std::find(frames.begin(), frames.end(), frame) != frames.end();
}

/// A fast clock counts its period sooner.
double periodInSceneS(const SimulatedCamera &camera)
{
    assert(camera.framesPerSecond > 0);
    return 1.0 / (camera.framesPerSecond * (1.0 + 1e-6 * camera.clockDriftPpm));
}

std::int64_t takenFrames(const SimulatedCamera &camera, double durationS)
{
    // The last frame is taken before the end; a millionth of a period forgives rounding of the division.
    const double periods = (durationS - camera.startOffsetS) / periodInSceneS(camera);
    return std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(periods - 1e-6)));
}

/// The frame that the camera took as the i-th of those that it delivered.
std::int64_t takenIndex(const SimulatedCamera &camera, std::int64_t delivered)
{
    std::vector<std::int64_t> dropped = camera.sensor.droppedFrames;
    std::sort(dropped.begin(), dropped.end());
    dropped.erase(std::unique(dropped.begin(), dropped.end()), dropped.end());
    for (const std::int64_t frame : dropped) {
        if (frame < 0)
            continue;
        if (frame > delivered)
            break;
        ++delivered;
    }
    return delivered;
}

} // namespace

std::int64_t frameCount(const SimulatedScene &scene, int camera)
{
    const SimulatedCamera &cam = cameraOf(scene, camera);
    const std::int64_t taken = takenFrames(cam, scene.durationS);
    std::int64_t delivered = 0;
    for (std::int64_t i = 0; i < taken; ++i)
        delivered += contains(cam.sensor.droppedFrames, i) ? 0 : 1;
    return delivered;
}

std::int64_t framePicture(const SimulatedScene &scene, int camera, std::int64_t frame)
{
    const SimulatedCamera &cam = cameraOf(scene, camera);
    std::int64_t picture = takenIndex(cam, frame);
    while (picture > 0 && contains(cam.sensor.doubledFrames, picture))
        --picture;
    return picture;
}

double frameSceneTime(const SimulatedScene &scene, int camera, std::int64_t frame)
{
    const SimulatedCamera &cam = cameraOf(scene, camera);
    return cam.startOffsetS + static_cast<double>(framePicture(scene, camera, frame)) * periodInSceneS(cam);
}

Nanoseconds frameStamp(const SimulatedScene &scene, int camera, std::int64_t frame)
{
    const SimulatedCamera &cam = cameraOf(scene, camera);
    const std::int64_t periods = takenIndex(cam, frame) - takenIndex(cam, 0);
    return fromSeconds(static_cast<double>(periods) / cam.framesPerSecond);
}

double sceneTimeOfStamp(const SimulatedScene &scene, int camera, Nanoseconds stamp)
{
    const SimulatedCamera &cam = cameraOf(scene, camera);
    const double periods = static_cast<double>(takenIndex(cam, 0)) + toSeconds(stamp) * cam.framesPerSecond;
    return cam.startOffsetS + periods * periodInSceneS(cam);
}

} // namespace odo
