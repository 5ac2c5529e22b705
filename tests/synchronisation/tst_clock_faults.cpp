// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/frame_rate_labels.h"
#include "tests/support/registered_test.h"
#include "tests/synchronisation/clock_faults.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

/// How many of each kind: a sample, or with ODOGRAPH_CLOCK_FAULTS=20 what is claimed (docs/testing.md).
unsigned drawsOfEach()
{
    const int given = qEnvironmentVariableIntValue("ODOGRAPH_CLOCK_FAULTS");
    return given > 0 ? unsigned(given) : 2;
}

/// Another number draws others.
unsigned firstSeed()
{
    const int given = qEnvironmentVariableIntValue("ODOGRAPH_FIRST_SEED");
    return given > 0 ? unsigned(given) : 1;
}

} // namespace

/// Wrong time stamps of one view or both: found from the motion, or refused, but never wrong in silence.
class TestClockFaults : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void areFoundOrDoubted_data();
    void areFoundOrDoubted();
    void theMomentOfAPauseIsFound();
    void aStillRobotIsCalledStill();
    void differentRunsAreCalledSo();
    void aTurnedViewIsCalledSo();
    void aShortOverlapIsCalledSo();
    void usualLabelsAreNamed();
};

void TestClockFaults::areFoundOrDoubted_data()
{
    QTest::addColumn<int>("fault");
    QTest::addColumn<double>("drift");
    QTest::addColumn<bool>("isFoundAlways");
    const auto row = [](const char *name, ClockFault fault, double drift, bool always) {
        QTest::newRow(name) << int(fault) << drift << always;
    };
    row("nothing", ClockFault::None, 0, true);
    row("lost in the second", ClockFault::LostInSecond, 0, false);
    row("lost in the first", ClockFault::LostInFirst, 0, false);
    row("lost in both", ClockFault::LostInBoth, 0, false);
    row("doubled", ClockFault::Doubled, 0, false);
    row("pause", ClockFault::Pause, 0, false);
    row("restart", ClockFault::Restart, 0, false);
    row("25 for 30", ClockFault::Label, 0, true);
    for (const double drift : {1e-4, 3e-4, -1e-3, 3e-3, 0.00567, -0.01, 0.02, -0.02}) {
        const QByteArray name = QByteArray::number(100 * drift) + " %";
        row(name.constData(), ClockFault::Drift, drift, true);
    }
}

void TestClockFaults::areFoundOrDoubted()
{
    QFETCH(int, fault);
    QFETCH(double, drift);
    QFETCH(bool, isFoundAlways);
    unsigned found = 0;
    double sigmaS = 0;
    QStringList wrong;
    for (unsigned seed = firstSeed(); seed < firstSeed() + drawsOfEach(); ++seed) {
        FaultSettings settings;
        settings.fault = ClockFault(fault);
        settings.drift = drift;
        const FaultyClips clips = drawClips(settings, seed);
        const auto answer = estimateClipOffset(clips.first, clips.second, {0, 10});
        if (!answer) {
            qInfo("seed %u is refused: %s", seed, answer.error().why.english().c_str());
            continue;
        }
        ++found;
        sigmaS += answer->sigmaS;
        const double errorS = relationErrorS(clips, *answer);
        const std::size_t steps = answer->first.steps.size() + answer->second.steps.size();
        // a millisecond is less than any σ of such runs, and harmless
        const bool isHeld = errorS < std::max(3 * answer->sigmaS, 0.001);
        const bool isLabelRight = settings.fault != ClockFault::Label ||
                                  std::abs(answer->rate - 0.2) < 0.001 + 3 * answer->rateSigma;
        const bool isQuiet = settings.fault != ClockFault::None || (steps == 0 && answer->sigmaS < 0.02);
        if (!isHeld || !isLabelRight || !isQuiet)
            wrong << QStringLiteral("seed %1: %2 ms off, σ %3 ms, rate %4 ±%5, %6 steps")
                         .arg(seed)
                         .arg(1e3 * errorS)
                         .arg(1e3 * answer->sigmaS)
                         .arg(answer->rate)
                         .arg(answer->rateSigma)
                         .arg(steps);
    }
    qInfo("%u of %u found, mean σ %.1f ms", found, drawsOfEach(), 1e3 * sigmaS / std::max(found, 1U));
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    QVERIFY2(sigmaS < 0.1 * found, "a σ of a second would hold anything");
    QVERIFY2(found == drawsOfEach() || !isFoundAlways, qPrintable(QString::number(found)));
    QVERIFY2(2 * found >= drawsOfEach(), qPrintable(QString::number(found)));
}

