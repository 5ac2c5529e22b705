// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/coverage.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;

class TestCoverage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Table G.2 of JCGM 100:2008, which gives two decimals.
    void studentsT_data()
    {
        QTest::addColumn<int>("degrees");
        QTest::addColumn<double>("t");
        const std::vector<std::pair<int, double>> table{{1, 12.71}, {2, 4.30},   {3, 3.18},  {4, 2.78},
                                                        {5, 2.57},  {8, 2.31},   {12, 2.18}, {20, 2.09},
                                                        {40, 2.02}, {100, 1.984}};
        for (const auto &[degrees, t] : table)
            QTest::addRow("%d", degrees) << degrees << t;
    }
    void studentsT()
    {
        QFETCH(const int, degrees);
        QFETCH(const double, t);
        QVERIFY(std::abs(studentT95(degrees) - t) < 0.0081); // half a digit of the table, and 0.003
    }
};

ODOGRAPH_TEST(TestCoverage, QCoreApplication)
#include "tst_coverage.moc"
