// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/renderer.h"

#include "core/simulation/exposure.h"
#include "core/simulation/floor_painter.h"
#include "core/simulation/polygon_layer.h"
#include "core/simulation/random_hash.h"
#include "core/simulation/sensor.h"

#include <cassert>

namespace odo {
namespace {

/// Room for the chroma filter on all sides, on even pixels.
PixelRect dirtyRect(const PixelRect &bounds, const PixelRect &picture)
{
    constexpr int margin = 4;
    const PixelRect even = {(bounds.x0 - margin) & ~1, (bounds.y0 - margin) & ~1,
                            (bounds.x1 + margin + 1) & ~1, (bounds.y1 + margin + 1) & ~1};
    return even.clipped(picture);
}

/// Joins rectangles until no two meet.
std::vector<PixelRect> disjoint(const std::vector<PixelRect> &rects)
{
    std::vector<PixelRect> result;
    for (PixelRect rect : rects) {
        // What it meets is taken out and joined to it, until it meets nothing.
        for (auto other = result.begin(); other != result.end();) {
            if (!other->meets(rect)) {
                ++other;
                continue;
            }
            rect = rect.united(*other);
            result.erase(other);
            other = result.begin();
        }
        result.push_back(rect);
    }
    return result;
}

void checkRobots([[maybe_unused]] const std::vector<SimulatedRobot> &robots)
{
    for ([[maybe_unused]] const SimulatedRobot &robot : robots)
        assert(robot.motion && robot.lengthM > 0 && robot.widthM > 0 && robot.heightM > 0);
}

const SimulatedCamera &checkedCamera(const SimulatedScene &scene, int camera)
{
    assert(camera >= 0 && camera < static_cast<int>(scene.cameras.size()));
    checkRobots(scene.robots);
    const SimulatedCamera &checked = scene.cameras[static_cast<std::size_t>(camera)];
    assert(checked.framesPerSecond > 0 && checked.sensor.exposureS >= 0 && checked.sensor.noiseSigma >= 0);
    return checked;
}

} // namespace

struct SceneRenderer::Impl
{
    Impl(SimulatedScene theScene, int theCamera)
        : scene(std::move(theScene)), camera(theCamera), settings(checkedCamera(scene, camera)),
          outline(settings.view.camera(), settings.view.cameraFromWorld()),
          still(paintFloor(scene.floor, settings.view)),
          sensor(settings.sensor, outline.pictureRect().x1, outline.pictureRect().y1,
                 randomHash(scene.seed, static_cast<std::uint64_t>(camera)))
    {
        sensor.take(still);
        sensor.keepStill();
    }

    void paint(const std::vector<PaintedThing> &things)
    {
        for (const PixelRect &rect : dirty)
            sensor.restore(rect);
        dirty.clear();
        for (const PaintedThing &thing : things)
            dirty.push_back(dirtyRect(thing.bounds, outline.pictureRect()));
        dirty = disjoint(dirty);
        for (const PixelRect &rect : dirty) {
            RgbPicture part = still.part(rect);
            for (const PaintedThing &thing : things) {
                if (!thing.bounds.meets(rect))
                    continue;
                PolygonLayer layer(thing.bounds);
                for (const PaintedPiece &piece : thing.pieces)
                    layer.add(piece.outline, piece.colour, piece.weight);
                layer.paintOver(part);
            }
            sensor.take(part);
        }
    }

    SimulatedScene scene;
    const int camera;
    const SimulatedCamera &settings;
    const PictureOutline outline;
    const RgbPicture still;
    Sensor sensor;
    std::vector<PixelRect> dirty; ///< where the sensor differs from the still picture; disjoint
};

SceneRenderer::SceneRenderer(SimulatedScene scene, int camera)
    : m_impl(std::make_unique<Impl>(std::move(scene), camera))
{
}

SceneRenderer::~SceneRenderer() = default;

std::int64_t SceneRenderer::frameCount() const
{
    return odo::frameCount(m_impl->scene, m_impl->camera);
}

void SceneRenderer::setRobots(std::vector<SimulatedRobot> robots)
{
    checkRobots(robots);
    m_impl->scene.robots = std::move(robots);
}

Frame SceneRenderer::render(std::int64_t frame)
{
    Impl &d = *m_impl;
    assert(frame >= 0);
    const double timeS = frameSceneTime(d.scene, d.camera, frame);
    d.paint(thingsInExposure(d.scene, d.camera, d.outline, timeS));
    const auto picture = static_cast<std::uint64_t>(framePicture(d.scene, d.camera, frame));
    const SensorModel &model = d.settings.sensor;
    const double gain =
        gainInExposure(model, timeS) * lightInExposure(d.scene.lights, model.exposureS, timeS);
    return FrameBuffer::toFrame(d.sensor.read(gain, picture), frame, frameStamp(d.scene, d.camera, frame));
}

} // namespace odo
