// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/silhouette.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/internal/exposure.h"
#include "core/simulation/renderer.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>

using namespace odo;

namespace {

constexpr RgbColour red{215, 35, 40}, grey{128, 128, 128};
constexpr double atS = 1.0; // of the exposures

/// A grey floor without shadows, filmed without blur and noise.
SimulatedScene plainScene()
{
    SimulatedScene scene = demoTestbed(1);
    scene.durationS = 8;
    scene.floor.colour = grey;
    scene.floor.surroundings = grey;
    scene.floor.textureAmplitude = 0;
    scene.floor.tileM = 100;
    scene.floor.markerSideM = 0;
    scene.floor.shadowStrength = 0;
    for (SimulatedCamera &camera : scene.cameras) {
        camera.sensor.noiseSigma = 0;
        camera.sensor.exposureS = 0;
    }
    return scene;
}

/// At a place at atS, with an even velocity and its length along X.
SimulatedRobot robotWith(const Eigen::Vector2d &position, const Eigen::Vector2d &velocity)
{
    SimulatedRobot robot;
    robot.colour = red;
    robot.heightM = 0.2;
    constexpr double rampS = 0.02; // whose half is lost
    robot.motion = makeVelocityMotion(position - velocity * (atS - rampS / 2), 0, {{0, rampS, velocity}});
    return robot;
}

std::vector<PaintedThing> filmed(const SimulatedScene &scene, double timeS = atS)
{
    const FloorView &view = scene.cameras[0].view;
    return thingsInExposure(scene, 0, ImageOutline(view.camera(), view.cameraFromWorld()), timeS);
}

std::vector<Eigen::Vector2d> cornersOf(const PaintedThing &thing)
{
    std::vector<Eigen::Vector2d> corners;
    for (const PaintedPiece &piece : thing.pieces)
        corners.insert(corners.end(), piece.outline.begin(), piece.outline.end());
    return corners;
}

/// Where a shutter that reads a row after the other sees the eight corners of a box: each where it is when
/// its own row is read.
std::vector<Eigen::Vector2d> rolledCorners(const SimulatedScene &scene, const SimulatedRobot &robot,
                                           double readoutS)
{
    const FloorView &view = scene.cameras[0].view;
    const int rows = view.camera().intrinsics().heightPx;
    std::vector<Eigen::Vector2d> corners;
    for (const double x : {-robot.lengthM / 2, robot.lengthM / 2}) {
        for (const double y : {-robot.widthM / 2, robot.widthM / 2}) {
            for (const double z : {0.0, robot.heightM}) {
                Eigen::Vector2d pixel(0, (rows - 1) / 2.0);
                for (int i = 0; i < 20; ++i) {
                    const Eigen::Vector2d position =
                        robot.motion->at(atS + readoutS * (pixel.y() / (rows - 1) - 0.5)).position;
                    pixel = *view.pixelFromWorld({position.x() + x, position.y() + y, z});
                }
                corners.push_back(pixel);
            }
        }
    }
    return corners;
}

double worstDifference(const std::vector<Eigen::Vector2d> &a, const std::vector<Eigen::Vector2d> &b)
{
    const std::vector<float> reachA = supportOf(a, a.front()), reachB = supportOf(b, a.front());
    double worst = 0;
    for (std::size_t k = 0; k < reachA.size(); ++k)
        worst = std::max(worst, double(std::abs(reachA[k] - reachB[k])));
    return worst;
}

bool samePieces(const std::vector<PaintedThing> &a, const std::vector<PaintedThing> &b)
{
    if (a.size() != b.size())
        return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].pieces.size() != b[i].pieces.size())
            return false;
        for (std::size_t k = 0; k < a[i].pieces.size(); ++k)
            if (a[i].pieces[k].outline != b[i].pieces[k].outline ||
                a[i].pieces[k].weight != b[i].pieces[k].weight)
                return false;
    }
    return true;
}

/// Luma of a frame at a point of the floor, in code values.
double lumaAt(const SimulatedScene &scene, std::int64_t frame, const Eigen::Vector2d &point)
{
    const Eigen::Vector2d pixel = *scene.cameras[0].view.pixelFromWorld({point.x(), point.y(), 0});
    return SceneRenderer(scene, 0).render(frame).y.at(int(std::lround(pixel.x())),
                                                      int(std::lround(pixel.y())));
}

/// Of a grey of 128 that a share of white or, negative, of black is laid over.
double lumaOfGrey(double share)
{
    const double value = share > 0 ? 128 + share * (255 - 128) : 128 * (1 + share);
    return 16 + value * 219 / 255;
}

} // namespace

