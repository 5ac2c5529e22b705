// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/run_control.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <numbers>

using namespace odo;
using namespace std::chrono_literals;

namespace {

Task line()
{
    Task task;
    task.gates = {gateAcross("Start", GateRole::Start, {0.5, 0}, {1, 0}, 1),
                  gateAcross("Finish", GateRole::Finish, {2.5, 0}, {1, 0}, 1)};
    return task;
}

Task circle()
{
    Task task;
    task.gates = {gateAcross("Lap", GateRole::StartFinish, {0, 1}, {-1, 0}, 0.5)};
    return task;
}

LivePosition at(Nanoseconds time, const Eigen::Vector2d &place, const Eigen::Vector2d &velocity)
{
    LivePosition position{};
    position.sample.time = time;
    position.sample.position = place;
    position.sample.covariance = Eigen::Matrix2d::Identity() * 1e-6;
    position.point.position = place;
    position.point.velocity = velocity;
    position.point.acceleration = Eigen::Vector2d::Zero();
    position.point.sigmaXM = position.point.sigmaYM = 0.001;
    position.point.valid = true;
    return position;
}

} // namespace

class TestRunControl : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { m_now = 100s; }
    void aPressBeginsAndTheNextEnds();
    void theSecondsBeforeAreChosen();
    void aCountdownCanBeCalledOff();
    void theRobotBeginsAndEndsItself();
    void lapsAreCounted();
    void allWhoStartedMustFinish();
    void withoutGatesAPressDoes();
    void theEdgeOfAZoneStartsAndEnds();
    void noiseAtAnEdgeIsNoCrossing();
    void motionStartsAndRestEnds();
    void aPressWaitsForMotionBeforeItsRestEnds();
    void aTimeEnds();
    void aTriggerThatTheTaskLacksHasNoEffect();
    void aRunThatNobodyEndsEnds();

private:
    Nanoseconds m_now{0};
    RunControl control()
    {
        return RunControl([this] { return m_now; });
    }
    /// Gives the floor's sights of a camera of 30 frames a second for so long; gives the first order.
    std::optional<RunOrder> look(RunControl &control, Nanoseconds length, bool moves)
    {
        for (const Nanoseconds until = m_now + length; m_now < until;) {
            m_now += fromSeconds(1 / 30.0);
            if (const auto order = control.floorAt({m_now, moves}))
                return order;
            if (const auto order = control.tick())
                return order;
        }
        return std::nullopt;
    }
    /// Drives along x at 1 m/s for so long, 30 positions a second; gives the first order and when it came.
    std::optional<RunOrder> driveLine(RunControl &control, std::size_t robot, double fromM, double toM)
    {
        for (double x = fromM; x < toM; x += 1 / 30.0) {
            m_now += fromSeconds(1 / 30.0);
            if (const auto order = control.robotAt(robot, at(m_now, {x, 0}, {1, 0})))
                return order;
            if (const auto order = control.tick())
                return order;
        }
        return std::nullopt;
    }
};

void TestRunControl::aPressBeginsAndTheNextEnds()
{
    RunControl run = control();
    run.prepare({}, std::nullopt, 1);
    QCOMPARE(run.phase(), RunPhase::Ready);
    const auto begin = run.press();
    QVERIFY(begin && begin->kind == RunOrder::Kind::Begin);
    QCOMPARE(begin->from, 99s); // a late press loses nothing
    QCOMPARE(run.phase(), RunPhase::Recording);
    m_now += 4s;
    QVERIFY(!run.tick());
    QCOMPARE(run.elapsed(), 5s);
    const auto end = run.press();
    QVERIFY(end && end->kind == RunOrder::Kind::End);
    QCOMPARE(run.phase(), RunPhase::Ready);
    QCOMPARE(run.elapsed(), 0s);
}

