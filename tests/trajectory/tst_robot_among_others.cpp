// SPDX-License-Identifier: GPL-3.0-or-later
// Which of all that moves is the robot: by the floor, over all views together, or as a person says.
#include "core/geometry/silhouette.h"
#include "core/trajectory/name_assignment.h"
#include "core/trajectory/view_disagreement.h"
#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <QtTest>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

constexpr float outlinePx = 15;

Truth at(const Vector2d &position)
{
    Truth truth;
    truth.position = position;
    return truth;
}

Truth drives(double t)
{
    return at({0.9 * std::cos(2 * M_PI * t / 5), 0.3});
}
Truth drivesAsMuch(double t)
{
    return at({0.9 * std::sin(2 * M_PI * t / 5), -0.4});
}
Truth stands(double)
{
    return at({-0.5, -0.6});
}
Truth standsElsewhere(double)
{
    return at({0.7, -0.7});
}

std::vector<Observation> filmed(const FloorView &view, const Course &course, std::mt19937 &random)
{
    FilmSettings settings;
    settings.noisePx = 0.5;
    std::vector<Observation> observations = film("", view, course, settings, random).observations;
    for (Observation &one : observations)
        one.supportPx.assign(supportDirections, outlinePx);
    return observations;
}

/// Views whose tracker took the first course of each for the robot, and followed the others besides.
std::vector<NamedView> viewsOf(const std::vector<std::vector<Course>> &courses)
{
    std::mt19937 random(5);
    const std::vector<FloorView> cameras{cameraA(), cameraB()};
    std::vector<NamedView> views;
    for (std::size_t v = 0; v < courses.size(); ++v) {
        NamedView &view = views.emplace_back();
        view.floorView = cameras[v];
        for (const Course &course : courses[v])
            (view.robots.empty() ? view.robots : view.others).push_back(filmed(cameras[v], course, random));
    }
    return views;
}

/// In how many frames something else than what goes a course is named the robot, or nothing is.
int framesOff(const NamedView &view, const FloorView &camera, const Course &course)
{
    int off = 0;
    for (const Observation &one : view.robots.front()) {
        const Vector2d position = course(toSeconds(one.time)).position;
        off +=
            !one.found || (*camera.pixelFromWorld({position.x(), position.y(), 0.03}) - one.ellipse.centrePx)
                                  .norm() > outlinePx
                ? 1
                : 0;
    }
    return off;
}

Vector2d seenAt(const NamedView &view, const Course &course, std::size_t frame)
{
    const Vector2d position = course(toSeconds(view.robots.front()[frame].time)).position;
    return *view.floorView->pixelFromWorld({position.x(), position.y(), 0.03});
}

} // namespace

class TestRobotAmongOthers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatDrivesIsTheRobot();
    void whatComesToRestIsNoRobot();
    void aViewThatContradictsIsKept();
    void aPersonDecides();
    void nothingIsThere();
    void aGlimpseIsNoRobot();
    void theRobotsOwnNameIsNeverTwice();
    void uncutOutlinesTellLess();
};

void TestRobotAmongOthers::whatDrivesIsTheRobot()
{
    auto views = viewsOf({{stands, drives}, {standsElsewhere, stands, drives}});
    const NameOutcome outcome = assignNames(views, std::vector<NamedRobot>(1));
    QCOMPARE(framesOff(views[0], cameraA(), drives), 0);
    QCOMPARE(framesOff(views[1], cameraB(), drives), 0);
    QVERIFY(outcome.renamed > 0);
    QCOMPARE(outcome.ambiguities.size(), std::size_t(0));
}

/// A ball rolls as far as the robot drives and is seen all the time, the robot for half of it.
void TestRobotAmongOthers::whatComesToRestIsNoRobot()
{
    const Course rolls = [](double t) { return at({-0.8 + 0.7 * std::min(t, 2.0), -0.5}); };
    auto views = viewsOf({{rolls, drives}, {rolls, drives}});
    for (NamedView &view : views)
        for (std::size_t i = 50; i < 200; ++i)
            view.others.front()[i].found = false;
    assignNames(views, std::vector<NamedRobot>(1));
    QCOMPARE(framesOff(views[0], cameraA(), drives), 150);
    QCOMPARE(framesOff(views[1], cameraB(), drives), 150);
}

/// Its camera was pushed: that the views disagree is to be seen and said, and not to be hidden by leaving one
/// out.
void TestRobotAmongOthers::aViewThatContradictsIsKept()
{
    auto views = viewsOf({{drives}, {drives, stands}});
    views[0].others.assign(1, std::vector<Observation>(views[0].robots.front().size()));
    RigidTransform pose = cameraB().worldFromCamera();
    pose.translation.x() += 0.5;
    views[1].floorView = FloorView(cameraB().camera(), pose, cameraB().poseCovariance());
    assignNames(views, std::vector<NamedRobot>(1));
    QCOMPARE(framesOff(views[0], cameraA(), drives), 0);
    QCOMPARE(framesOff(views[1], cameraB(), drives), 0);
}

