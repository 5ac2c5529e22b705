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
    void aRunThatNobodyEndsEnds();

private:
    Nanoseconds m_now{0};
    RunControl control()
    {
        return RunControl([this] { return m_now; });
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
        settings.byGates = true;
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
    settings.byGates = true;
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
    settings.byGates = true;
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
    settings.byGates = true;
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
    settings.byGates = true;
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
