// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/percentile.h"

#include "tests/support/registered_test.h"

#include <QTest>

using odo::percentile;

class TestPercentile : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void isTheNearestByRank()
    {
        const std::vector<double> values{5, 1, 4, 2, 3};
        QCOMPARE(percentile(values, 0), 1.0);
        QCOMPARE(percentile(values, 50), 3.0);
        QCOMPARE(percentile(values, 95), 5.0); // rank 3.8 of 0 to 4
        QCOMPARE(percentile(values, 100), 5.0);
    }

    void ofOneIsThatOneAndOfNoneZero()
    {
        QCOMPARE(percentile({7}, 99), 7.0);
        QCOMPARE(percentile({}, 50), 0.0);
    }
};

ODOGRAPH_TEST(TestPercentile, QCoreApplication)
#include "tst_percentile.moc"
