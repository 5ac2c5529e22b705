// SPDX-License-Identifier: GPL-3.0-or-later
// Robots of many looks in many kinds of scenes, without a word about them. Some minutes: the table of docs/accuracy.md.
#include "core/simulation/demo_testbed.h"
#include "tests/workflow/measured_scene.h"

#include <QTest>
#include <functional>

using namespace odo;
using namespace odo::test;

namespace {

using Vector = Eigen::Vector3d;
using Parts = std::vector<RobotPart>;
using S = SimulatedShape;

constexpr RgbColour black{28, 28, 30}, white{238, 238, 235}, grey{120, 120, 122}, asFloor{182, 177, 166}, red{200, 35, 40}, yellow{215, 190, 40}, green{50, 140, 60},
    blue{30, 60, 150};

/// A body with four black wheels: middles of their axles at ±x, ±y.
Parts wheeled(Parts parts, double x, double y, double radius, double width)
{
    for (const double atX : {x, -x})
        for (const double atY : {y, -y})
            parts.push_back({S::Wheel, black, {atX, atY, radius}, {2 * radius, width, 2 * radius}});
    return parts;
}

Parts chassis(RgbColour colour)
{
    return wheeled({{S::Box, colour, {0, 0, 0.05}, {0.22, 0.14, 0.05}}}, 0.07, 0.085, 0.03, 0.028);
}

void setLamp(SimulatedScene &scene)
{
    scene.lamps = {Lamp{{0.4, 0.2, 2.4}, 0.12, 0.3}};
}
void setPlainFloor(SimulatedScene &scene)
{
    scene.floor.textureAmplitude = 0.01;
    scene.lamps = {Lamp{{2.6, 0.2, 2.4}, 0.2, 0.4}};
}
void setGloss(SimulatedScene &scene)
{
    scene.floor.gloss = 0.25;
}
void setDrift(SimulatedScene &scene)
{
    for (SimulatedCamera &camera : scene.cameras) {
        camera.sensor.gainDriftPerS = 0.015;
        camera.sensor.flickerAmplitude = 0.03;
    }
}
void addBystander(SimulatedScene &scene, const char *name, double heightM, Parts parts, std::shared_ptr<const Motion> motion)
{
    SimulatedRobot bystander;
    bystander.name = name;
    bystander.heightM = heightM;
    bystander.parts = std::move(parts);
    bystander.motion = std::move(motion);
    scene.bystanders = {bystander};
}
void addPerson(SimulatedScene &scene)
{
    const RgbColour trousers{40, 50, 90};
    addBystander(scene, "person", 1.7,
                 {{S::Cylinder, trousers, {0, 0.1, 0.45}, {0.15, 0.15, 0.9}}, {S::Cylinder, trousers, {0, -0.1, 0.45}, {0.15, 0.15, 0.9}},
                  {S::Cylinder, {150, 60, 60}, {0, 0, 1.3}, {0.35, 0.35, 0.8}}},
                 makeLineMotion({-0.2, 2.3}, {3.2, 2.4}, 1, 6));
}
void addBall(SimulatedScene &scene)
{
    addBystander(scene, "ball", 0.07, {{S::Sphere, {230, 120, 30}, {0, 0, 0.035}, {0.07, 0.07, 0.07}}}, makeLineMotion({0.3, 2.0}, {2.7, 0.2}, 2, 5));
}

struct LookScene
{
    const char *name;
    Parts parts;
    std::function<void(SimulatedScene &)> set = {};
    bool ownsUp = false; ///< no solid explains it; what is stated must hold all the same
};

const std::vector<LookScene> &lookScenes()
{
    static const std::vector<LookScene> scenes{
        {"black vacuum cleaner, round", {{S::Cylinder, black, {0, 0, 0.05}, {0.30, 0.30, 0.08}}}},
        {"white sphere", {{S::Sphere, white, {0, 0, 0.09}, {0.18, 0.18, 0.18}}}},
        {"box of two colours, lamp", {{S::Box, red, {0.06, 0, 0.045}, {0.12, 0.16, 0.09}}, {S::Box, blue, {-0.06, 0, 0.045}, {0.12, 0.16, 0.09}}}, setLamp},
        {"green with tracks, plain floor, strong lamp",
         {{S::Box, black, {0, 0.08, 0.03}, {0.24, 0.045, 0.06}}, {S::Box, black, {0, -0.08, 0.03}, {0.24, 0.045, 0.06}}, {S::Box, green, {0.01, 0, 0.06}, {0.2, 0.114, 0.05}}},
         setPlainFloor},
        {"red rover with a deck and a mast, lamp",
         wheeled({{S::Box, red, {0, 0, 0.045}, {0.25, 0.15, 0.046}}, {S::Box, yellow, {-0.02, 0, 0.078}, {0.14, 0.11, 0.02}}, {S::Cylinder, grey, {-0.06, 0, 0.148}, {0.016, 0.016, 0.12}}},
                 0.085, 0.09, 0.033, 0.03),
         setLamp},
        {"white rover, glossy floor", chassis(white), setGloss},
        {"red rover, a person walks", chassis(red), addPerson},
        {"white rover, a ball rolls", chassis(white), addBall},
        {"yellow rover, light drifts and flickers", chassis(yellow), setDrift},
        {"small black rover", wheeled({{S::Box, black, {0, 0, 0.03}, {0.12, 0.08, 0.03}}}, 0.04, 0.05, 0.02, 0.02)},
        {"as the floor, with black wheels, lamp", wheeled({{S::Box, asFloor, {0, 0, 0.06}, {0.26, 0.16, 0.06}}}, 0.085, 0.095, 0.035, 0.03), setLamp, true},
        {"grey rover, plain floor, strong lamp", chassis(grey), setPlainFloor, true},
    };
    return scenes;
}

} // namespace

class TestRobotLooks : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void areMeasured_data()
    {
        QTest::addColumn<int>("number");
        QTest::addColumn<int>("seed");
        for (int number = 0; number < int(lookScenes().size()); ++number)
            for (int seed = 1; seed <= 3; ++seed)
                QTest::addRow("%s, %d", lookScenes()[std::size_t(number)].name, seed) << number << seed;
    }
    void areMeasured()
    {
        QFETCH(int, number);
        QFETCH(int, seed);
        const LookScene &look = lookScenes()[std::size_t(number)];
        SimulatedScene scene = demoTestbed(std::uint32_t(100 * seed + number));
        scene.durationS = 8;
        scene.floor.textureSeed = std::uint32_t(seed);
        if (look.set)
            look.set(scene);
        SimulatedRobot robot;
        robot.name = look.name;
        robot.parts = look.parts;
        robot.heightM = 0.1;
        const std::shared_ptr<const Motion> ways[] = {makeFigureEightMotion({1.5, 1.1}, 0.9, 0.55, 6, 0.5), makeCircleMotion({1.5, 1.1}, 0.7, 0.7, 0.6),
                                                      makeEllipseMotion({1.5, 1.1}, 0.9, 0.5, 7, 0.3, 0.5)};
        robot.motion = ways[(number + seed) % 3];
        scene.robots = {robot};
        const auto figures = measuredScene(scene);
        QVERIFY2(figures.has_value(), figures ? "" : figures.error().message().c_str());
        qInfo("%s", qPrintable(figures->words()));
        const bool holds = figures->insideShare > 0.8;
        QVERIFY2(look.ownsUp ? holds : holds && figures->foundShare > 0.995 && figures->rmsM < 0.004 && figures->spikes <= 3, qPrintable(figures->words()));
    }
};

QTEST_GUILESS_MAIN(TestRobotLooks)
#include "tst_robot_looks.moc"
