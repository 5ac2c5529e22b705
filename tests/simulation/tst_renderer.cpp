// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"
#include "core/simulation/internal/exposure.h"
#include "core/simulation/internal/robot_body.h"
#include "core/simulation/renderer.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <cmath>
#include <cstring>
#include <numbers>

using namespace odo;

namespace {

constexpr RgbColour red{215, 35, 40}, blue{31, 111, 208}, grey{128, 128, 128};

/// A plain grey floor, no noise, no shadow: only what the robots do to the picture.
SimulatedScene plainScene()
{
    SimulatedScene scene = demoTestbed(1);
    scene.durationS = 3;
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

SimulatedRobot robotAt(RgbColour colour, const Eigen::Vector2d &from, const Eigen::Vector2d &to,
                       SimulatedShape shape = SimulatedShape::Box)
{
    SimulatedRobot robot;
    robot.colour = colour;
    robot.shape = shape;
    robot.motion = makeLineMotion(from, to, 0.0, 2.0);
    return robot;
}

/// Centre of gravity of redness, luma pixels. The plain floor has none, so the plane weighs the faces by
/// their colour.
Eigen::Vector2d chromaCentroid(const Frame &frame)
{
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    double weight = 0;
    for (int y = 0; y < frame.v.height; ++y) {
        for (int x = 0; x < frame.v.width; ++x) {
            const double v = frame.v.at(x, y) - 128.0;
            weight += v;
            moment += v * Eigen::Vector2d(2 * x + frame.format.chromaOffsetX(),
                                          2 * y + frame.format.chromaOffsetY());
        }
    }
    return moment / weight;
}

bool isInside(const BodyFace &face, const Eigen::Vector3d &normal, const Eigen::Vector3d &point)
{
    int sides = 0;
    const int count = static_cast<int>(face.corners.size());
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector3d &a = face.corners[static_cast<std::size_t>(i)];
        const Eigen::Vector3d &b = face.corners[static_cast<std::size_t>((i + 1) % count)];
        sides += (b - a).cross(point - a).dot(normal) > 0 ? 1 : -1;
    }
    return std::abs(sides) == count;
}

/// What the V plane shows of a colour: whole numbers, which weigh the faces of a flat colour a little
/// differently.
double rednessOf(const Rgb &colour)
{
    const double r = static_cast<double>(colour[0]);
    const double luma =
        0.299 * r + 0.587 * static_cast<double>(colour[1]) + 0.114 * static_cast<double>(colour[2]);
    return std::round(224.0 / 255.0 / 1.402 * (r - luma));
}

/// The same centroid from first principles: rays through each pixel, back through the lens and onto the
/// faces.
Eigen::Vector2d rayCastCentroid(const SimulatedScene &scene, int camera, double timeS)
{
    const FloorView &view = scene.cameras[static_cast<std::size_t>(camera)].view;
    const SimulatedRobot &robot = scene.robots.front();
    const std::vector<BodyFace> faces = visibleFaces(robot, robot.motion->at(timeS), view.cameraInWorld());
    Eigen::Vector2d lower(1e9, 1e9), upper(-1e9, -1e9);
    for (const BodyFace &face : faces) {
        for (const Eigen::Vector3d &corner : face.corners) {
            lower = lower.cwiseMin(*view.pixelFromWorld(corner)).array().floor().matrix();
            upper = upper.cwiseMax(*view.pixelFromWorld(corner)).array().ceil().matrix();
        }
    }
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    double weight = 0;
    constexpr double step = 1.0 / 6;
    for (double y = lower.y() - 2 + step / 2; y < upper.y() + 2; y += step) {
        for (double x = lower.x() - 2 + step / 2; x < upper.x() + 2; x += step) {
            const Eigen::Vector3d ray = view.worldFromCamera().rotation * *view.camera().unproject({x, y});
            for (const BodyFace &face : faces) {
                const Eigen::Vector3d normal =
                    (face.corners[1] - face.corners[0]).cross(face.corners[2] - face.corners[1]);
                const double along = normal.dot(face.corners[0] - view.cameraInWorld()) / normal.dot(ray);
                if (!isInside(face, normal, view.cameraInWorld() + along * ray))
                    continue;
                weight += rednessOf(face.colour);
                moment += rednessOf(face.colour) * Eigen::Vector2d(x, y);
                break;
            }
        }
    }
    return moment / weight;
}

bool sameBytes(const Frame &a, const Frame &b)
{
    const auto same = [](const PlaneView &p, const PlaneView &q) {
        return std::memcmp(p.data, q.data,
                           static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height)) == 0;
    };
    return same(a.y, b.y) && same(a.u, b.u) && same(a.v, b.v);
}

