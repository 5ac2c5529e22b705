// SPDX-License-Identifier: GPL-3.0-or-later
// Robots of exactly the same look among one another: each keeps its name, or the stretch is said to be
// doubtful. ODOGRAPH_CROSSINGS: how many of two, of four and of six robots; by default a few of two.
#include "core/simulation/demo_testbed.h"
#include "core/workflow/track/settled_views.h"
#include "tests/support/registered_test.h"
#include "tests/workflow/measured_scene.h"

#include <QTemporaryDir>
#include <QTest>
#include <numbers>
#include <random>

using namespace odo;
using namespace odo::test;

namespace {

constexpr double nearM = 0.5, leastApartM = 0.24; // of a crossing; of two middles whose robots do not touch
constexpr double durationS = 12;

SimulatedRobot buggy(int number)
{
    using S = SimulatedShape;
    constexpr RgbColour black{28, 28, 30};
    SimulatedRobot robot;
    robot.name = "buggy " + std::to_string(number);
    robot.heightM = 0.1;
    robot.parts = {{S::Box, {238, 238, 235}, {0, 0, 0.045}, {0.18, 0.11, 0.046}},
                   {S::Box, {60, 110, 70}, {-0.02, 0, 0.085}, {0.1, 0.08, 0.034}}};
    for (const double x : {0.055, -0.055})
        for (const double y : {0.068, -0.068})
            robot.parts.push_back({S::Wheel, black, {x, y, 0.028}, {0.056, 0.024, 0.056}});
    return robot;
}

double apartM(const SimulatedScene &scene, std::size_t a, std::size_t b, double timeS)
{
    return (scene.robots[a].motion->at(timeS).position - scene.robots[b].motion->at(timeS).position).norm();
}

/// How often two come near each other; none where two touch.
std::optional<int> crossingsIn(const SimulatedScene &scene)
{
    constexpr double stepS = 0.05;
    int crossings = 0;
    for (std::size_t a = 0; a < scene.robots.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            for (double t = stepS; t < durationS; t += stepS) {
                const double here = apartM(scene, a, b, t);
                if (here < leastApartM)
                    return std::nullopt;
                crossings += here < nearM && here <= apartM(scene, a, b, t - stepS) &&
                             here < apartM(scene, a, b, t + stepS);
            }
        }
    }
    return crossings;
}

/// On ellipses whose ways cross, to both sides and at their own paces, drawn until they meet but do not
/// touch.
SimulatedScene drawnScene(int robots, std::mt19937 &random)
{
    const auto between = [&random](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    while (true) {
        SimulatedScene scene = demoTestbed(random());
        scene.durationS = durationS;
        scene.robots.clear();
        for (int i = 0; i < robots; ++i) {
            SimulatedRobot robot = buggy(i);
            const double side = random() % 2 ? 1 : -1;
            const Eigen::Vector2d middle = robots == 2
                                               ? Eigen::Vector2d(1.5 + 0.28 * (i ? 1 : -1), 1.1)
                                               : Eigen::Vector2d(0.75 + 0.75 * (i % 3), i < 3 ? 0.75 : 1.5);
            const double size = robots == 2 ? 0.62 : 0.45;
            robot.motion = makeEllipseMotion(middle, size, side * size, between(7, 10),
                                             between(0, 2 * std::numbers::pi), 0.6);
            scene.robots.push_back(std::move(robot));
        }
        if (crossingsIn(scene).value_or(0) > 0)
            return scene;
    }
}

struct AlikeMetrics
{
    int exchanges = 0, unmarked = 0; ///< of names; and those at no time that was called doubtful
    double ambiguousS = 0, wholeS = 0;
    double squares = 0, points = 0, inside = 0;
    int spikes = 0;
    std::int64_t frames = 0, missing = 0;
};

void compare(const Profile &profile, const SimulatedScene &scene, std::size_t robot,
             const std::vector<NameAmbiguity> &ambiguities, AlikeMetrics &metrics)
{
    std::optional<std::size_t> before;
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        metrics.missing += !profile.samples[i].position;
        const ProfilePoint &point = profile.points[i];
        if (!point.valid)
            continue;
        const double timeS = sceneTimeOfStamp(scene, 0, profile.samples[i].time);
        const auto offOf = [&](std::size_t other) {
            return Eigen::Vector2d(point.position - scene.robots[other].motion->at(timeS).position);
        };
        std::size_t nearest = 0;
        for (std::size_t other = 1; other < scene.robots.size(); ++other)
            nearest = offOf(other).norm() < offOf(nearest).norm() ? other : nearest;
        const Eigen::Vector2d off = offOf(nearest);
        metrics.squares += off.squaredNorm();
        metrics.points += 1;
        metrics.inside +=
            ((std::abs(off.x()) < 1.96 * point.sigmaXM) + (std::abs(off.y()) < 1.96 * point.sigmaYM)) / 2.0;
        if (before && nearest != *before) {
            constexpr double atHandS = 0.3;
            const double atS = toSeconds(profile.samples[i].time);
            const bool isMarked = std::ranges::any_of(ambiguities, [&](const NameAmbiguity &ambiguity) {
                return ambiguity.robot == robot && atS > ambiguity.fromS - atHandS &&
                       atS < ambiguity.toS + atHandS;
            });
            ++metrics.exchanges;
            metrics.unmarked += !isMarked;
        }
        before = nearest;
    }
    metrics.frames += std::int64_t(profile.points.size());
    metrics.spikes += int(profile.spikes.size());
}

