// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/clock_map.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace odo;
using namespace std::chrono_literals;

namespace {

/// A camera's clock: started at another time and going at another rate than the host's.
struct Quartz
{
    double startS = 1000, partsPerMillion = 0;
    Nanoseconds at(double hostS) const
    {
        return fromSeconds((hostS - startS) / (1 + partsPerMillion * 1e-6));
    }
};

constexpr double frameS = 1.0 / 30, exposureS = 0.005;

/// Lets 12 s of pictures arrive, delayed by the exposure and by 0 to 5 ms more; gives the errors of the
/// translated times from the third second on, less the exposure.
std::vector<double> errorsOfArrivals(ClockMap &map, const Quartz &quartz, std::mt19937 &random)
{
    std::uniform_real_distribution<double> delayS(0, 0.005);
    std::vector<double> errors;
    for (int i = 0; i < 360; ++i) {
        const double takenS = 2000 + i * frameS;
        const Nanoseconds device = quartz.at(takenS);
        map.addArrival(device, fromSeconds(takenS + exposureS + delayS(random)));
        if (i >= 90)
            errors.push_back(toSeconds(map.fit()->hostTime(device)) - takenS - exposureS);
    }
    return errors;
}

double rms(const std::vector<double> &values)
{
    double squares = 0;
    for (const double value : values)
        squares += value * value;
    return std::sqrt(squares / double(values.size()));
}

} // namespace