/// A press begins so much earlier, and a gate a second at least: its passage needs the track before it.
void TestRunControl::theSecondsBeforeAreChosen()
{
    for (const Nanoseconds before : {Nanoseconds(0s), Nanoseconds(5s)}) {
        RunControl run = control();
        RunSettings settings;
        settings.before = before;
        run.prepare(settings, std::nullopt, 1);
        const auto pressed = run.press();
        QVERIFY(pressed);
        QCOMPARE(pressed->at, m_now);
        QCOMPARE(pressed->from, m_now - before);
        run.press();
        settings.start = settings.stop = RunTrigger{RunTrigger::Kind::Gate};
        run.prepare(settings, line(), 1);
        run.press();
        const Nanoseconds armed = m_now;
        const auto passed = driveLine(run, 0, 0, 3);
        QVERIFY(passed);
        QVERIFY(std::chrono::abs(passed->at - (armed + 500ms)) < 50ms);
        QCOMPARE(passed->from, passed->at - std::max<Nanoseconds>(before, 1s));
    }
}

void TestRunControl::aCountdownCanBeCalledOff()
{
    RunControl run = control();
    RunSettings settings;
    settings.countdown = 3s;
    run.prepare(settings, std::nullopt, 1);
    QVERIFY(!run.press());
    QCOMPARE(run.phase(), RunPhase::CountingDown);
    m_now += 1s;
    QVERIFY(!run.tick());
    QCOMPARE(run.countdownLeft(), 2s);
    QCOMPARE(run.press()->kind, RunOrder::Kind::CallOff);
    QCOMPARE(run.phase(), RunPhase::Ready);
    QVERIFY(!run.press());
    m_now += 3050ms; // the tick comes a little late: it was due before
    const auto begin = run.tick();
    QVERIFY(begin && begin->kind == RunOrder::Kind::Begin);
    QCOMPARE(begin->from, 104s);
}

void TestRunControl::theRobotBeginsAndEndsItself()
{
    RunControl run = control();
    RunSettings settings;
    settings.start = settings.stop = RunTrigger{RunTrigger::Kind::Gate};
    run.prepare(settings, line(), 1);
    QVERIFY(run.startsByGate());
    QCOMPARE(run.startGate(), std::string("Start"));
    QVERIFY(!driveLine(run, 0, 0, 1)); // not armed yet
    QVERIFY(!run.press());
    QCOMPARE(run.phase(), RunPhase::Armed);
    const Nanoseconds set = m_now;
    const auto begin = driveLine(run, 0, 0, 3);
    QVERIFY(begin && begin->kind == RunOrder::Kind::Begin);
    // The gate is passed half a second after it was set off, and recorded from a second before.
    QVERIFY(std::chrono::abs(begin->from - (set + 500ms - 1s)) < 50ms);
    const Nanoseconds begun = m_now;
    const auto end = driveLine(run, 0, 0.55, 9);
    QVERIFY(end && end->kind == RunOrder::Kind::End);
    QVERIFY(std::chrono::abs(m_now - (begun + 1950ms + 1s)) < 150ms);
}

void TestRunControl::lapsAreCounted()
{
    RunControl run = control();
    RunSettings settings;
    settings.start = settings.stop = RunTrigger{RunTrigger::Kind::Gate};
    settings.laps = 2;
    run.prepare(settings, circle(), 1);
    run.press();
    const Nanoseconds set = m_now;
    std::vector<std::pair<RunOrder::Kind, Nanoseconds>> orders;
    constexpr double periodS = 4;
    for (int i = 0; i < 30 * 14; ++i) { // anticlockwise from (1, 0): the gate is a quarter on
        m_now += fromSeconds(1 / 30.0);
        const double w = 2 * std::numbers::pi / periodS, angle = w * toSeconds(m_now - set);
        const LivePosition here =
            at(m_now, {std::cos(angle), std::sin(angle)}, {-w * std::sin(angle), w * std::cos(angle)});
        for (const auto &order : {run.robotAt(0, here), run.tick()}) {
            if (order)
                orders.emplace_back(order->kind, m_now - set);
        }
    }
    QCOMPARE(orders.size(), std::size_t(2));
    QVERIFY(orders[0].first == RunOrder::Kind::Begin && std::chrono::abs(orders[0].second - 1s) < 100ms);
    QVERIFY(orders[1].first == RunOrder::Kind::End &&
            std::chrono::abs(orders[1].second - 10s) < 150ms); // 1 + 2·4 + 1 s after
}