void measure(const SimulatedScene &scene, AlikeMetrics &metrics)
{
    const QTemporaryDir folder;
    const auto views = renderedViews(scene, folder.path().toStdString());
    QVERIFY2(views, views ? "" : views.error().message().c_str());
    std::vector<RobotRecord> robots(scene.robots.size());
    for (std::size_t i = 0; i < robots.size(); ++i)
        robots[i].name = scene.robots[i].name;
    auto tracked = trackViews(*views, robots, {});
    QVERIFY2(tracked, tracked ? "" : tracked.error().message().c_str());
    const std::vector<NameAmbiguity> ambiguities = settleNames(*views, robots, *tracked).value();
    for (const NameAmbiguity &ambiguity : ambiguities)
        metrics.ambiguousS += ambiguity.toS - ambiguity.fromS;
    metrics.wholeS += durationS * double(robots.size());
    for (std::size_t i = 0; i < robots.size(); ++i) {
        const auto profile = analyse(takeViewTracks(*views, *tracked, i), shapeOf(robots[i]), {});
        QVERIFY2(profile, profile ? "" : profile.error().message().c_str());
        compare(*profile, scene, i, ambiguities, metrics);
    }
}

} // namespace

class TestAlikeRobots : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void keepTheirNames_data()
    {
        QTest::addColumn<int>("robots");
        QTest::newRow("two") << 2;
        if (qEnvironmentVariableIsSet("ODOGRAPH_CROSSINGS")) {
            QTest::newRow("four") << 4;
            QTest::newRow("six") << 6;
        }
    }
    void keepTheirNames()
    {
        QFETCH(int, robots);
        const int asked = std::max(1, qEnvironmentVariableIntValue("ODOGRAPH_CROSSINGS"));
        std::mt19937 random{unsigned(robots)};
        AlikeMetrics metrics;
        int crossings = 0;
        while (crossings < asked) {
            const SimulatedScene scene = drawnScene(robots, random);
            crossings += *crossingsIn(scene);
            measure(scene, metrics);
            if (QTest::currentTestFailed())
                return;
        }
        const double rmsMm = 1e3 * std::sqrt(metrics.squares / metrics.points),
                     inside = metrics.inside / metrics.points,
                     found = 1 - double(metrics.missing) / double(metrics.frames);
        const QString words = QStringLiteral("%1 crossings: %2 exchanges, %3 of them unmarked, doubtful %4 "
                                             "%; found %5 %, %6 mm, %7 inside, %8 spikes in %9 frames")
                                  .arg(crossings)
                                  .arg(metrics.exchanges)
                                  .arg(metrics.unmarked)
                                  .arg(100 * metrics.ambiguousS / metrics.wholeS, 0, 'f', 2)
                                  .arg(100 * found, 0, 'f', 1)
                                  .arg(rmsMm, 0, 'f', 2)
                                  .arg(inside, 0, 'f', 2)
                                  .arg(metrics.spikes)
                                  .arg(metrics.frames);
        qInfo("%s", qPrintable(words));
        QVERIFY2(metrics.unmarked == 0 && metrics.ambiguousS < 0.02 * metrics.wholeS, qPrintable(words));
        QVERIFY2(found > 0.99 && rmsMm < 4 && inside > 0.9 && metrics.spikes <= 2 + metrics.frames / 1000,
                 qPrintable(words));
    }
};

ODOGRAPH_TEST(TestAlikeRobots, QCoreApplication)
#include "tst_alike_robots.moc"
