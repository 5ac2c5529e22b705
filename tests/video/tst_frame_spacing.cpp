// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/frame_times.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QTest>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

class TestFrameSpacing : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void anUnevenRateHasWords()
    {
        std::vector<Nanoseconds> times;
        for (int i = 0; i < 60; ++i)
            times.push_back(40ms * i + (i % 5 == 4 ? 25ms : 0ms));
        QCOMPARE(unevenRateWords(times).english(),
                 std::string(
                     "its frame rate varies: frames are 15 to 65 ms apart; each frame keeps its own time"));
        QCOMPARE(spacingOf(times).usual, Nanoseconds(40ms));
        QVERIFY(spacingOf(times).isVariable);
    }

    void evenAndMissingPicturesHaveNone()
    {
        std::vector<Nanoseconds> times = evenTimes(100, 30);
        QVERIFY(unevenRateWords(times).isEmpty());
        QVERIFY(!spacingOf(times).isVariable);
        times.erase(times.begin() + 20, times.begin() + 23);
        times.erase(times.begin() + 60);
        QVERIFY(unevenRateWords(times).isEmpty());
        QVERIFY(spacingOf(times).isVariable);
    }

    /// At most one interval in twenty: a camera may stumble.
    void aStumbleIsNoUnevenRate()
    {
        std::vector<Nanoseconds> times = evenTimes(101, 50);
        times[50] += 8ms; // two intervals of a hundred
        QVERIFY(unevenRateWords(times).isEmpty());
        times[20] += 8ms;
        times[70] += 8ms; // six
        QVERIFY(!unevenRateWords(times).isEmpty());
    }

    void tooFewPicturesHaveNoSpacing()
    {
        for (const std::vector<Nanoseconds> &times :
             std::vector<std::vector<Nanoseconds>>{{}, {5ms}, {5ms, 5ms}, {5ms, 12ms}})
            QVERIFY(unevenRateWords(times).isEmpty());
        QCOMPARE(spacingOf({}).usual, Nanoseconds(0));
        QCOMPARE(spacingOf({5ms, 12ms}).usual, Nanoseconds(7ms));
    }
};

ODOGRAPH_TEST(TestFrameSpacing, QCoreApplication)
#include "tst_frame_spacing.moc"
