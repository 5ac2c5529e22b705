// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/spike_search.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <random>

using namespace odo;

class TestHampel : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void medianAndDeviationInClosedForm()
    {
        QCOMPARE(median({}), 0.0);
        QCOMPARE(median({3}), 3.0);
        QCOMPARE(median({5, 1, 3}), 3.0);
        QCOMPARE(median({4, 1, 3, 2}), 2.5);
        // Deviations from 3: 2, 1, 0, 1, 97 → 1.
        QCOMPARE(medianDeviation({1, 2, 3, 4, 100}), 1.4826);
        QCOMPARE(medianDeviation({7, 7, 7, 7, 9}), 0.0);
    }
    void itIsTheStandardDeviationOfNormalNoise()
    {
        std::mt19937 random(2);
        std::normal_distribution<double> noise(5, 0.3);
        std::vector<double> values(20001);
        for (double &value : values)
            value = noise(random);
        QVERIFY(std::abs(medianDeviation(values) / 0.3 - 1) < 0.03); // 1.2 % of scatter
    }
    void onlyTheOutlierIsTold()
    {
        // Window of 7 around the sixth: 5, 6, 7, 90, 9, 10, 11; median 9, deviation 2·1.4826.
        std::vector<double> ramp;
        for (int i = 0; i < 12; ++i)
            ramp.push_back(i + 2);
        ramp[6] = 90;
        const auto found = hampelOutliers(ramp, {});
        for (std::size_t i = 0; i < ramp.size(); ++i)
            QVERIFY2(found[i] == (i == 6), qPrintable(QString::number(i)));
        // Three standard deviations of 2·1.4826 from 9: 17.9 is inside, 18 outside.
        ramp[6] = 17.8;
        QVERIFY(!hampelOutliers(ramp, {})[6]);
        ramp[6] = 18;
        QVERIFY(hampelOutliers(ramp, {})[6]);
    }
    void equalNeighboursNeedALeastDeviation()
    {
        std::vector<double> values(9, 1.0);
        values[4] = 1.001;
        QVERIFY(hampelOutliers(values, {3, 3, 0})[4]);
        QVERIFY(!hampelOutliers(values, {3, 3, 0.001})[4]);
        QVERIFY(hampelOutliers({}, {}).empty());
        const std::vector<double> one{4};
        QVERIFY(!hampelOutliers(one, {})[0]);
    }
    void aTracksSpikesByPositionAndSpeed()
    {
        // Evenly at 20 mm a frame: the position of the moving robot hides 60 mm, its speed does not.
        std::vector<TrackNode> track;
        for (int i = 0; i < 30; ++i)
            track.push_back({i / 30.0, i != 20, {0.02 * i, 0}, Eigen::Matrix2d::Identity() * 1e-6});
        track[12].position.x() += 0.06;
        track[25].position.y() += 0.3;
        const auto found = hampelSpikes(track);
        for (std::size_t i = 0; i < track.size(); ++i)
            QVERIFY2(found[i].any() == (i == 12 || i == 25), qPrintable(QString::number(i)));
        QVERIFY(!found[12].byPosition && found[12].bySpeed);
        QVERIFY(found[25].byPosition && found[25].bySpeed);
    }
};

ODOGRAPH_TEST(TestHampel, QCoreApplication)
#include "tst_hampel.moc"
