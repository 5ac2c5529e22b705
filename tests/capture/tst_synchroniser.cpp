// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/synchroniser.h"

#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace std::chrono_literals;

namespace {

constexpr Nanoseconds interval = 33ms;
const Synchroniser::Settings twoViews{2, interval / 2, 150ms};

TimedFrame takenAt(Nanoseconds time)
{
    TimedFrame frame;
    frame.taken = time;
    return frame;
}

/// "12+15" for each set: when its pictures were taken, in ms.
QStringList words(const std::vector<FrameSet> &sets)
{
    QStringList all;
    for (const FrameSet &set : sets) {
        QStringList one;
        for (const auto &frame : set.views)
            one << (frame ? QString::number(frame->taken / 1ms) : QStringLiteral("-"));
        all << one.join(u'+');
    }
    return all;
}

} // namespace

class TestSynchroniser : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void pairsByTimeWhateverTheOrderOfArrival()
    {
        Synchroniser synchroniser(twoViews);
        for (int i = 0; i < 3; ++i)
            synchroniser.add(1, takenAt(5ms + i * interval));
        QVERIFY(synchroniser.take(70ms).empty()); // the first view has sent nothing yet
        for (int i = 0; i < 3; ++i)
            synchroniser.add(0, takenAt(i * interval));
        // The third may yet be nearer to a picture of the first view that is still to come.
        QCOMPARE(words(synchroniser.take(75ms)),
                 QStringList({QStringLiteral("0+5"), QStringLiteral("33+38")}));
        QCOMPARE(words(synchroniser.takeRest()), QStringList(QStringLiteral("66+71")));
        const PairStatistics statistics = synchroniser.takeStatistics();
        QCOMPARE(statistics.pairs, 3u);
        QCOMPARE(statistics.unpaired, 0u);
        QCOMPARE(synchroniser.takeStatistics().pairs, 0u); // they were taken
        for (const double errorS : statistics.errorsS)
            QCOMPARE(errorS, 0.005);
    }

    void lostPicturesLeaveTheirPartnersAlone()
    {
        Synchroniser synchroniser(twoViews);
        for (const int i : {0, 1, 3, 4})
            synchroniser.add(0, takenAt(i * interval));
        for (const int i : {0, 2, 3, 4})
            synchroniser.add(1, takenAt(2ms + i * interval));
        QCOMPARE(words(synchroniser.takeRest()),
                 QStringList({QStringLiteral("0+2"), QStringLiteral("33+-"), QStringLiteral("99+101"),
                              QStringLiteral("132+134")}));
        const PairStatistics statistics = synchroniser.takeStatistics();
        QCOMPARE(statistics.pairs, 3u);
        QCOMPARE(statistics.unpaired, 2u);
    }

    void eachPictureBelongsToItsNearest()
    {
        // The second view at half the rate: every other picture of the first one has no partner, and the one
        // between does not take its neighbour's.
        Synchroniser synchroniser(twoViews);
        for (int i = 0; i < 4; ++i)
            synchroniser.add(0, takenAt(i * interval));
        synchroniser.add(1, takenAt(20ms));
        synchroniser.add(1, takenAt(86ms));
        QCOMPARE(words(synchroniser.takeRest()),
                 QStringList({QStringLiteral("0+-"), QStringLiteral("33+20"), QStringLiteral("66+-"),
                              QStringLiteral("99+86")}));
        QCOMPARE(synchroniser.takeStatistics().unpaired, 2u);
    }

    void aStalledViewHoldsTheOtherUpNoLongerThanAllowed()
    {
        Synchroniser synchroniser(twoViews);
        synchroniser.add(0, takenAt(0ms));
        synchroniser.add(0, takenAt(interval));
        QVERIFY(synchroniser.take(149ms).empty());
        QCOMPARE(words(synchroniser.take(150ms)), QStringList(QStringLiteral("0+-")));
        QCOMPARE(synchroniser.takeStatistics().unpaired, 1u);
    }

    void picturesDoNotPileUpWhileTheFirstViewStalls()
    {
        Synchroniser synchroniser(twoViews);
        for (int i = 0; i < 100; ++i) {
            synchroniser.add(1, takenAt(i * interval));
            QVERIFY(synchroniser.take(i * interval).empty());
        }
        // Those of the last 150 ms and half an interval may still find a partner.
        QCOMPARE(synchroniser.takeStatistics().unpaired, 94u);
        synchroniser.add(0, takenAt(99 * interval + 1ms));
        QCOMPARE(words(synchroniser.takeRest()), QStringList(QStringLiteral("3268+3267")));
    }

    void aPictureOutOfOrderIsDroppedAndCounted()
    {
        Synchroniser synchroniser(twoViews);
        synchroniser.add(0, takenAt(50ms));
        synchroniser.add(0, takenAt(50ms));
        synchroniser.add(0, takenAt(10ms));
        QCOMPARE(synchroniser.takeStatistics().unpaired, 2u);
        QCOMPARE(synchroniser.takeRest().size(), std::size_t(1));
    }

    void threeViewsAndOneAlone()
    {
        Synchroniser three({3, interval / 2, 150ms});
        three.add(0, takenAt(10ms));
        three.add(1, takenAt(12ms));
        three.add(2, takenAt(8ms));
        QCOMPARE(words(three.takeRest()), QStringList(QStringLiteral("10+12+8")));
        QCOMPARE(three.takeStatistics().pairs, 2u);

        Synchroniser one({1, interval / 2, 150ms});
        one.add(0, takenAt(10ms));
        one.add(0, takenAt(43ms));
        // nothing to wait for but its follower
        QCOMPARE(words(one.take(44ms)), QStringList(QStringLiteral("10")));
        const PairStatistics statistics = one.takeStatistics();
        QCOMPARE(statistics.pairs, 0u);
        QCOMPARE(statistics.unpaired, 0u);
    }
};

ODOGRAPH_TEST(TestSynchroniser, QCoreApplication)
#include "tst_synchroniser.moc"
