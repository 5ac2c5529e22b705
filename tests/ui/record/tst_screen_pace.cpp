// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/running_cameras.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <random>

using namespace odo;
using namespace std::chrono_literals;

class TestScreenPace : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void stepsStayEven_data();
    void stepsStayEven();
};

void TestScreenPace::stepsStayEven_data()
{
    QTest::addColumn<double>("rate");
    QTest::addColumn<int>("shownOf100");
    QTest::newRow("a slow camera") << 15.0 << 100;
    QTest::newRow("television") << 25.0 << 100;
    QTest::newRow("a webcam") << 30.0 << 100;
    QTest::newRow("50") << 50.0 << 50;
    QTest::newRow("60") << 60.0 << 50;
    QTest::newRow("100") << 100.0 << 34;
}

/// With 2 ms of jitter in when the pictures are thought to be taken.
void TestScreenPace::stepsStayEven()
{
    QFETCH(double, rate);
    QFETCH(int, shownOf100);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> jitterS(-0.001, 0.001);
    ScreenPace pace;
    int shown = 0;
    for (int i = 0; i < 100; ++i)
        shown += pace.takes(1000s + fromSeconds(i / rate + jitterS(random)));
    QCOMPARE(shown, shownOf100);
}

ODOGRAPH_TEST(TestScreenPace, QCoreApplication)
#include "tst_screen_pace.moc"