class TestExposure : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aRollingShutterSeesEachRowAtItsTime_data()
    {
        QTest::addColumn<double>("readout");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("vx");
        QTest::addColumn<double>("vy");
        QTest::newRow("sideways, low in the picture") << 0.02 << 0.3 << 0.2 << 0.0 << 1.5;
        QTest::newRow("along, low in the picture") << 0.02 << 0.3 << 0.2 << 1.5 << 0.0;
        QTest::newRow("sideways, high in the picture") << 0.02 << 2.4 << 1.8 << 0.0 << 1.5;
        QTest::newRow("towards the camera") << 0.03 << 0.6 << 0.5 << -1.0 << -1.0;
        QTest::newRow("all rows at once") << 0.0 << 0.3 << 0.2 << 0.0 << 1.5;
    }
    void aRollingShutterSeesEachRowAtItsTime()
    {
        QFETCH(double, readout);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, vx);
        QFETCH(double, vy);
        SimulatedScene scene = plainScene();
        const SimulatedRobot robot = robotWith({x, y}, {vx, vy});
        QVERIFY((robot.motion->at(atS).position - Eigen::Vector2d(x, y)).norm() < 1e-9);
        scene.robots = {robot};
        scene.cameras[0].sensor.readoutS = readout;
        const auto things = filmed(scene);
        QCOMPARE(things.size(), std::size_t(1));
        // Right to first order: 0.006 px were off when this was written.
        const double worst = worstDifference(cornersOf(things.front()), rolledCorners(scene, robot, readout));
        const double moved =
            worstDifference(rolledCorners(scene, robot, readout), rolledCorners(scene, robot, 0));
        QVERIFY2(worst < 0.03, qPrintable(QString::number(worst)));
        // else the test would say nothing
        QVERIFY2(readout == 0 ? moved == 0 : moved > 1, qPrintable(QString::number(moved)));
    }

    void whatStandsIsSeenAsByAGlobalShutter()
    {
        SimulatedScene scene = plainScene();
        scene.floor.shadowStrength = 0.3;
        scene.floor.gloss = 0.1;
        scene.robots = {robotWith({0.3, 0.2}, {0, 0})};
        const auto global = filmed(scene);
        scene.cameras[0].sensor.readoutS = 0.02;
        QVERIFY(samePieces(global, filmed(scene)));
        scene.robots = {robotWith({0.3, 0.2}, {0, 1})};
        QVERIFY(!samePieces(global, filmed(scene)));
    }

    /// With its body: the shadow is that of the same moment.
    void theShadowGoesWithTheBody()
    {
        SimulatedScene scene = plainScene();
        scene.floor.shadowStrength = 0.3;
        const SimulatedRobot robot = robotWith({0.3, 0.2}, {0, 1.5});
        scene.robots = {robot};
        scene.cameras[0].sensor.readoutS = 0.02;
        const FloorView &view = scene.cameras[0].view;
        const double row = view.pixelFromWorld({0.3, 0.2, 0.1})->y();
        const double seenS = atS + 0.02 * (row / (view.camera().intrinsics().heightPx - 1) - 0.5);
        const auto rolled = filmed(scene);
        scene.cameras[0].sensor.readoutS = 0;
        const auto then = filmed(scene, seenS);
        QCOMPARE(rolled.size(), std::size_t(2));
        QVERIFY(worstDifference(cornersOf(rolled.front()), cornersOf(then.front())) < 0.01);
        QVERIFY(worstDifference(cornersOf(rolled.front()), cornersOf(filmed(scene).front())) > 1);
    }

    void localLightRisesAndFadesToItsEdge_data()
    {
        QTest::addColumn<double>("strength");
        QTest::newRow("the sun comes") << 0.2;
        QTest::newRow("a cloud comes") << -0.2;
    }
    void localLightRisesAndFadesToItsEdge()
    {
        QFETCH(double, strength);
        SimulatedScene scene = plainScene();
        const Eigen::Vector2d middle(1.4, 1.0);
        scene.localLights = {{middle, 0.6, strength, 1.0, 4.0}};
        // thirty frames a second
        const std::pair<int, double> rising[] = {{0, 0.0},  {29, 0.0},  {60, 0.25},
                                                 {90, 0.5}, {150, 1.0}, {200, 1.0}};
        for (const auto &[frame, share] : rising) {
            const double luma = lumaAt(scene, frame, middle + Eigen::Vector2d(0.005, 0));
            // whole numbers
            QVERIFY2(std::abs(luma - lumaOfGrey(share * strength)) < 0.6,
                     qPrintable(QStringLiteral("%1: %2").arg(frame).arg(luma)));
        }
        // 24 steps to the edge; each place lies within one.
        for (const double part : {0.26, 0.51, 0.76}) {
            const double luma = lumaAt(scene, 200, middle + Eigen::Vector2d(0.6 * part, 0));
            QVERIFY2(std::abs(luma - lumaOfGrey((1 - part) * strength)) < 1.7,
                     qPrintable(QStringLiteral("%1: %2").arg(part).arg(luma)));
        }
        for (const double beyond : {0.63, 1.0})
            QVERIFY(std::abs(lumaAt(scene, 200, middle + Eigen::Vector2d(beyond, 0)) - lumaOfGrey(0)) < 0.6);
    }

    void whatStandsInLocalLightIsNotLit()
    {
        SimulatedScene scene = plainScene();
        scene.robots = {robotWith({1.4, 1.0}, {0, 0})};
        const double before = lumaAt(scene, 100, {1.4, 1.0});
        scene.localLights = {{{1.4, 1.0}, 0.6, 0.2, 0, 1}};
        QCOMPARE(lumaAt(scene, 100, {1.4, 1.0}), before);
        QVERIFY(lumaAt(scene, 100, {1.0, 1.0}) > lumaOfGrey(0) + 3);
    }
};

ODOGRAPH_TEST(TestExposure, QCoreApplication)
#include "tst_exposure.moc"
