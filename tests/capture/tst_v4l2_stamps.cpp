// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/internal/v4l2_stream.h"

#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace std::chrono_literals;

namespace {

constexpr Nanoseconds period = 40ms, start = 1000s, delay = 2ms;

Nanoseconds taken(int image)
{
    return start + image * period;
}
std::uint64_t raw(Nanoseconds time)
{
    return static_cast<std::uint64_t>(time.count());
}

} // namespace

class TestV4l2Stamps : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void timesOfThisMachineAreReadings()
    {
        V4l2Stamps stamps;
        for (int i = 0; i < 5; ++i) {
            const auto stamp =
                stamps.next({100U + static_cast<std::uint32_t>(i), raw(taken(i)), true}, taken(i) + delay);
            QCOMPARE(stamp.sequence, std::uint64_t(i));
            QCOMPARE(stamp.time, i * period);
            QVERIFY(stamp.clock);
            QCOMPARE(stamp.clock->device, stamp.time);
            QCOMPARE(stamp.clock->before, taken(i));
        }
    }

    void timesInTheFutureOrOfAnotherClockAreNone()
    {
        V4l2Stamps future, foreign, unsure;
        for (int i = 0; i < 3; ++i) {
            const auto number = static_cast<std::uint32_t>(i);
            QVERIFY(!future.next({number, raw(taken(i) + 34ms), true}, taken(i)).clock);
            QVERIFY(!foreign.next({number, raw(taken(i) - 500s), true}, taken(i)).clock);
            const auto stamp = unsure.next({number, raw(taken(i)), false}, taken(i) + delay);
            QVERIFY(!stamp.clock);
            QCOMPARE(stamp.time, i * period);
        }
    }

    void countsGoOnPastTheirEnd()
    {
        V4l2Stamps stamps;
        std::uint64_t expected = 0;
        for (const std::uint32_t number : {0xfffffffeU, 0xffffffffU, 0U, 1U, 5U}) {
            const auto stamp = stamps.next({number, raw(taken(int(expected))), true}, taken(int(expected)));
            QCOMPARE(stamp.sequence, expected);
            expected += number == 1U ? 4 : 1;
        }
    }

    void aNumberThatRepeatsIsNoLoss()
    {
        V4l2Stamps stamps;
        int i = 0;
        std::vector<std::uint64_t> counts;
        for (const std::uint32_t number : {5U, 6U, 6U, 8U, 9U, 12U, 12U, 12U}) {
            counts.push_back(stamps.next({number, raw(taken(i)), true}, taken(i)).sequence);
            ++i;
        }
        QCOMPARE(counts, (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 7, 8, 9}));
    }

    /// Nanoseconds in 64 bits end; so do those that a driver makes of 31 bits of seconds.
    void timesGoOnPastTheirEnd()
    {
        for (const std::uint64_t last : {0x7fffffffffffffffULL - 60'000'000ULL, ~0ULL - 60'000'000ULL}) {
            V4l2Stamps stamps;
            for (int i = 0; i < 5; ++i) {
                const auto stamp =
                    stamps.next({static_cast<std::uint32_t>(i), last + raw(i * period), true}, taken(i));
                QCOMPARE(stamp.time, i * period);
                QVERIFY(!stamp.clock);
            }
        }
    }

    void aClockThatJumpsIsBridgedByTheArrivals()
    {
        V4l2Stamps stamps;
        Nanoseconds last = -1ns;
        const std::vector<Nanoseconds> told{0s, 40ms, 80ms, 20ms, 60ms, 5000s, 5000s + 40ms, 5000s + 40ms};
        for (int i = 0; i < int(told.size()); ++i) {
            const auto stamp = stamps.next(
                {static_cast<std::uint32_t>(i), raw(start + told[std::size_t(i)]), true}, taken(i) + delay);
            QVERIFY(stamp.time > last);
            QCOMPARE(stamp.time, i * period);
            QCOMPARE(stamp.clock.has_value(), i < 3); // a clock that has gone wrong once is trusted no more
            last = stamp.time;
        }
    }

    void whatTheCameraMissedWhileItWasAwayIsLost()
    {
        V4l2Stamps stamps;
        QCOMPARE(stamps.next({7, raw(taken(0)), true}, taken(0)).sequence, std::uint64_t(0));
        stamps.restart(25);
        const auto stamp = stamps.next({0, raw(taken(50)), true}, taken(50));
        QCOMPARE(stamp.sequence, std::uint64_t(50));
        QCOMPARE(stamp.time, 50 * period);
        QCOMPARE(stamps.next({1, raw(taken(51)), true}, taken(51)).sequence, std::uint64_t(51));
    }
};

ODOGRAPH_TEST(TestV4l2Stamps, QCoreApplication)
#include "tst_v4l2_stamps.moc"