class TestClockMap : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void knowsNothingAtFirst()
    {
        ClockMap map;
        QVERIFY(!map.fit());
        map.addLatch(1s, 5s, 5s + 1ms);
        map.addLatch(2s, 6s, 6s + 1ms);
        QVERIFY(!map.fit()); // two readings tell nothing of how well they fit
        map.addArrival(2s, 6s);
        QVERIFY(map.fit());
        QCOMPARE(map.fit()->hostTime(3s), Nanoseconds(7s));
    }

    void followsADriftingClockByArrivals_data()
    {
        QTest::addColumn<double>("partsPerMillion");
        QTest::newRow("slow") << -100.0;
        QTest::newRow("even") << 0.0;
        QTest::newRow("fast") << 100.0;
    }

    void followsADriftingClockByArrivals()
    {
        QFETCH(double, partsPerMillion);
        for (unsigned seed = 1; seed <= 20; ++seed) {
            std::mt19937 random(seed);
            ClockMap map;
            const auto errors = errorsOfArrivals(map, {1000, partsPerMillion}, random);
            // The least of seven or eight delays, each even between 0 and 5 ms, is 0.6 ms; the hull lies
            // below most of those.
            QVERIFY2(rms(errors) < 0.4e-3, qPrintable(QString::number(rms(errors) * 1e3)));
            QVERIFY(std::abs(map.fit()->rate * 1e6 - partsPerMillion) < 60);
            QCOMPARE(map.fit()->source, ClockFit::Source::Arrival);
        }
    }

    void delaysOfHalfASecondDoNotDragIt()
    {
        std::mt19937 random(3);
        ClockMap map;
        const Quartz quartz{1000, 50};
        for (int i = 0; i < 600; ++i) {
            const double takenS = 2000 + i * frameS, lateS = i > 300 && i < 315 ? 0.5 : 0.001;
            map.addArrival(quartz.at(takenS), fromSeconds(takenS + lateS));
        }
        const double error = toSeconds(map.fit()->hostTime(quartz.at(2020))) - 2020 - 0.001;
        QVERIFY2(std::abs(error) < 50e-6, qPrintable(QString::number(error * 1e6)));
        QCOMPARE(map.epoch(), 0);
    }

    void latchesGiveTheTimeWithoutTheExposure()
    {
        std::mt19937 random(5);
        std::exponential_distribution<double> wayS(1 / 40e-6);
        for (const double partsPerMillion : {80.0, -120.0}) {
            ClockMap map;
            const Quartz quartz{5000, partsPerMillion};
            errorsOfArrivals(map, quartz, random); // must not matter beside the latches
            std::vector<double> errors, sigmas;
            for (int i = 0; i < 40; ++i) {
                const double readS = 2012 + i * 0.5, thereS = 20e-6 + wayS(random),
                             backS = 20e-6 + wayS(random);
                map.addLatch(quartz.at(readS), fromSeconds(readS - thereS), fromSeconds(readS + backS));
                if (i < 4)
                    continue;
                errors.push_back(toSeconds(map.fit()->hostTime(quartz.at(readS))) - readS);
                sigmas.push_back(map.fit()->sigmaS);
            }
            QCOMPARE(map.fit()->source, ClockFit::Source::Latch);
            QVERIFY2(rms(errors) < 60e-6, qPrintable(QString::number(rms(errors) * 1e6)));
            QVERIFY(rms(sigmas) > rms(errors) / 2 && rms(sigmas) < 4 * rms(errors));
            QVERIFY(std::abs(map.fit()->rate * 1e6 - partsPerMillion) < 10);
        }
    }

    /// Some quick readings at once, and later only slow ones, some of them held up wholly: the machine is
    /// busy.
    void slowReadingsCountByWhatTheyBound()
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> share(0, 1);
        ClockMap map;
        const Quartz quartz{5000, 60};
        const auto read = [&](double readS, double roundTripS) {
            const double thereS = share(random) * roundTripS;
            map.addLatch(quartz.at(readS), fromSeconds(readS - thereS),
                         fromSeconds(readS - thereS + roundTripS));
        };
        for (int i = 0; i < 4; ++i)
            read(2000 + i * frameS, 60e-6);
        for (int i = 1; i <= 20; ++i)
            read(2000 + 0.5 * i, i % 5 == 0 ? 0.3 : 400e-6);
        QCOMPARE(map.epoch(), 0); // held up, not set anew
        QCOMPARE(map.fit()->source, ClockFit::Source::Latch);
        // Of 16 readings known to 0.1 ms; the four quick ones alone would tell a rate 400 ppm off, 4 ms after
        // ten seconds.
        const double error = toSeconds(map.fit()->hostTime(quartz.at(2010))) - 2010;
        QVERIFY2(std::abs(error) < 150e-6, qPrintable(QString::number(error * 1e6)));
        QVERIFY(std::abs(error) < 4 * map.fit()->sigmaS);
    }

    void aClockThatIsSetAnewBeginsAnEpoch_data()
    {
        QTest::addColumn<double>("byS");
        QTest::newRow("back to nothing") << -900.0;
        QTest::newRow("a second ahead") << 1.0;
    }

    void aClockThatIsSetAnewBeginsAnEpoch()
    {
        QFETCH(double, byS);
        ClockMap map;
        const Quartz before{1000, 30}, after{1000 - byS, 30};
        for (int i = 0; i < 60; ++i)
            map.addArrival(before.at(2000 + i * frameS), fromSeconds(2000 + i * frameS));
        for (int i = 60; i < 63; ++i)
            map.addArrival(after.at(2000 + i * frameS), fromSeconds(2000 + i * frameS));
        QCOMPARE(map.epoch(), 1);
        const double errorS = toSeconds(map.fit()->hostTime(after.at(2002.1))) - 2002.1;
        QVERIFY(std::abs(errorS) < 1e-4);
    }

    void aPictureOfBeforeALatchIsNoStepBack()
    {
        ClockMap map;
        for (int i = 0; i < 30; ++i) {
            const Nanoseconds now = 10s + i * 100ms;
            map.addLatch(now, now - 50us, now + 50us);
            map.addArrival(now - 30ms, now);
        }
        QCOMPARE(map.epoch(), 0);
    }
};

ODOGRAPH_TEST(TestClockMap, QCoreApplication)
#include "tst_clock_map.moc"
