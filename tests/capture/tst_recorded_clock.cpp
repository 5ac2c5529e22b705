// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_session.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace odo;
using namespace std::chrono_literals;

namespace {

constexpr Nanoseconds interval = 33ms, start = 1000s;

/// A recording by a camera whose clock drifts, and drifts otherwise as it warms up; pictures arrive up to 5
/// ms late.
struct Recorded
{
    RecordedTimes times;
    std::vector<Nanoseconds> truth;
};

Recorded recordedWith(double rateAtFirst, double rateAtLast, int frames, bool readings)
{
    Recorded recorded;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> lateS(0, 0.005);
    double deviceS = 7;
    for (int i = 0; i < frames; ++i) {
        const Nanoseconds taken = start + i * interval;
        const Nanoseconds device = fromSeconds(deviceS);
        if (readings && i % 30 == 0)
            recorded.times.readings.push_back({device, taken - 100us, taken + 100us});
        recorded.times.frames.push_back({std::uint64_t(i), device, taken + fromSeconds(lateS(random))});
        recorded.truth.push_back(taken);
        deviceS += toSeconds(interval) * (1 - rateAtFirst - (rateAtLast - rateAtFirst) * i / frames);
    }
    return recorded;
}

double worstS(const Recorded &recorded)
{
    const DerivedTimes derived = deriveTimes(recorded.times);
    double worst = 0;
    for (std::size_t i = 0; i < derived.taken.size(); ++i)
        worst = std::max(worst, std::abs(toSeconds(derived.taken[i] - recorded.truth[i])));
    return derived.taken.size() == recorded.truth.size() ? worst : 1;
}

} // namespace

class TestRecordedClock : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aShortRecordingIsOneLine()
    {
        // The lower edge of 5 ms of jitter over 300 pictures lies within 0.3 ms of the truth.
        QVERIFY2(worstS(recordedWith(100e-6, 100e-6, 300, false)) < 0.0003, "");
    }
    void aQuartzThatWarmsUpIsFollowed()
    {
        // Ten minutes, from −100 to +100 ppm: one line through all of it would be wrong by 15 ms.
        const double fromArrivals = worstS(recordedWith(-100e-6, 100e-6, 18000, false));
        QVERIFY2(fromArrivals < 0.001, qPrintable(QString::number(fromArrivals)));
        const double fromReadings = worstS(recordedWith(-100e-6, 100e-6, 18000, true));
        QVERIFY2(fromReadings < 0.0003, qPrintable(QString::number(fromReadings)));
    }
    void aClockThatWasSetAnewBeginsAnew()
    {
        Recorded recorded = recordedWith(0, 0, 300, true), again = recordedWith(0, 0, 300, true);
        for (std::size_t i = 0; i < again.truth.size(); ++i) {
            again.truth[i] += 60s;
            again.times.frames[i].arrival += 60s;
            recorded.truth.push_back(again.truth[i]);
            recorded.times.frames.push_back(again.times.frames[i]);
        }
        for (ClockReading reading : again.times.readings)
            recorded.times.readings.push_back({reading.device, reading.before + 60s, reading.after + 60s});
        QVERIFY(worstS(recorded) < 0.0003);
    }
    void aScaleThatJumpsForwardIsParted_data()
    {
        QTest::addColumn<double>("jumpS");
        QTest::addColumn<double>("lateS");
        // A camera that was away for two seconds, whose scale went on by a picture that was late.
        QTest::newRow("by a little") << 0.2 << 0.0;
        QTest::newRow("by much") << 20.0 << 0.0;
        QTest::newRow("back, less than the gap") << -1.5 << 0.0;
        QTest::newRow("pictures from before come after a reading of the new scale") << 20.0 << 3.0;
    }
    void aScaleThatJumpsForwardIsParted()
    {
        QFETCH(double, jumpS);
        QFETCH(double, lateS);
        constexpr Nanoseconds away = 2s;
        Recorded recorded = recordedWith(50e-6, 50e-6, 300, true);
        const std::size_t jump = 145; // between two readings
        const Nanoseconds at = recorded.truth[jump];
        for (std::size_t i = 0; i < recorded.truth.size(); ++i) {
            RawTime &image = recorded.times.frames[i];
            if (i < jump) {
                image.arrival += fromSeconds(lateS);
                continue;
            }
            recorded.truth[i] += away;
            image.arrival += away;
            image.device += away + fromSeconds(jumpS);
        }
        for (ClockReading &reading : recorded.times.readings) {
            if (reading.before < at)
                continue;
            reading.before += away;
            reading.after += away;
            reading.device += away + fromSeconds(jumpS);
        }
        const double worst = worstS(recorded);
        QVERIFY2(worst < 0.0003, qPrintable(QString::number(worst)));
    }
    void timesAlwaysIncrease()
    {
        RecordedTimes times;
        for (const Nanoseconds device : {1s, 2s, 2s, 1s})
            times.frames.push_back({0, device, 5s});
        const DerivedTimes derived = deriveTimes(times);
        QCOMPARE(derived.taken.size(), std::size_t(4));
        for (std::size_t i = 1; i < 4; ++i)
            QVERIFY(derived.taken[i] > derived.taken[i - 1]);
        QVERIFY(deriveTimes({}).taken.empty());
    }
};

ODOGRAPH_TEST(TestRecordedClock, QCoreApplication)
#include "tst_recorded_clock.moc"