void TestRunControl::allWhoStartedMustFinish()
{
    RunControl run = control();
    RunSettings settings;
    settings.start = settings.stop = RunTrigger{RunTrigger::Kind::Gate};
    run.prepare(settings, line(), 3); // the third one never starts
    run.press();
    QVERIFY(driveLine(run, 0, 0, 1));
    QVERIFY(!driveLine(run, 1, 0, 1));
    QVERIFY(!driveLine(run, 0, 1, 4)); // the first has finished for long
    QCOMPARE(run.phase(), RunPhase::Recording);
    QCOMPARE(driveLine(run, 1, 1, 6)->kind, RunOrder::Kind::End);
}

void TestRunControl::withoutGatesAPressDoes()
{
    RunSettings settings;
    settings.start = settings.stop = RunTrigger{RunTrigger::Kind::Gate};
    settings.countdown = 2s;
    Task pathOnly;
    pathOnly.path.points = {{0, 0}, {1, 0}};
    RunControl run = control();
    run.prepare(settings, pathOnly, 1);
    QVERIFY(!run.startsByGate());
    QVERIFY(!run.press());
    QCOMPARE(run.phase(), RunPhase::CountingDown);

    Task startOnly = line();
    startOnly.gates.pop_back();
    RunControl half = control();
    half.prepare(settings, startOnly, 1);
    QVERIFY(half.startsByGate());
    half.press();
    QVERIFY(driveLine(half, 0, 0, 2));
    QCOMPARE(half.phase(), RunPhase::Recording);
    QCOMPARE(half.press()->kind, RunOrder::Kind::End);

    RunControl nobody = control();
    nobody.prepare(settings, line(), 0);
    QVERIFY(!nobody.startsByGate());
}

/// From the start box, which the robot leaves at 0.5 m, into the goal, whose edge is at 2.5 m.
void TestRunControl::theEdgeOfAZoneStartsAndEnds()
{
    Task task;
    task.zones = {rectangularZone("Box", ZoneRule::StayInside, {-0.5, -0.5}, {0.5, 0.5}),
                  rectangularZone("Goal", ZoneRule::StayInside, {2.5, -0.5}, {3.5, 0.5})};
    RunControl run = control();
    RunSettings settings;
    settings.start = RunTrigger{RunTrigger::Kind::Exit, "Box"};
    settings.stop = RunTrigger{RunTrigger::Kind::Entry, "Goal"};
    run.prepare(settings, task, 2);
    QVERIFY(run.start() && run.stop() && !run.needsFloorSights());
    QVERIFY(!run.press());
    QCOMPARE(run.phase(), RunPhase::Armed);
    QVERIFY(!run.robotAt(0, at(m_now, {3, 0}, {1, 0}))); // the other one is elsewhere, and stays
    const Nanoseconds armed = m_now;
    const auto begin = driveLine(run, 1, 0, 4);
    QVERIFY(begin && begin->kind == RunOrder::Kind::Begin);
    // on the edge, between two frames, the first of which comes an interval later
    QVERIFY(std::chrono::abs(begin->at - (armed + 533ms)) < 5ms);
    QCOMPARE(begin->from, begin->at - 1s);
    const Nanoseconds entry = begin->at + 2s;
    const auto end = driveLine(run, 1, 0.5 + toSeconds(m_now + 33ms - begin->at), 9);
    QVERIFY(end && end->kind == RunOrder::Kind::End);
    QVERIFY(std::chrono::abs(m_now - (entry + 1s)) < 100ms);
    QCOMPARE(run.phase(), RunPhase::Ready);
}

/// A robot that rests on the edge, with noise of a millimetre.
void TestRunControl::noiseAtAnEdgeIsNoCrossing()
{
    Task task;
    task.zones = {rectangularZone("Box", ZoneRule::StayInside, {0, -0.5}, {1, 0.5})};
    for (const RunTrigger::Kind kind : {RunTrigger::Kind::Entry, RunTrigger::Kind::Exit}) {
        RunControl run = control();
        RunSettings settings;
        settings.start = RunTrigger{kind, "Box"};
        run.prepare(settings, task, 1);
        run.press();
        for (int i = 0; i < 300; ++i) {
            m_now += 33ms;
            QVERIFY(!run.robotAt(0, at(m_now, {i % 2 == 0 ? 0.001 : -0.001, 0}, {0, 0})));
        }
        QCOMPARE(run.phase(), RunPhase::Armed);
    }
}

