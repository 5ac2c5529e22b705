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

/// A fast clock shows a time sooner.
double sceneSeconds(const SimulatedCamera &camera, double clockS)
{
    return clockS / (1.0 + 1e-6 * camera.clockDriftPpm);
}

double periodInSceneS(const SimulatedCamera &camera)
{
    assert(camera.framesPerSecond > 0);
    return sceneSeconds(camera, 1.0 / camera.framesPerSecond);
}

/// When the camera takes its i-th frame, by its own clock. The first one is never early.
double clockOfTakenS(const SimulatedScene &scene, int camera, std::int64_t taken)
{
    const SimulatedCamera &cam = cameraOf(scene, camera);
    assert(cam.jitterS >= 0 && cam.jitterS < 0.5 / cam.framesPerSecond);
    const std::uint64_t key = randomHash(scene.seed, 0x6a17u + static_cast<std::uint64_t>(camera));
    const double jitter =
        taken > 0 ? cam.jitterS * randomSigned(key, static_cast<std::uint64_t>(taken)) : 0.0;
    return static_cast<double>(taken) / cam.framesPerSecond + jitter;
}

std::int64_t takenFrames(const SimulatedCamera &camera, double durationS)
{
    // The last frame is taken before the end; a millionth of a period forgives rounding of the division.
    const double periods = (durationS - camera.startOffsetS) / periodInSceneS(camera);
    return std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(periods - 1e-6)));
}

/// The frames, as taken, that are never delivered: rising, each once.
std::vector<std::int64_t> droppedFrames(const SimulatedCamera &camera)
{
    std::vector<std::int64_t> dropped = camera.sensor.droppedFrames;
    std::sort(dropped.begin(), dropped.end());
    dropped.erase(std::unique(dropped.begin(), dropped.end()), dropped.end());
    dropped.erase(dropped.begin(), std::lower_bound(dropped.begin(), dropped.end(), 0));
    return dropped;
}

/// The frame that the camera took as the i-th of those that it delivered.
std::int64_t takenIndex(const SimulatedCamera &camera, std::int64_t delivered)
{
    for (const std::int64_t frame : droppedFrames(camera)) {
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
    const std::vector<std::int64_t> dropped = droppedFrames(cam);
    return taken - (std::lower_bound(dropped.begin(), dropped.end(), taken) - dropped.begin());
}

std::int64_t sourceFrame(const SimulatedScene &scene, int camera, std::int64_t frame)
{
    const SimulatedCamera &cam = cameraOf(scene, camera);
    std::int64_t source = takenIndex(cam, frame);
    while (source > 0 && contains(cam.sensor.doubledFrames, source))
        --source;
    return source;
}

double frameSceneTime(const SimulatedScene &scene, int camera, std::int64_t frame)
{
    const SimulatedCamera &cam = cameraOf(scene, camera);
    const double clockS = clockOfTakenS(scene, camera, sourceFrame(scene, camera, frame));
    return cam.startOffsetS + sceneSeconds(cam, clockS);
}

Nanoseconds frameStamp(const SimulatedScene &scene, int camera, std::int64_t frame)
{
    const SimulatedCamera &cam = cameraOf(scene, camera);
    return fromSeconds(clockOfTakenS(scene, camera, takenIndex(cam, frame)) -
                       clockOfTakenS(scene, camera, takenIndex(cam, 0)));
}

double sceneTimeOfStamp(const SimulatedScene &scene, int camera, Nanoseconds stamp)
{
    const SimulatedCamera &cam = cameraOf(scene, camera);
    const double clockS = clockOfTakenS(scene, camera, takenIndex(cam, 0)) + toSeconds(stamp);
    return cam.startOffsetS + sceneSeconds(cam, clockS);
}

} // namespace odo