/// Two things go alike far in both views: nothing tells which is the robot but a click in one of them.
void TestRobotAmongOthers::aPersonDecides()
{
    for (const Course &course : {Course(drives), Course(drivesAsMuch)}) {
        for (const std::size_t clicked : {std::size_t(0), std::size_t(1)}) {
            auto views = viewsOf({{drives, drivesAsMuch}, {drivesAsMuch, drives}});
            constexpr std::size_t frame = 40;
            views[clicked].pointedOut = {
                {0, std::int64_t(frame), seenAt(views[clicked], course, frame) + Vector2d(5, -5)}};
            const NameOutcome outcome = assignNames(views, std::vector<NamedRobot>(1));
            QVERIFY(outcome.nothingThere.empty());
            QCOMPARE(framesOff(views[0], cameraA(), course), 0);
            QCOMPARE(framesOff(views[1], cameraB(), course), 0);
        }
    }
    // Even what stands.
    auto views = viewsOf({{drives, stands}, {drives, stands}});
    views[0].pointedOut = {{0, 10, seenAt(views[0], stands, 10)}};
    assignNames(views, std::vector<NamedRobot>(1));
    QCOMPARE(framesOff(views[0], cameraA(), stands), 0);
    QCOMPARE(framesOff(views[1], cameraB(), stands), 0);
}

void TestRobotAmongOthers::nothingIsThere()
{
    auto views = viewsOf({{drives, stands}, {drives}});
    views[1].pointedOut = {{0, 10, {3, 3}}};
    const NameOutcome outcome = assignNames(views, std::vector<NamedRobot>(1));
    QVERIFY((outcome.nothingThere == std::vector<std::pair<std::size_t, std::size_t>>{{1, 0}}));
    QCOMPARE(framesOff(views[1], cameraB(), drives), 0);
}

/// What is seen for two frames while the robot is lost may be anything.
void TestRobotAmongOthers::aGlimpseIsNoRobot()
{
    auto views = viewsOf({{drives, stands}, {drives, stands}});
    auto &robot = views[0].robots.front();
    for (std::size_t i = 60; i < 80; ++i)
        robot[i].found = i == 70 || i == 71;
    robot[70].ellipse.centrePx = robot[71].ellipse.centrePx = {30, 30};
    assignNames(views, std::vector<NamedRobot>(1));
    for (std::size_t i = 60; i < 80; ++i) {
        QVERIFY(!views[0].robots.front()[i].found);
        QCOMPARE(views[0].robots.front()[i].frame, std::int64_t(i));
    }
    QCOMPARE(framesOff(views[0], cameraA(), drives), 20);
}

/// Two robots of any look beside what stands.
void TestRobotAmongOthers::theRobotsOwnNameIsNeverTwice()
{
    auto views = viewsOf({{stands, drives, drivesAsMuch}, {drivesAsMuch, standsElsewhere, drives}});
    for (NamedView &view : views) {
        view.robots.push_back(view.others.front());
        view.others.erase(view.others.begin());
    }
    assignNames(views, std::vector<NamedRobot>(2));
    const bool isFirst = framesOff(views[0], cameraA(), drives) == 0;
    for (std::size_t v = 0; v < 2; ++v) {
        const FloorView camera = v == 0 ? cameraA() : cameraB();
        QCOMPARE(framesOff(views[v], camera, isFirst ? drives : drivesAsMuch), 0);
        std::swap(views[v].robots[0], views[v].robots[1]);
        QCOMPARE(framesOff(views[v], camera, isFirst ? drivesAsMuch : drives), 0);
    }
}

/// Where a cable was mostly left out, it lies before or behind the body in the other outlines.
void TestRobotAmongOthers::uncutOutlinesTellLess()
{
    std::vector<Observation> first(10), second(10);
    for (auto *view : {&first, &second})
        for (Observation &one : *view) {
            one.found = true;
            one.score = 1;
            one.areaPx = 100;
        }
    for (std::size_t i = 0; i < 7; ++i)
        first[i].isTrimmed = true;
    const auto untouched = first;
    uncertaintyUntrimmed({&first, &second}); // 7 of 20
    QCOMPARE(first[9].score, 1.0);
    for (std::size_t i = 0; i < 7; ++i)
        second[i].isTrimmed = true;
    uncertaintyUntrimmed({&first, &second});
    QCOMPARE(first[0].score, 1.0);
    QVERIFY(first[0].centreCovariancePx2.isZero());
    QVERIFY(first[9].score < 0.3 && first[9].score > 0.2); // of use to measure, and not to learn from
    QVERIFY(first[9].centreCovariancePx2(0, 0) > 0);
    first[9].found = false;
    uncertaintyUntrimmed({});
}

ODOGRAPH_TEST(TestRobotAmongOthers, QCoreApplication)

#include "tst_robot_among_others.moc"
