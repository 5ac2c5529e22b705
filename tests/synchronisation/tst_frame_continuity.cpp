// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/metrics.h"
#include "core/synchronisation/frame_continuity.h"
#include "core/synchronisation/frame_conversion.h"
#include "tests/support/registered_test.h"
#include "tests/synchronisation/frame_faults.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

using Kind = FrameStep::Kind;

/// How many of each kind: a sample, or with ODOGRAPH_FRAME_FAULTS=20 what is claimed (docs/accuracy.md).
unsigned drawsOfEach()
{
    const int given = qEnvironmentVariableIntValue("ODOGRAPH_FRAME_FAULTS");
    return given > 0 ? unsigned(given) : 3;
}

std::vector<FrameStep> stepsOf(const FaultyView &view)
{
    return findFrameSteps({frameTrack(cameraA(), 0.06, view.observations)}, view.frameTimes);
}

/// The top speed that the analysis gives, with its σ.
std::pair<double, double> topSpeed(const FaultyView &view, const ClockRepair &repair)
{
    ViewTrack track{"A", cameraA(), Nanoseconds(0), view.observations};
    for (Observation &seen : track.observations)
        seen.time = fromSeconds(repair.timeS(toSeconds(seen.time)));
    RobotShape shape;
    shape.heightM = 0.06;
    const auto profile = analyse({track}, shape, {});
    if (!profile)
        return {-1, 0};
    const auto metric = std::ranges::find(profile->metrics, "max_speed", &Metric::name);
    return {metric->value, metric->sigma.value_or(0)};
}

/// What became of the steps of all draws.
struct Tally
{
    int steps = 0, found = 0, doubted = 0, missed = 0, speedsRight = 0, runs = 0;
    double worstBefore = 0, worstAfter = 0; ///< errors of the top speed
};

} // namespace

/// Wrong intervals between the frames of a single view: found from the motion of its robots, or doubted, and
/// never seen in honest ones.
class TestFrameContinuity : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void areFoundOrDoubted_data();
    void areFoundOrDoubted();
    void longPausesAreDoubted();
    void longFrozenFramesAreFound();
    void aRobotThatIsSearchedAfterwardsWasFrozenToo();
    void whatStartsUnseenWasNotFrozen();
    void convertedVideosGetTheirTimes();
    void honestFramesAreLeftAlone_data();
    void honestFramesAreLeftAlone();
    void aRobotThatLeapsBesideAnotherIsNoLostFrame();
    void twoRobotsThatLeapTogetherAre();
    void aRobotAtRestShowsNoTime();
    void fewFramesShowNothing();
};

void TestFrameContinuity::areFoundOrDoubted_data()
{
    QTest::addColumn<int>("fault");
    QTest::newRow("lost") << int(FrameFault::Lost);
    QTest::newRow("doubled") << int(FrameFault::Doubled);
    QTest::newRow("doubled, the same image") << int(FrameFault::SameImage);
}

void TestFrameContinuity::areFoundOrDoubted()
{
    QFETCH(int, fault);
    Tally tally;
    for (unsigned seed = 1; seed <= drawsOfEach(); ++seed) {
        const FaultyView view = FrameFaultDrawer(FrameFault(fault), 7000 + seed).draw();
        const std::vector<FrameStep> steps = stepsOf(view);
        int found = 0;
        for (const FaultyView::Step &truth : view.steps) {
            ++tally.steps;
            const auto step = std::ranges::find(steps, truth.frame, &FrameStep::frame);
            const double shownM = std::abs(double(truth.lost)) * truth.speedMps / view.rate;
            if (step == steps.end()) {
                ++tally.missed;
                // a short leap of a slow robot, or one that moves by a pixel or less in a frame
                const bool isSlow = fault != int(FrameFault::Lost) && truth.speedMps / view.rate < 0.012;
                QVERIFY2(shownM < 0.03 || isSlow,
                         qPrintable(QStringLiteral("seed %1 frame %2: %3 frames at %4 m/s")
                                        .arg(seed)
                                        .arg(truth.frame)
                                        .arg(truth.lost)
                                        .arg(truth.speedMps)));
                continue;
            }
            if (step->kind == Kind::Leap || step->kind == Kind::Frozen || step->kind == Kind::Stood) {
                ++tally.doubted;
                continue;
            }
            ++tally.found;
            ++found;
            const std::int64_t said = step->kind == Kind::Lost ? step->frames : -step->frames;
            const double offS = std::abs(double(said - truth.lost)) / view.rate;
            QVERIFY2(offS <= 3 * step->step.sigmaS && offS * truth.speedMps < 0.01,
                     qPrintable(QStringLiteral("seed %1 frame %2: %3, not %4")
                                    .arg(seed)
                                    .arg(truth.frame)
                                    .arg(said)
                                    .arg(truth.lost)));
        }
        for (const FrameStep &step : steps)
            QVERIFY2(std::ranges::find(view.steps, step.frame, &FaultyView::Step::frame) != view.steps.end(),
                     qPrintable(QString::number(seed)));
        if (found != int(view.steps.size()))
            continue;
        const auto [before, ignored] = topSpeed(view, {});
        const auto [after, sigma] = topSpeed(view, repairOf(steps));
        ++tally.runs;
        tally.speedsRight +=
            std::abs(after - view.topSpeedMps) < std::max(2 * sigma, 0.01 * view.topSpeedMps);
        tally.worstBefore = std::max(tally.worstBefore, std::abs(before - view.topSpeedMps));
        tally.worstAfter = std::max(tally.worstAfter, std::abs(after - view.topSpeedMps));
    }
    qInfo(
        "%d steps: %d found, %d doubted, %d missed; top speed: right in %d of %d runs, at worst off by %.3f "
        "m/s, before by %.3f m/s",
        tally.steps, tally.found, tally.doubted, tally.missed, tally.speedsRight, tally.runs,
        tally.worstAfter, tally.worstBefore);
    QVERIFY(2 * tally.found >= tally.steps);
    QVERIFY(fault == int(FrameFault::Lost) || 3 * tally.missed <= tally.steps);
    QVERIFY(tally.worstAfter < 0.06);
}

