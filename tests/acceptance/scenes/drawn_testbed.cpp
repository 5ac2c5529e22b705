// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/drawn_testbed.h"

#include "core/simulation/demo_testbed.h"

#include <functional>

namespace odo::test {

namespace {

constexpr double floorLengthM = 3.0, floorWidthM = 2.2;
constexpr int widthPx = 1280, heightPx = 720;
constexpr double markerBorderPx = 12;

/// Draws views until one sees what it must; the places are chosen so that one in some tens does.
FloorView viewThat(const std::function<FloorView()> &drawn, const std::vector<Eigen::Vector2d> &points)
{
    for (;;) {
        FloorView view = drawn();
        const bool seesAll = std::all_of(points.begin(), points.end(), [&](const Eigen::Vector2d &point) {
            return isInImage(view, {point.x(), point.y(), 0}, markerBorderPx);
        });
        if (seesAll)
            return view;
    }
}

FloorView cornerView(SeededDraw &draw, Corner corner, double lowestM = 1.85, double highestM = 2.2)
{
    const bool right = corner == Corner::NearRight || corner == Corner::FarRight;
    const bool far = corner == Corner::FarLeft || corner == Corner::FarRight;
    const auto mirrored = [&](double x, double y, double z) {
        return Eigen::Vector3d(right ? floorLengthM - x : x, far ? floorWidthM - y : y, z);
    };
    const auto drawn = [&] {
        const Eigen::Vector3d camera =
            mirrored(draw.between(-1.1, -0.5), draw.between(-1.75, -1.2), draw.between(lowestM, highestM));
        const Eigen::Vector3d lookAt = mirrored(draw.between(1.2, 1.6), draw.between(0.6, 1.0), 0);
        return simulatedView(camera, lookAt, widthPx, heightPx,
                             draw.between(860, 1020) * (lowestM < 1.5 ? 0.85 : 1));
    };
    return viewThat(drawn, {{0, 0}, {floorLengthM, 0}, {0, floorWidthM}, {floorLengthM, floorWidthM}});
}

SensorModel drawnSensor(SeededDraw &draw)
{
    SensorModel sensor;
    sensor.exposureS = draw.between(0.004, 0.010);
    sensor.noiseSigma = draw.between(1.5, 2.5);
    return sensor;
}

SimulatedScene emptyFloor(SeededDraw &draw)
{
    SimulatedScene scene;
    scene.seed = static_cast<std::uint32_t>(draw.whole(1, 1'000'000));
    scene.floor.textureSeed = static_cast<std::uint32_t>(draw.whole(1, 1'000'000));
    scene.floor.markers = {"floor",
                           {{"O", {0, 0}},
                            {"U", {floorLengthM, 0}},
                            {"V", {0, floorWidthM}},
                            {"D", {floorLengthM, floorWidthM}}}};
    return scene;
}

void addCamera(SimulatedScene &scene, SeededDraw &draw, FloorView view)
{
    const std::string name(1, static_cast<char>('A' + scene.cameras.size()));
    const double offsetS = scene.cameras.size() == 1 ? draw.between(0, 0.033) : 0.0;
    scene.cameras.push_back({name, std::move(view), 30, offsetS, 0, drawnSensor(draw), 0});
}

} // namespace

bool isInImage(const FloorView &view, const Eigen::Vector3d &pointInWorld, double borderPx)
{
    const auto pixel = view.pixelFromWorld(pointInWorld);
    return pixel && pixel->x() > borderPx && pixel->y() > borderPx && pixel->x() < widthPx - 1 - borderPx &&
           pixel->y() < heightPx - 1 - borderPx;
}

SimulatedScene drawnTestbed(SeededDraw &draw, const Corners &corners)
{
    SimulatedScene scene = emptyFloor(draw);
    for (const Corner corner : corners)
        addCamera(scene, draw, cornerView(draw, corner));
    return scene;
}

SimulatedScene drawnTestbedFrom(SeededDraw &draw, double lowestM, double highestM)
{
    SimulatedScene scene = emptyFloor(draw);
    for (const Corner corner : {Corner::NearLeft, Corner::NearRight})
        addCamera(scene, draw, cornerView(draw, corner, lowestM, highestM));
    return scene;
}

SimulatedScene drawnHandOverTestbed(SeededDraw &draw)
{
    SimulatedScene scene = emptyFloor(draw);
    const Eigen::Vector2d nearMiddle(floorLengthM / 2, 0), farMiddle(floorLengthM / 2, floorWidthM);
    scene.floor.markers.markers.push_back({"M", nearMiddle});
    scene.floor.markers.markers.push_back({"N", farMiddle});
    for (const bool right : {false, true}) {
        const auto mirrored = [&](double x) { return right ? floorLengthM - x : x; };
        const auto drawn = [&] {
            const Eigen::Vector3d camera(mirrored(draw.between(0.6, 0.9)), draw.between(-2.1, -1.7),
                                         draw.between(1.9, 2.2));
            const Eigen::Vector3d lookAt(mirrored(draw.between(0.7, 0.85)), draw.between(0.75, 1.0), 0);
            return simulatedView(camera, lookAt, widthPx, heightPx, draw.between(1300, 1650));
        };
        const double own = mirrored(0);
        FloorView view = viewThat(drawn, {{own, 0}, {own, floorWidthM}, nearMiddle, farMiddle});
        addCamera(scene, draw, std::move(view));
    }
    return scene;
}

} // namespace odo::test
