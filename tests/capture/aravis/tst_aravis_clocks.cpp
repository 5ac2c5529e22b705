// SPDX-License-Identifier: GPL-3.0-or-later
// How well the times of GigE pictures are known: cameras whose clocks are an hour apart, run 100 ppm fast and
// slow, and whose pictures come up to 5 ms late at random. The truth is written in the pictures.
#include "core/capture/capture_session.h"
#include "core/capture/synchroniser.h"
#include "tests/capture/aravis/frame_taker.h"
#include "tests/support/registered_test.h"

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

constexpr Nanoseconds exposure = 4ms, phase = 11ms;
constexpr std::size_t enough = 210; // seven seconds

SimulatedGigeCamera::Settings cameraSettings(const char *address, bool second, bool latch)
{
    SimulatedGigeCamera::Settings settings;
    settings.address = address;
    settings.serial = address;
    settings.exposureS = toSeconds(exposure);
    settings.clockOffsetS = second ? 3600 : 5;
    settings.clockPpm = second ? -100 : 100;
    settings.ticksPerSecond = second ? 125'000'000 : 1'000'000'000;
    static const Nanoseconds beginning = steadyNow(); // of all of them, however long each takes to begin
    settings.grid = beginning + (second ? phase : 0ns);
    settings.deliveryJitterS = 0.005;
    settings.timestampLatch = latch;
    settings.seed = second ? 2 : 1;
    return settings;
}

struct TakenTimes
{
    DerivedTimes derived;
    std::vector<FrameTaker::Taken> frames;

    explicit TakenTimes(const FrameTaker &taker) : frames(taker.frames())
    {
        RecordedTimes times;
        for (const auto &frame : frames) {
            times.frames.push_back({frame.sequence, frame.time, frame.hostTime});
            if (frame.clock)
                times.readings.push_back(*frame.clock);
        }
        derived = deriveTimes(times);
    }
    /// By how much the middle of each exposure is thought to be later than it was.
    std::vector<double> errorsMs() const
    {
        std::vector<double> errors;
        for (std::size_t i = 0; i < frames.size(); ++i)
            errors.push_back(1e3 * toSeconds(derived.taken[i] - frames[i].code.begin - exposure / 2));
        return errors;
    }
};

double rms(const std::vector<double> &values)
{
    double squares = 0;
    for (const double value : values)
        squares += value * value;
    return std::sqrt(squares / static_cast<double>(values.size()));
}

double median(std::vector<double> values)
{
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// How many of these pictures were taken while the others were, too.
std::size_t takenBeside(const TakenTimes &others, const TakenTimes &these)
{
    const Nanoseconds from = others.frames.front().code.begin, to = others.frames.back().code.begin;
    return static_cast<std::size_t>(std::ranges::count_if(
        these.frames, [&](const auto &frame) { return frame.code.begin >= from && frame.code.begin <= to; }));
}

/// By how much the pictures of both are thought to be further apart than they were.
std::vector<double> pairErrorsMs(const TakenTimes &a, const TakenTimes &b)
{
    std::vector<double> errors;
    const auto errorsOfA = a.errorsMs(), errorsOfB = b.errorsMs();
    for (std::size_t i = 0; i < std::min(errorsOfA.size(), errorsOfB.size()); ++i)
        errors.push_back(errorsOfB[i] - errorsOfA[i]);
    return errors;
}

} // namespace

class TestAravisClocks : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void timesAreThoseOfTheTruth();
};

/// Both kinds of cameras at once, because it takes its time.
void TestAravisClocks::timesAreThoseOfTheTruth()
{
    SimulatedGigeCamera readA(cameraSettings("127.31.3.2", false, true), codedPainter()),
        readB(cameraSettings("127.31.3.3", true, true), codedPainter());
    SimulatedGigeCamera mutedA(cameraSettings("127.31.3.4", false, false), codedPainter()),
        mutedB(cameraSettings("127.31.3.5", true, false), codedPainter());
    std::vector<std::unique_ptr<CameraSource>> sources;
    for (const char *address : {"127.31.3.2", "127.31.3.3", "127.31.3.4", "127.31.3.5"}) {
        sources.push_back(opened(std::string("aravis:") + address));
        QVERIFY(sources.back());
    }
    FrameTaker takerA(*sources[0]), takerB(*sources[1]), lateA(*sources[2]), lateB(*sources[3]);
    for (const FrameTaker *taker : {&takerA, &takerB, &lateA, &lateB})
        QTRY_VERIFY_WITH_TIMEOUT(taker->count() > enough, 30000 * slowness);

    const TakenTimes a(takerA), b(takerB);
    for (const TakenTimes *times : {&a, &b}) {
        const double off = rms(times->errorsMs());
        qInfo("clock read: RMS %.3f ms, said %.3f ms", off, 1e3 * times->derived.sigmaS);
        QVERIFY2(off < 0.3, qPrintable(QString::number(off)));
    }
    QVERIFY(rms(pairErrorsMs(a, b)) < 0.3);
#ifdef __SANITIZE_THREAD__ // most pictures are lost there, and the others arrive seconds late
    return;
#endif

    const TakenTimes c(lateA), d(lateB);
    const double off = rms(pairErrorsMs(c, d)), late = median(c.errorsMs());
    qInfo("clock learnt from arrivals: RMS of pairs %.3f ms; late by %.3f ms", off, late);
    QVERIFY2(off < 1, qPrintable(QString::number(off)));
    // Late by half an exposure and the transfer, which is the same for both.
    QVERIFY2(late > 1.9 && late < 6, qPrintable(QString::number(late)));

    const PairStatistics wide = pairStatistics({a.derived.taken, b.derived.taken}, 15ms),
                         narrow = pairStatistics({a.derived.taken, b.derived.taken}, 5ms);
    QVERIFY(wide.pairs > takenBeside(b, a) * 9 / 10); // cameras begin one after the other
    QVERIFY(wide.pairs > enough / 3);
    QCOMPARE(narrow.pairs, 0u);
    const double apart = 1e3 * median(wide.errorsS);
    const double truth = 1e3 * toSeconds(b.frames[100].code.begin - a.frames[100].code.begin),
                 interval = 1e3 / 30;
    const double expected = std::remainder(truth, interval);
    // The cameras drift apart by 200 ppm: 1.4 ms in these seconds.
    QVERIFY2(std::abs(apart - expected) < 1.5,
             qPrintable(QStringLiteral("%1 for %2").arg(apart).arg(expected)));
}

ODOGRAPH_TEST(TestAravisClocks, QCoreApplication)
#include "tst_aravis_clocks.moc"
