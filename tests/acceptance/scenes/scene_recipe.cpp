// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/scene_recipe.h"

#include <sstream>

namespace odo::test {

namespace {

class Recipe
{
public:
    template <class... Values>
    void line(const char *what, const Values &...values)
    {
        m_text << what;
        ((m_text << ' ' << values), ...);
        m_text << '\n';
    }
    std::string text() const { return m_text.str(); }

private:
    std::ostringstream m_text;
};

void addCamera(Recipe &recipe, const SimulatedCamera &camera)
{
    const Intrinsics &lens = camera.view.camera().intrinsics();
    const RigidTransform &pose = camera.view.worldFromCamera();
    recipe.line("camera", camera.name, lens.widthPx, lens.heightPx, lens.fxPx, lens.fyPx, lens.cxPx,
                lens.cyPx);
    recipe.line("pose", pose.rotation.coeffs().transpose(), pose.translation.transpose());
    recipe.line("clock", camera.framesPerSecond, camera.startOffsetS, camera.clockDriftPpm, camera.jitterS);
    const SensorModel &sensor = camera.sensor;
    recipe.line("sensor", sensor.exposureS, sensor.noiseSigma, sensor.flickerAmplitude, sensor.flickerHz,
                sensor.gainDriftPerS, static_cast<int>(sensor.siting), sensor.readoutS);
    for (const auto frame : sensor.droppedFrames)
        recipe.line("dropped", frame);
    for (const auto frame : sensor.doubledFrames)
        recipe.line("doubled", frame);
}

void addRobot(Recipe &recipe, const SimulatedRobot &robot, double durationS)
{
    recipe.line("robot", robot.name, robot.colour.toString(), static_cast<int>(robot.shape), robot.lengthM,
                robot.widthM, robot.heightM);
    for (const RobotPart &part : robot.parts)
        recipe.line("part", static_cast<int>(part.shape), part.colour.toString(), part.centreM.transpose(),
                    part.sizeM.transpose());
    for (double t = 0; t < durationS; t += 0.25) {
        const MotionState state = robot.motion->at(t);
        recipe.line("at", state.position.transpose(), state.headingRad);
    }
}

} // namespace

std::string recipeOf(const AccuracyScene &scene)
{
    Recipe recipe;
    const SimulatedScene &s = scene.scene;
    recipe.line("scene", scene.name, scene.seed, s.durationS, s.seed, s.floor.textureSeed);
    recipe.line("recording", static_cast<int>(scene.recording.codec), scene.recording.bitRate,
                scene.recording.mjpegQuality);
    for (const Marker &marker : s.floor.markers.markers)
        recipe.line("marker", marker.label, marker.pointInWorld.transpose());
    for (const FloorPatch &patch : s.floor.patches)
        recipe.line("patch", patch.colour.toString(), patch.corners.front().transpose());
    for (const SimulatedCamera &camera : s.cameras)
        addCamera(recipe, camera);
    for (const SimulatedRobot &robot : s.robots)
        addRobot(recipe, robot, s.durationS);
    for (const SimulatedRobot &bystander : s.bystanders)
        addRobot(recipe, bystander, s.durationS);
    recipe.line("floor", s.floor.colour.toString(), s.floor.tileM, s.floor.textureAmplitude, s.floor.gloss,
                s.floor.shadowStrength);
    for (const Lamp &lamp : s.lamps)
        recipe.line("lamp", lamp.positionM.transpose(), lamp.radiusM, lamp.strength);
    for (const LocalLight &light : s.localLights)
        recipe.line("sun", light.position.transpose(), light.radiusM, light.strength, light.startS,
                    light.rampS);
    for (const Reflection &spot : s.reflections)
        recipe.line("reflection", spot.colour.toString(), spot.position.transpose(), spot.radiusM,
                    spot.startS, spot.durationS, spot.camera);
    for (const Occluder &board : s.occluders)
        recipe.line("board", board.colour.toString(), board.from.transpose(), board.to.transpose(),
                    board.heightM, board.startS, board.durationS);
    for (const LightChange &light : s.lights)
        recipe.line("light", light.gain, light.startS, light.durationS);
    return recipe.text();
}

} // namespace odo::test
