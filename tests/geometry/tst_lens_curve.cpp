// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/internal/lens_curve.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace odo;

namespace {

/// Where the slope is no longer positive, step by step; `end` where it always is.
double scannedLimit(const LensCurve &curve, double end)
{
    for (double argument = 1e-3; argument < end; argument *= 1.0005)
        if (curve.slope(argument) <= 0)
            return argument;
    return end;
}

} // namespace

/// As far as a lens curve grows, against a scan and closed forms.
class TestLensCurve : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// x (1 + k x²) grows up to x = 1 / sqrt(-3 k).
    void oneCoefficientHasAClosedForm()
    {
        for (const double k : {-0.01, -0.3, -5.0, -1e4}) {
            const double expected = 1 / std::sqrt(-3 * k);
            QVERIFY(std::abs(LensCurve({k}, false).limit() / expected - 1) < 1e-12);
            if (expected < std::numbers::pi)
                QVERIFY(std::abs(LensCurve({k}, true).limit() / expected - 1) < 1e-12);
        }
        QCOMPARE(LensCurve({0.2}, false).limit(), 100.0);
        QCOMPARE(LensCurve({0.2}, true).limit(), std::numbers::pi);
        QCOMPARE(LensCurve({}, false).limit(), std::numeric_limits<double>::infinity());
    }

    /// 1 / (1 + k u) has its pole at u = -1 / k, and grows up to there.
    void aPoleIsTheEnd()
    {
        const double limit = LensCurve({0, 0, 0, 0, 0, -0.25}, false).limit();
        QVERIFY(std::abs(limit / 2 - 1) < 1e-12);
    }

    void anyCoefficients_data()
    {
        QTest::addColumn<bool>("isFisheye");
        QTest::newRow("rational") << false;
        QTest::newRow("fisheye") << true;
    }
    void anyCoefficients()
    {
        QFETCH(bool, isFisheye);
        std::mt19937 random(7);
        std::normal_distribution<double> normal;
        const double end = isFisheye ? std::numbers::pi : 100;
        int limited = 0;
        for (int draw = 0; draw < 400; ++draw) {
            std::array<double, 8> k{};
            const double size = std::pow(10.0, -2 + 3.0 * draw / 400);
            for (double &coefficient : k)
                coefficient = size * normal(random);
            const LensCurve curve(k, isFisheye);
            const double limit = curve.limit(), scanned = scannedLimit(curve, end);
            limited += limit < end;
            // The scan may step over a dip that is narrower than its steps.
            QVERIFY2(limit <= scanned && (limit > scanned / 1.0006 || curve.slope(limit * (1 + 1e-9)) < 1e-6),
                     qPrintable(QStringLiteral("%1 for %2").arg(limit).arg(scanned)));
            for (int i = 1; i <= 50; ++i)
                QVERIFY(curve.slope(limit * i / 50 * (1 - 1e-9)) > 0);
        }
        QVERIFY(limited > 100);
    }
};

ODOGRAPH_TEST(TestLensCurve, QCoreApplication)
#include "tst_lens_curve.moc"