int countOf(const Frame &frame, bool isRed, int threshold = 32)
{
    int count = 0;
    for (int y = 0; y < frame.v.height; ++y)
        for (int x = 0; x < frame.v.width; ++x)
            count += (isRed ? frame.v.at(x, y) : frame.u.at(x, y)) > 128 + threshold;
    return count;
}

} // namespace

class TestRenderer : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aRobotIsSeenWhereItIs_data()
    {
        QTest::addColumn<int>("shape");
        QTest::addColumn<int>("camera");
        QTest::addColumn<ChromaSiting>("siting");
        QTest::newRow("box, A") << int(SimulatedShape::Box) << 0 << ChromaSiting::Left;
        QTest::newRow("box, B, centre") << int(SimulatedShape::Box) << 1 << ChromaSiting::Center;
        QTest::newRow("cylinder, A, top left") << int(SimulatedShape::Cylinder) << 0 << ChromaSiting::TopLeft;
    }
    void aRobotIsSeenWhereItIs()
    {
        QFETCH(int, shape);
        QFETCH(int, camera);
        QFETCH(ChromaSiting, siting);
        SimulatedScene scene = plainScene();
        scene.cameras[static_cast<std::size_t>(camera)].sensor.siting = siting;
        scene.robots = {robotAt(red, {0.9, 0.7}, {2.1, 1.5}, static_cast<SimulatedShape>(shape))};
        SceneRenderer renderer(scene, camera);
        for (const std::int64_t frame : {0, 33}) {
            const Eigen::Vector2d truth =
                rayCastCentroid(scene, camera, frameSceneTime(scene, camera, frame));
            const Eigen::Vector2d seen = chromaCentroid(renderer.render(frame));
            QVERIFY2(
                (seen - truth).norm() < 0.02,
                qPrintable(
                    QStringLiteral("off by %1, %2 px").arg(seen.x() - truth.x()).arg(seen.y() - truth.y())));
        }
    }

    void blurDoesNotMoveARobot()
    {
        SimulatedScene scene = plainScene();
        scene.robots = {robotAt(red, {0.5, 0.5}, {2.5, 1.6})};
        const Eigen::Vector2d sharp = chromaCentroid(SceneRenderer(scene, 0).render(30));
        scene.cameras[0].sensor.exposureS = 0.012;
        const Frame frame = SceneRenderer(scene, 0).render(30);
        // 2.1 m/s over 12 ms smear it over some 8 px; how much the perspective bends that is far below 0.03
        // px.
        QVERIFY((chromaCentroid(frame) - sharp).norm() < 0.03);
        scene.cameras[0].sensor.exposureS = 0;
        QVERIFY(countOf(frame, true, 1) > countOf(SceneRenderer(scene, 0).render(30), true, 1) + 10);
    }

    void aCylinderHasItsArea()
    {
        SimulatedRobot robot = robotAt(red, {1, 1}, {2, 1}, SimulatedShape::Cylinder);
        const std::vector<Eigen::Vector3d> base = footprint(robot, robot.motion->at(0), 0.0);
        double area = 0;
        for (std::size_t i = 0; i < base.size(); ++i) {
            const Eigen::Vector3d &a = base[i], &b = base[(i + 1) % base.size()];
            area += 0.5 * (a.x() * b.y() - a.y() * b.x());
        }
        QVERIFY(std::abs(area / (std::numbers::pi * 0.13 * 0.13) - 1) < 1e-9);
    }

    void framesDoNotDependOnTheirOrder()
    {
        const SimulatedScene scene = demoTrials().back().scene;
        SceneRenderer renderer(scene, 0);
        const Frame a = renderer.render(98), b = renderer.render(10), again = renderer.render(98);
        const Frame fresh = SceneRenderer(scene, 0).render(98);
        QVERIFY(sameBytes(a, again));
        QVERIFY(sameBytes(a, fresh));
        QVERIFY(!sameBytes(a, b));
        SimulatedScene other = scene;
        other.seed = 99;
        QVERIFY(!sameBytes(a, SceneRenderer(other, 0).render(98)));
    }

    void otherRobotsAreShownFromTheNextFrameOn()
    {
        SimulatedScene scene = demoTrials().front().scene;
        SceneRenderer renderer(scene, 0);
        const Frame before = renderer.render(70);
        renderer.setRobots(demoTrials().back().scene.robots);
        const Frame after = renderer.render(70);
        scene.robots = demoTrials().back().scene.robots;
        QVERIFY(sameBytes(after, SceneRenderer(scene, 0).render(70)));
        QVERIFY(!sameBytes(after, before));
        renderer.setRobots({});
        scene.robots.clear();
        QVERIFY(sameBytes(renderer.render(70), SceneRenderer(scene, 0).render(70)));
    }

    void aDoubledFrameIsACopy()
    {
        SimulatedScene scene = demoTrials().front().scene;
        scene.cameras[0].sensor.doubledFrames = {70};
        SceneRenderer renderer(scene, 0);
        const Frame first = renderer.render(69), copy = renderer.render(70), next = renderer.render(71);
        QVERIFY(sameBytes(first, copy));
        QVERIFY(!sameBytes(copy, next));
        QCOMPARE(copy.index, 70);
        QCOMPARE(copy.time, frameStamp(scene, 0, 70));
        QVERIFY(copy.time > first.time);
    }

    void theNearerRobotHidesTheOther()
    {
        SimulatedScene scene = plainScene();
        // On one line of sight of camera A, which stands at (-0.9, -1.55).
        SimulatedRobot near = robotAt(blue, {0.9, 0.6}, {0.9, 0.6001});
        near.heightM = 0.5;
        near.lengthM = near.widthM = 0.5;
        const SimulatedRobot far = robotAt(red, {1.25, 1.018}, {1.25, 1.0181});
        scene.robots = {near, far};
        QCOMPARE(countOf(SceneRenderer(scene, 0).render(0), true), 0);
        QVERIFY(countOf(SceneRenderer(scene, 1).render(0), true) > 0);
        std::swap(scene.robots[0], scene.robots[1]);
        QCOMPARE(countOf(SceneRenderer(scene, 0).render(0), true), 0);
    }

    void anOccluderHidesWhatIsBehindIt()
    {
        SimulatedScene scene = plainScene();
        scene.robots = {robotAt(red, {1.5, 1.1}, {1.5, 1.1001})};
        const int all = countOf(SceneRenderer(scene, 0).render(0), true);
        QVERIFY(all > 300);
        scene.occluders = {{grey, {0.8, 1.0}, {1.5, 0.4}, 0.6, 0.5, 1.0}};
        SceneRenderer front(scene, 0);
        QCOMPARE(countOf(front.render(5), true), all);
        QCOMPARE(countOf(front.render(25), true), 0);
        QCOMPARE(countOf(front.render(50), true), all);
        scene.occluders = {{grey, {1.2, 2.0}, {2.2, 1.2}, 0.3, 0, 9}};
        QCOMPARE(countOf(SceneRenderer(scene, 0).render(25), true), all);
    }

    void aReflectionIsSeenByItsCameraAtItsTime()
    {
        SimulatedScene scene = plainScene();
        scene.reflections = {{red, {1.5, 1.0}, 0.06, 1.0, 0.1, 1}};
        SceneRenderer a(scene, 0), b(scene, 1);
        QCOMPARE(countOf(a.render(31), true), 0);
        QVERIFY(countOf(b.render(31), true) > 50);
        QCOMPARE(countOf(b.render(28), true), 0);
        QCOMPARE(countOf(b.render(34), true), 0);
    }

    void lightFlickersAndDrifts()
    {
        SensorModel sensor;
        sensor.flickerAmplitude = 0.05;
        sensor.flickerHz = 100;
        sensor.exposureS = 0.010; // a whole period: the flicker averages out
        QVERIFY(std::abs(gainInExposure(sensor, 0.0025) - 1) < 1e-12);
        sensor.exposureS = 0;
        QVERIFY(std::abs(gainInExposure(sensor, 0.0025) - 1.05) < 1e-12);
        sensor.exposureS = 0.005; // the mean of half a period about its top is 2/π
        QVERIFY(std::abs(gainInExposure(sensor, 0.0025) - (1 + 0.05 * 2 / std::numbers::pi)) < 1e-12);
        sensor.gainDriftPerS = 0.01;
        sensor.flickerAmplitude = 0;
        QVERIFY(std::abs(gainInExposure(sensor, 2.0) - 1.02) < 1e-12);

        SimulatedScene scene = plainScene();
        scene.cameras[0].sensor.flickerAmplitude = 0.05;
        scene.cameras[0].sensor.flickerHz = 7.5; // at 30 frames/s: nothing, top, nothing, bottom
        SceneRenderer renderer(scene, 0);
        const double lit = 219.0 / 255 * 128;
        const double expected[] = {0.0, 0.05, 0.0, -0.05};
        for (int i = 0; i < 4; ++i)
            QVERIFY(std::abs(renderer.render(i).y.at(640, 400) - (16 + lit * (1 + expected[i]))) < 0.6);
    }

    void theRoomsLightChangesWithinAnExposure()
    {
        const std::vector<LightChange> lights{{1.4, 1.0, 0.5}, {0.5, 1.2, 1e9}};
        QCOMPARE(lightInExposure(lights, 0.01, 0.9), 1.0);
        QCOMPARE(lightInExposure(lights, 0.01, 1.1), 1.4);
        // three quarters of it are behind
        QVERIFY(std::abs(lightInExposure(lights, 0.01, 1.0025) - 1.3) < 1e-12);
        QVERIFY(std::abs(lightInExposure(lights, 0.01, 1.3) - 0.7) < 1e-12);
        QCOMPARE(lightInExposure(lights, 0.01, 2.0), 0.5);
    }

    void markersAreWhereTheLayoutSays()
    {
        const SimulatedScene scene = demoTestbed(3);
        const auto family = tag36h11_create();
        const auto detector = apriltag_detector_create();
        apriltag_detector_add_family(detector, family);
        detector->quad_decimate = 1.f;
        double sum = 0;
        for (int camera = 0; camera < 2; ++camera) {
            const Frame frame = SceneRenderer(scene, camera).render(0);
            image_u8_t image = {
                frame.y.width, frame.y.height, static_cast<std::int32_t>(frame.y.stride),
                const_cast<std::uint8_t *>(
                    frame.y.data)}; // NOLINT(cppcoreguidelines-pro-type-const-cast): is only read
            zarray_t *found = apriltag_detector_detect(detector, &image);
            QCOMPARE(zarray_size(found), 4);
            for (int i = 0; i < zarray_size(found); ++i) {
                apriltag_detection_t *tag = nullptr;
                zarray_get(found, i, &tag);
                const Eigen::Vector2d at =
                    scene.floor.markers.markers[static_cast<std::size_t>(tag->id)].pointInWorld;
                const auto truth =
                    scene.cameras[static_cast<std::size_t>(camera)].view.pixelFromWorld({at.x(), at.y(), 0});
                // The library's pixel centres are at one half.
                const Eigen::Vector2d seen(tag->c[0] - 0.5, tag->c[1] - 0.5);
                // The farthest tag is 34 × 18 px: the detector's own error there is 0.2 px, with or without
                // noise.
                const double error = (seen - *truth).norm();
                QVERIFY2(error < 0.3, qPrintable(QStringLiteral("tag %1: %2 px").arg(tag->id).arg(error)));
                sum += error;
            }
            apriltag_detections_destroy(found);
        }
        QVERIFY(sum / 8 < 0.12);
        apriltag_detector_destroy(detector);
        tag36h11_destroy(family);
    }
};

ODOGRAPH_TEST(TestRenderer, QCoreApplication)
#include "tst_renderer.moc"
