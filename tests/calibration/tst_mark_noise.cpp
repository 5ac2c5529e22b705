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
        // χ² beyond 22.46 of six (table of the distribution, 0.1 %), and Student's 2.447 for 1.960
        QVERIFY(markSigmaPx(0.99 * 22.46 * 0.09, 6) < 0.49);
        QVERIFY(std::abs(markSigmaPx(6 * 0.6 * 0.6, 6) - 0.6 * 2.447 / 1.960) < 0.001);
        QVERIFY(std::abs(markSigmaPx(40 * 0.6 * 0.6, 40) - 0.6 * 2.021 / 1.960) < 0.001);
        // of a single residual Student's factor would be 6.5: that of two is taken
        QVERIFY(markSigmaPx(0.99 * 0.99, 1) < 0.52);
        QVERIFY(std::abs(markSigmaPx(1.01 * 1.01, 1) - 1.01 * 4.303 / 1.960) < 0.001);
        // less than one residual refutes nothing, however large it is by its freedom
        QVERIFY(markSigmaPx(0.1, 1e-6) < 0.35);
    }
};

ODOGRAPH_TEST(TestMarkNoise, QCoreApplication)
#include "tst_mark_noise.moc"
