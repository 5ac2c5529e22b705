// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/renderer.h"
#include "core/tracking/colour_tracker.h"
#include "core/trajectory/internal/name_evidence.h"
#include "core/trajectory/name_assignment.h"
#include "tests/support/registered_test.h"
#include "tests/tracking/crossing_scenes.h"

#include <QtTest>
#include <algorithm>
#include <limits>
#include <numeric>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

constexpr RgbColour red{0xd7, 0x23, 0x28}, orangeRed{0xd8, 0x48, 0x1c};

NamedView trackView(const SimulatedScene &scene, int camera)
{
    std::vector<TrackTarget> targets;
    for (const SimulatedRobot &robot : scene.robots)
        targets.push_back({robot.name, robot.colour});
    const auto tracker = ColourTracker::create(std::move(targets));
    SceneRenderer renderer(scene, camera);
    const SimulatedCamera &simulated = scene.cameras[std::size_t(camera)];
    NamedView view{simulated.view, fromSeconds(simulated.startOffsetS), {}};
    view.robots.resize(scene.robots.size());
    for (std::int64_t frame = 0; frame < renderer.frameCount(); ++frame) {
        const auto seen = (*tracker)->track(renderer.render(frame));
        for (std::size_t robot = 0; robot < seen.size(); ++robot)
            view.robots[robot].push_back(seen[robot]);
    }
    return view;
}

/// Sure observations of a view that lie nearer to another robot than to the one that their name means.
int wrongNames(const SimulatedScene &scene, int camera, const NamedView &view,
               const std::vector<std::size_t> &meant)
{
    int wrong = 0;
    for (std::size_t robot = 0; robot < view.robots.size(); ++robot) {
        for (const Observation &observation : view.robots[robot]) {
            if (!isSure(observation))
                continue;
            const double timeS = frameSceneTime(scene, camera, observation.frame);
            double least = 1e9;
            std::size_t nearest = 0;
            for (std::size_t other = 0; other < scene.robots.size(); ++other) {
                const Vector2d at = scene.robots[other].motion->at(timeS).position;
                const Vector2d pixel =
                    scene.cameras[std::size_t(camera)]
                        .view.pixelFromWorld({at.x(), at.y(), scene.robots[other].heightM / 2})
                        .value();
                const double away = (pixel - observation.ellipse.centrePx).norm();
                if (away < least) {
                    least = away;
                    nearest = other;
                }
            }
            wrong += nearest != meant[robot];
        }
    }
    return wrong;
}

} // namespace

/// Robots that cross, from the pictures of two views to their names.
class TestCrossingRobots : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesAreKept_data();
    void namesAreKept();
};

void TestCrossingRobots::namesAreKept_data()
{
    QTest::addColumn<int>("robots");
    QTest::addColumn<bool>("equal");
    QTest::addColumn<int>("meeting");
    QTest::addColumn<double>("cameraHeightM");
    QTest::addColumn<double>("robotHeightM");
    QTest::addColumn<int>("seed");
    const int seeds = qEnvironmentVariableIntValue("ODOGRAPH_MORE_SEEDS") ? 3 : 1;
    const char *meetings[] = {"passing", "turning back", "behind a board"};
    for (int seed = 1; seed <= seeds; ++seed) {
        for (const bool equal : {true, false}) {
            for (const Meeting meeting : {Meeting::Pass, Meeting::TurnBack, Meeting::BehindWall}) {
                const double robotHeightM = meeting == Meeting::BehindWall ? 0.06 : 0.15;
                QTest::addRow("%s colours, %s, seed %d", equal ? "equal" : "similar", meetings[int(meeting)],
                              seed)
                    << 2 << equal << int(meeting) << (meeting == Meeting::Pass ? 1.2 : 1.5) << robotHeightM
                    << seed;
            }
        }
        QTest::addRow("three of equal colours, passing, seed %d", seed)
            << 3 << true << int(Meeting::Pass) << 1.5 << 0.06 << seed;
    }
}

void TestCrossingRobots::namesAreKept()
{
    QFETCH(int, robots);
    QFETCH(bool, equal);
    QFETCH(int, meeting);
    QFETCH(double, cameraHeightM);
    QFETCH(double, robotHeightM);
    QFETCH(int, seed);
    std::vector<RgbColour> colours(std::size_t(robots), red);
    if (!equal)
        colours[1] = orangeRed;
    const SimulatedScene scene =
        crossingScene({colours, Meeting(meeting), cameraHeightM, robotHeightM, std::uint32_t(seed)});
    std::vector<NamedView> views{trackView(scene, 0), trackView(scene, 1)};
    // Of equal colours nobody can say which is which, but the names must not change.
    const auto wrong = [&] {
        std::vector<std::size_t> meant(colours.size());
        std::iota(meant.begin(), meant.end(), std::size_t(0));
        int least = std::numeric_limits<int>::max();
        do {
            least = std::min(least,
                             wrongNames(scene, 0, views[0], meant) + wrongNames(scene, 1, views[1], meant));
        } while (equal && std::next_permutation(meant.begin(), meant.end()));
        return least;
    };
    std::vector<NamedRobot> named;
    for (const RgbColour colour : colours)
        named.push_back({colour, {}});
    const int before = wrong();
    const NameOutcome outcome = assignNames(views, named);
    const int behind = wrong();
    qInfo("%d observations with a wrong name before, %d behind; %lld renamed", before, behind,
          static_cast<long long>(outcome.renamed));
    QCOMPARE(behind, 0);
}

ODOGRAPH_TEST(TestCrossingRobots, QCoreApplication)
#include "tst_crossing_robots.moc"
