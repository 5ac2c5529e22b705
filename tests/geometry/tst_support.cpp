// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/support.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace odo;

class TestSupport : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aRectangleHasItsClosedForm()
    {
        const std::vector<Eigen::Vector2d> corners{{2, 3}, {8, 3}, {8, 5}, {2, 5}, {5, 4}};
        const std::vector<float> support = supportOf(corners, {5, 4});
        QCOMPARE(support.size(), supportDirections);
        for (std::size_t k = 0; k < supportDirections; ++k) {
            const double angle = 2 * std::numbers::pi * double(k) / 24;
            QVERIFY(std::abs(support[k] - (3 * std::abs(std::cos(angle)) + std::abs(std::sin(angle)))) < 1e-5);
        }
    }

    void aPointReachesToItself()
    {
        const std::vector<float> support = supportOf({{1, 0}}, {0, 0});
        QCOMPARE(support[0], 1.0F);
        QCOMPARE(support[12], -1.0F);
        QVERIFY(std::abs(support[6]) < 1e-6F);
    }
};

QTEST_GUILESS_MAIN(TestSupport)
#include "tst_support.moc"