/// To the frame: one that is put on the wrong side of a pause of a second is half a metre off.
void TestClockFaults::theMomentOfAPauseIsFound()
{
    for (const unsigned seed : {5U, 6U, 7U, 8U}) {
        FaultyClips clips = drawClips({}, seed);
        const bool isLostAfterwards = seed % 2 == 0; // as trackers lose a robot that leaps
        // the second camera pauses for a second: 30 frames are not there, and the stamps go on
        clips.second.erase(clips.second.begin() + 120, clips.second.begin() + 150);
        for (std::size_t i = 0; i < clips.second.size(); ++i)
            clips.second[i].timeS = double(i) / 30;
        if (isLostAfterwards)
            clips.second.erase(clips.second.begin() + 120, clips.second.begin() + 129);
        const auto answer = estimateClipOffset(clips.first, clips.second, {0, 10});
        QVERIFY2(answer, answer ? "" : answer.error().message().c_str());
        QCOMPARE(answer->second.steps.size(), std::size_t(1));
        QVERIFY(answer->first.steps.empty());
        const ClockStep &step = answer->second.steps.front();
        qInfo("after %.3f s, %.4f ± %.4f s", step.afterS, step.lengthS, step.sigmaS);
        QVERIFY2(std::abs(step.afterS - 119.5 / 30) < 0.6 / 30, qPrintable(QString::number(step.afterS)));
        QVERIFY2(std::abs(step.lengthS - 1) < 3 * step.sigmaS + 0.001,
                 qPrintable(QString::number(step.lengthS)));
    }
}

void TestClockFaults::aStillRobotIsCalledStill()
{
    FaultyClips clips = drawClips({}, 3);
    for (auto *track : {&clips.first, &clips.second})
        for (std::size_t i = 0; i < track->size(); ++i)
            (*track)[i].pointInWorld = Eigen::Vector2d(1 + (i % 2 ? 0.002 : 0), 1);
    const auto answer = estimateClipOffset(clips.first, clips.second, {0, 10});
    QVERIFY(!answer);
    QCOMPARE(answer.error().why.english(), std::string("the robot stood still, so every time offset fits"));
}

void TestClockFaults::differentRunsAreCalledSo()
{
    const FaultyClips one = drawClips({}, 3), other = drawClips({}, 4);
    const auto answer = estimateClipOffset(one.first, other.second, {0, 10});
    QVERIFY(!answer);
    QVERIFY2(answer.error().why.english().find("different runs") != std::string::npos,
             answer.error().why.english().c_str());
}

void TestClockFaults::aTurnedViewIsCalledSo()
{
    FaultyClips clips = drawClips({}, 3);
    for (TimedPosition &position : clips.second)
        position.pointInWorld = Eigen::Vector2d(-0.8 * position.pointInWorld.y(), position.pointInWorld.x());
    const auto answer = estimateClipOffset(clips.first, clips.second, {0, 10});
    QVERIFY(!answer);
    QVERIFY2(answer.error().why.english().find("a camera has moved since its registration") !=
                 std::string::npos,
             answer.error().why.english().c_str());
}

void TestClockFaults::aShortOverlapIsCalledSo()
{
    FaultSettings settings;
    settings.durationS = 20;
    FaultyClips clips = drawClips(settings, 3);
    clips.first.resize(300);
    clips.second.erase(clips.second.begin(), clips.second.begin() + 200);
    const double startS = clips.second.front().timeS;
    for (TimedPosition &position : clips.second)
        position.timeS -= startS;
    const auto answer = estimateClipOffset(clips.first, clips.second, {0, 10});
    QVERIFY(!answer);
    QVERIFY2(answer.error().why.english().find("in common") != std::string::npos,
             answer.error().why.english().c_str());
}

void TestClockFaults::usualLabelsAreNamed()
{
    QCOMPARE(rateBehindLabel(25, 0.2).value_or(0), 30.0);
    QCOMPARE(rateBehindLabel(30, 1).value_or(0), 60.0);
    QVERIFY(!rateBehindLabel(30, 0.3));  // 39 frames/s
    QVERIFY(!rateBehindLabel(30, 1e-4)); // the same
    QVERIFY(!rateBehindLabel(27, 0.2));
}

ODOGRAPH_TEST(TestClockFaults, QCoreApplication)
#include "tst_clock_faults.moc"
