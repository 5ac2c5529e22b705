// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/renderer.h"
#include "core/tracking/colour_tracker.h"
#include "tests/support/registered_test.h"
#include "tests/tracking/crossing_scenes.h"

#include <QtTest>
#include <cmath>
#include <ctime>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

constexpr RgbColour red{0xd7, 0x23, 0x28}, orangeRed{0xd8, 0x48, 0x1c}, blue{0x1f, 0x6f, 0xd0},
    green{0x1f, 0x9d, 0x4d};

/// About the centre of the silhouette; within a few pixels, which is enough to tell who is who.
Vector2d centreInImage(const SimulatedScene &scene, int camera, std::size_t robot, std::int64_t frame)
{
    const Vector2d at = scene.robots[robot].motion->at(frameSceneTime(scene, camera, frame)).position;
    return scene.cameras[std::size_t(camera)]
        .view.pixelFromWorld({at.x(), at.y(), scene.robots[robot].heightM / 2})
        .value();
}

/// What one view's tracking came to.
struct Outcome
{
    int frames = 0, sure = 0, coarse = 0, missing = 0;
    int wrongNames = 0; ///< sure observations that lie nearer to another robot than to their own
    int exchanges = 0;  ///< how often a name went from one robot to another
    double worstSurePx = 0, microsecondsPerFrame = 0;
};

double threadSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

Outcome trackScene(const SimulatedScene &scene, int camera)
{
    std::vector<TrackTarget> targets;
    for (const SimulatedRobot &robot : scene.robots)
        targets.push_back({robot.name, robot.colour});
    const auto tracker = ColourTracker::create(std::move(targets));
    SceneRenderer renderer(scene, camera);
    Outcome outcome;
    std::vector<std::size_t> owner(scene.robots.size(), scene.robots.size());
    for (std::int64_t frame = 0; frame < renderer.frameCount(); ++frame) {
        const Frame image = renderer.render(frame);
        const double before = threadSeconds();
        const auto seen = (*tracker)->track(image);
        outcome.microsecondsPerFrame += 1e6 * (threadSeconds() - before) / double(renderer.frameCount());
        for (std::size_t robot = 0; robot < seen.size(); ++robot) {
            ++outcome.frames;
            if (!seen[robot].found) {
                ++outcome.missing;
                continue;
            }
            if (seen[robot].score < 0.2) {
                ++outcome.coarse;
                continue;
            }
            ++outcome.sure;
            std::size_t nearest = 0;
            double least = 1e9;
            for (std::size_t other = 0; other < seen.size(); ++other) {
                const double away =
                    (seen[robot].ellipse.centrePx - centreInImage(scene, camera, other, frame)).norm();
                if (away < least) {
                    least = away;
                    nearest = other;
                }
            }
            outcome.worstSurePx = std::max(outcome.worstSurePx, least);
            outcome.wrongNames += nearest != robot;
            if (owner[robot] == scene.robots.size())
                owner[robot] = nearest;
            outcome.exchanges += nearest != owner[robot];
            owner[robot] = nearest;
        }
    }
    return outcome;
}

void describe(const Outcome &outcome)
{
    qInfo("%d observations: %d sure, %d coarse, %d missing; %d with a wrong name, %d exchanges; worst sure "
          "one %.1f px "
          "off; %.0f µs a frame",
          outcome.frames, outcome.sure, outcome.coarse, outcome.missing, outcome.wrongNames,
          outcome.exchanges, outcome.worstSurePx, outcome.microsecondsPerFrame);
}

} // namespace

/// Several robots in one view: who is who, before the views are compared.
class TestSeveralRobots : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void crossing_data();
    void crossing();
};

void TestSeveralRobots::crossing_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("cameraHeightM");
    QTest::addColumn<double>("robotHeightM");
    QTest::addColumn<int>("camera");
    const char *kinds[] = {"equal colours", "similar colours", "three colours"};
    int row = 0;
    for (int kind = 0; kind < 3; ++kind) {
        for (const auto &[cameraHeightM, robotHeightM] :
             {std::pair(2.0, 0.06), std::pair(1.2, 0.06), std::pair(1.2, 0.15)}) {
            const int camera = row++ % 4 % 3;
            QTest::addRow("%s, %.1f m high, robots %.2f m, camera %c", kinds[kind], cameraHeightM,
                          robotHeightM, 'A' + camera)
                << kind << cameraHeightM << robotHeightM << camera;
        }
    }
}

void TestSeveralRobots::crossing()
{
    QFETCH(int, kind);
    QFETCH(double, cameraHeightM);
    QFETCH(double, robotHeightM);
    QFETCH(int, camera);
    const std::vector<RgbColour> colours[] = {{red, red}, {red, orangeRed}, {red, blue, green}};
    CrossingSettings settings{colours[kind]};
    settings.cameraHeightM = cameraHeightM;
    settings.robotHeightM = robotHeightM;
    settings.seed = std::uint32_t(1 + kind + camera);
    const Outcome outcome = trackScene(crossingScene(settings), camera);
    describe(outcome);
    QCOMPARE(outcome.exchanges, 0);
}

ODOGRAPH_TEST(TestSeveralRobots, QCoreApplication)
#include "tst_several_robots.moc"