void TestFrameContinuity::longPausesAreDoubted()
{
    int found = 0, doubted = 0, missed = 0;
    for (unsigned seed = 1; seed <= drawsOfEach(); ++seed) {
        const FaultyView view = FrameFaultDrawer(FrameFault::Pause, 7000 + seed).draw();
        const std::vector<FrameStep> steps = stepsOf(view);
        const FaultyView::Step &truth = view.steps.front();
        for (const FrameStep &step : steps)
            QCOMPARE(step.frame, truth.frame);
        if (steps.empty()) {
            ++missed;
            continue;
        }
        if (steps.front().kind == Kind::Leap) {
            ++doubted;
            continue;
        }
        ++found;
        QCOMPARE(steps.front().frames, truth.lost);
    }
    qInfo("%d found, %d doubted, %d missed", found, doubted, missed);
    QVERIFY(2 * missed <= int(drawsOfEach()));
}

/// While the time stamps go on rightly: the robot did not stand.
void TestFrameContinuity::longFrozenFramesAreFound()
{
    int found = 0, doubted = 0;
    for (unsigned seed = 1; seed <= drawsOfEach(); ++seed) {
        const FaultyView view = FrameFaultDrawer(FrameFault::LongFrozen, 7000 + seed).draw();
        for (const FrameStep &step : stepsOf(view)) {
            QCOMPARE(step.step.lengthS, 0.0);
            const auto frame = std::size_t(step.frame);
            QCOMPARE(view.takenS[frame - 1], view.takenS[frame - 2]); // the last one that is frozen
            if (step.kind == Kind::Leap) {
                ++doubted;
                continue;
            }
            ++found;
            QVERIFY(step.kind == Kind::Frozen);
            const auto frozen = std::ranges::count(view.takenS, view.takenS[frame - 1]) - 1;
            QVERIFY(std::abs(step.frames - frozen) <= 1);
        }
    }
    qInfo("%d found, %d doubted", found, doubted);
    QVERIFY(2 * found >= int(drawsOfEach()));
}

/// A tracker finds it again some frames later.
void TestFrameContinuity::aRobotThatIsSearchedAfterwardsWasFrozenToo()
{
    int found = 0;
    for (unsigned seed = 1; seed <= drawsOfEach(); ++seed) {
        FaultyView view = FrameFaultDrawer(FrameFault::LongFrozen, 7000 + seed).draw();
        for (std::size_t i = 4; i < view.takenS.size(); ++i)
            if (view.takenS[i - 4] == view.takenS[i - 3]) // the last ones, and three behind them
                view.observations[i].found = view.takenS[i] == view.takenS[i - 1];
        for (const FrameStep &step : stepsOf(view)) {
            QVERIFY(step.kind == Kind::Frozen);
            const auto frame = std::size_t(step.frame);
            QVERIFY(view.takenS[frame - 4] == view.takenS[frame - 5]);
            ++found;
        }
    }
    qInfo("%d found", found);
    QVERIFY(2 * found >= int(drawsOfEach()));
}

void TestFrameContinuity::whatStartsUnseenWasNotFrozen()
{
    for (unsigned seed = 1; seed <= 5 * drawsOfEach(); ++seed) {
        FaultyView view = FrameFaultDrawer(FrameFault::StopAndGo, 7000 + seed).draw();
        for (std::size_t i = 0; i < view.observations.size(); ++i)
            view.observations[i].found = view.observations[i].found && i % 25 > 4;
        for (const FrameStep &step : stepsOf(view))
            QVERIFY2(step.kind != Kind::Frozen, qPrintable(QStringLiteral("seed %1").arg(seed)));
    }
}

