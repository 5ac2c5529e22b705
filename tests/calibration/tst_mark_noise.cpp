// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_registration.h"

#include "tests/support/registered_test.h"

#include <QTest>

#include <cmath>

using namespace odo;

class TestMarkNoise : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void withoutResidualsTheBeliefHolds() { QCOMPARE(markSigmaPx(0, 0), 0.3); }

    void freedomThatRoundingMadeNegativeCountsAsNone() { QCOMPARE(markSigmaPx(0, -1e-12), 0.3); }

    void residualsCountByTheirNumber()
    {
        // (4 · 0.3² + 2 · 0.6²) / (4 + 2) = 0.18
        QCOMPARE(markSigmaPx(2 * 0.6 * 0.6, 2), std::sqrt(0.18));
        QVERIFY(std::abs(markSigmaPx(1e6 * 0.6 * 0.6, 1e6) - 0.6) < 1e-5);
    }

    void perfectResidualsDoNotMakeThePixelsPerfect()
    {
        // 4 · 0.3² / (4 + 2)
        QCOMPARE(markSigmaPx(0, 2), std::sqrt(0.06));
    }

    void residualsThatRefuteTheBeliefSpeakAlone()
    {
        QVERIFY(markSigmaPx(0.89 * 0.89, 1) < 0.89);
        QCOMPARE(markSigmaPx(0.91 * 0.91, 1), 0.91);
        // less than one residual refutes nothing, however large it is by its freedom
        QVERIFY(markSigmaPx(0.1, 1e-6) < 0.35);
    }
};

ODOGRAPH_TEST(TestMarkNoise, QCoreApplication)
#include "tst_mark_noise.moc"