/// It moves for 0.35 s as it is seen, 0.2 s and the lag of the comparison; what is shorter is none.
void TestRunControl::motionStartsAndRestEnds()
{
    RunControl run = control();
    RunSettings settings;
    settings.start = RunTrigger{RunTrigger::Kind::Motion};
    settings.stop = RunTrigger{RunTrigger::Kind::Motion, {}, usualRest};
    run.prepare(settings, std::nullopt, 0);
    QVERIFY(run.needsFloorSights());
    QVERIFY(!look(run, 2s, true)); // before the press
    QVERIFY(!run.press());
    QVERIFY(!run.floorAt({m_now - 100ms, true})); // on its way
    QVERIFY(!look(run, 1s, false));
    QVERIFY(!look(run, 300ms, true)); // a hand
    QVERIFY(!look(run, 1s, false));
    const Nanoseconds moved = m_now;
    const auto begin = look(run, 2s, true);
    QVERIFY(begin && begin->kind == RunOrder::Kind::Begin);
    QVERIFY(std::chrono::abs(begin->at - moved) < 40ms);
    QVERIFY(m_now - moved < 450ms);
    QCOMPARE(begin->from, begin->at - 1s);
    QVERIFY(!look(run, 1s, true));
    QVERIFY(!look(run, 1s, false)); // a short stop
    QVERIFY(!look(run, 1s, true));
    const Nanoseconds rests = m_now - FloorMotion::lag; // since when it does
    const auto end = look(run, 3s, false);
    QVERIFY(end && end->kind == RunOrder::Kind::End);
    QVERIFY(std::chrono::abs(m_now - (rests + 1500ms)) < 70ms);
}

void TestRunControl::aPressWaitsForMotionBeforeItsRestEnds()
{
    RunControl run = control();
    RunSettings settings;
    settings.stop = RunTrigger{RunTrigger::Kind::Motion, {}, 2s};
    run.prepare(settings, std::nullopt, 1);
    QCOMPARE(run.press()->kind, RunOrder::Kind::Begin);
    QVERIFY(!look(run, 20s, false)); // it has not moved yet
    QVERIFY(!look(run, 1s, true));
    QCOMPARE(look(run, 5s, false)->kind, RunOrder::Kind::End);
}

void TestRunControl::aTimeEnds()
{
    RunControl run = control();
    RunSettings settings;
    settings.stop = RunTrigger{RunTrigger::Kind::Time, {}, 3s};
    settings.before = 5s; // is no part of it
    run.prepare(settings, std::nullopt, 1);
    run.press();
    const Nanoseconds pressed = m_now;
    m_now += 2990ms;
    QVERIFY(!run.tick());
    QCOMPARE(run.sinceStart(), 2990ms);
    QCOMPARE(run.elapsed(), 7990ms);
    m_now = pressed + 3s;
    QCOMPARE(run.tick()->kind, RunOrder::Kind::End);
}

void TestRunControl::aTriggerThatTheTaskLacksHasNoEffect()
{
    for (const RunTrigger &trigger :
         {RunTrigger{RunTrigger::Kind::Gate}, RunTrigger{RunTrigger::Kind::Entry, "Box"},
          RunTrigger{RunTrigger::Kind::Time, {}, 1s}}) {
        RunControl run = control();
        RunSettings settings;
        settings.start = trigger;
        run.prepare(settings, Task{}, 1);
        QVERIFY(!run.start());
        QCOMPARE(run.press()->kind, RunOrder::Kind::Begin);
    }
}

void TestRunControl::aRunThatNobodyEndsEnds()
{
    RunControl run = control();
    RunSettings settings;
    settings.longest = 60s;
    run.prepare(settings, std::nullopt, 1);
    run.press();
    m_now += 58s;
    QVERIFY(!run.tick());
    m_now += 1s;
    QCOMPARE(run.tick()->kind, RunOrder::Kind::End);
    run.press();
    run.hasEnded(); // a camera was lost
    QCOMPARE(run.phase(), RunPhase::Ready);
}

ODOGRAPH_TEST(TestRunControl, QCoreApplication)
#include "tst_run_control.moc"