void TestFrameContinuity::convertedVideosGetTheirTimes()
{
    unsigned found = 0;
    for (unsigned seed = 1; seed <= drawsOfEach(); ++seed) {
        const FaultyView view = FrameFaultDrawer(FrameFault::Converted, 7000 + seed).draw();
        FrameTrack track = frameTrack(cameraA(), 0.06, view.observations);
        const auto conversion = findConversion({track}, view.frameTimes);
        if (!conversion) // a slow robot
            continue;
        ++found;
        QCOMPARE(conversion->every, std::int64_t(view.every));
        QVERIFY(!conversion->isTimed);
        const auto times = convertedTimes(*conversion, view.frameTimes);
        QVERIFY(std::ranges::is_sorted(times, std::less_equal<>()));
        for (std::size_t i = 0; i < times.size(); ++i)
            if (i == 0 || view.takenS[i] > view.takenS[i - 1])
                QVERIFY2(std::abs(toSeconds(times[i]) - view.takenS[i]) < 0.002,
                         qPrintable(QStringLiteral("seed %1 frame %2").arg(seed).arg(i)));
        for (FramePosition &position : track)
            position.timeS = toSeconds(times[std::size_t(position.frame)]);
        QVERIFY(findConversion({track}, times)->isTimed);
        QVERIFY(findFrameSteps({track}, times).empty());
    }
    qInfo("%u of %u found", found, drawsOfEach());
    QVERIFY(2 * found >= drawsOfEach());
}

void TestFrameContinuity::honestFramesAreLeftAlone_data()
{
    QTest::addColumn<int>("fault");
    QTest::newRow("nothing") << int(FrameFault::None);
    QTest::newRow("repeated, and caught up") << int(FrameFault::Frozen);
    QTest::newRow("stop and go") << int(FrameFault::StopAndGo);
    QTest::newRow("struck") << int(FrameFault::Struck);
    QTest::newRow("hidden") << int(FrameFault::Hidden);
}

void TestFrameContinuity::honestFramesAreLeftAlone()
{
    QFETCH(int, fault);
    for (unsigned seed = 1; seed <= 5 * drawsOfEach(); ++seed) {
        const FaultyView view = FrameFaultDrawer(FrameFault(fault), 7000 + seed).draw();
        QVERIFY(!findConversion({frameTrack(cameraA(), 0.06, view.observations)}, view.frameTimes));
        const std::vector<FrameStep> steps = stepsOf(view);
        for (const FrameStep &step : steps)
            QFAIL(qPrintable(QStringLiteral("seed %1: frame %2, kind %3, %4 frames, %5 m")
                                 .arg(seed)
                                 .arg(step.frame)
                                 .arg(int(step.kind))
                                 .arg(step.frames)
                                 .arg(step.leapM)));
    }
}

void TestFrameContinuity::aRobotThatLeapsBesideAnotherIsNoLostFrame()
{
    const FaultyView leaps = FrameFaultDrawer(FrameFault::Lost, 7001).draw(),
                     steady = FrameFaultDrawer(FrameFault::None, 7001).draw();
    QVERIFY(!stepsOf(leaps).empty());
    const std::vector<FrameTrack> tracks{frameTrack(cameraA(), 0.06, leaps.observations),
                                         frameTrack(cameraA(), 0.06, steady.observations)};
    QVERIFY(findFrameSteps(tracks, leaps.frameTimes).empty());
}

void TestFrameContinuity::twoRobotsThatLeapTogetherAre()
{
    const FaultyView view = FrameFaultDrawer(FrameFault::Lost, 7001).draw();
    FaultyView mirrored = view;
    for (Observation &seen : mirrored.observations)
        seen.ellipse.centrePx = Eigen::Vector2d(1280, 720) - seen.ellipse.centrePx;
    const std::vector<FrameTrack> tracks{frameTrack(cameraA(), 0.06, view.observations),
                                         frameTrack(cameraA(), 0.06, mirrored.observations)};
    const std::vector<FrameStep> steps = findFrameSteps(tracks, view.frameTimes), alone = stepsOf(view);
    QCOMPARE(steps.size(), alone.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        QCOMPARE(steps[i].frames, alone[i].frames);
        QVERIFY(steps[i].step.sigmaS < alone[i].step.sigmaS);
    }
}

void TestFrameContinuity::aRobotAtRestShowsNoTime()
{
    FaultyView view = FrameFaultDrawer(FrameFault::Lost, 7002).draw();
    for (Observation &seen : view.observations)
        seen.ellipse.centrePx = {600 + (seen.frame % 2 ? 0.1 : 0.0), 400};
    QVERIFY(stepsOf(view).empty());
}

void TestFrameContinuity::fewFramesShowNothing()
{
    QVERIFY(findFrameSteps({}, {}).empty());
    QVERIFY(findFrameSteps({{}}, {Nanoseconds(0)}).empty());
    FaultyView view = FrameFaultDrawer(FrameFault::Lost, 7002).draw();
    view.observations.resize(5);
    view.frameTimes.resize(5);
    QVERIFY(stepsOf(view).empty());
}

ODOGRAPH_TEST(TestFrameContinuity, QCoreApplication)
#include "tst_frame_continuity.moc"
