// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/silhouette.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace odo;

namespace {

bool areNear(const std::vector<Eigen::Vector2d> &corners, const std::vector<Eigen::Vector2d> &expected,
             double toPx)
{
    return corners.size() == expected.size() &&
           std::ranges::all_of(expected, [&](const Eigen::Vector2d &each) {
               return std::ranges::any_of(
                   corners, [&](const Eigen::Vector2d &corner) { return (corner - each).norm() < toPx; });
           });
}

double areaOf(const std::vector<Eigen::Vector2d> &corners)
{
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % corners.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2;
}

} // namespace

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
            QVERIFY(std::abs(support[k] - (3 * std::abs(std::cos(angle)) + std::abs(std::sin(angle)))) <
                    1e-5);
        }
    }

    void aPlaceLiesWithinTheLinesOrBeyondOne()
    {
        const std::vector<float> support = supportOf({{0, 0}, {8, 0}, {8, 4}, {0, 4}}, {3, 1});
        QVERIFY(isWithinSupport(support, {3, 1}, {0.1, 3.9}));
        QVERIFY(!isWithinSupport(support, {3, 1}, {8.5, 2}));
        QVERIFY(isWithinSupport(support, {3, 1}, {8.5, 2}, 0.6));
        QVERIFY(!isWithinSupport(support, {3, 1}, {8.5, 2}, 0.4));
    }

    void aPointReachesToItself()
    {
        const std::vector<float> support = supportOf({{1, 0}}, {0, 0});
        QCOMPARE(support[0], 1.0F);
        QCOMPARE(support[12], -1.0F);
        QVERIFY(std::abs(support[6]) < 1e-6F);
    }

    void aPolygonWithSidesOfTheDirectionsComesBack_data()
    {
        using Points = std::vector<Eigen::Vector2d>;
        QTest::addColumn<Points>("corners");
        QTest::addColumn<Eigen::Vector2d>("about");
        QTest::newRow("rectangle") << Points{{8, 3}, {8, 5}, {2, 5}, {2, 3}} << Eigen::Vector2d(5, 4);
        QTest::newRow("rectangle, from outside of it")
            << Points{{8, 3}, {8, 5}, {2, 5}, {2, 3}} << Eigen::Vector2d(30, -7);
        QTest::newRow("diamond") << Points{{10, 0}, {0, 10}, {-10, 0}, {0, -10}} << Eigen::Vector2d(0, 1);
        QTest::newRow("triangle") << Points{{0, 0}, {12, 0}, {0, 12}} << Eigen::Vector2d(3, 3);
    }
    void aPolygonWithSidesOfTheDirectionsComesBack()
    {
        QFETCH(std::vector<Eigen::Vector2d>, corners);
        QFETCH(Eigen::Vector2d, about);
        const auto polygon = supportPolygon(supportOf(corners, about), about);
        QVERIFY(areNear(polygon, corners, 0.01));
        QVERIFY(areaOf(polygon) > 0);
    }

    void anyOtherOneIsContainedAndTouched()
    {
        const std::vector<Eigen::Vector2d> corners{{3, 1}, {17, 6}, {11, 19}, {-2, 12}};
        const Eigen::Vector2d about(7, 9);
        const std::vector<float> support = supportOf(corners, about);
        const auto polygon = supportPolygon(support, about);
        QVERIFY(polygon.size() <= supportDirections);
        QVERIFY(areaOf(polygon) > areaOf(corners) && areaOf(polygon) < 1.15 * areaOf(corners));
        const std::vector<float> again = supportOf(polygon, about); // no line lies off the polygon
        for (std::size_t k = 0; k < supportDirections; ++k)
            QVERIFY(std::abs(again[k] - support[k]) < 1e-3F);
    }

    void aLineThatReachesTooFarIsNoCorner()
    {
        std::vector<float> support = supportOf({{8, 3}, {8, 5}, {2, 5}, {2, 3}}, {5, 4});
        support[3] += 5; // beyond the corner that the others leave: cuts nothing off
        QVERIFY(areNear(supportPolygon(support, {5, 4}), {{8, 3}, {8, 5}, {2, 5}, {2, 3}}, 0.01));
    }

    void whatBoundsNothingIsEmpty_data()
    {
        QTest::addColumn<std::vector<float>>("support");
        std::vector<float> broken(supportDirections, 10);
        broken[7] = std::numeric_limits<float>::quiet_NaN();
        std::vector<float> apart(supportDirections, 10);
        apart[3] = -20;
        std::vector<float> crossed(supportDirections, 10);
        crossed[0] = -20;
        QTest::newRow("none") << std::vector<float>();
        QTest::newRow("too few") << std::vector<float>(supportDirections - 1, 10);
        QTest::newRow("all zero, as stored where none was measured")
            << std::vector<float>(supportDirections, 0);
        QTest::newRow("a point") << supportOf({{1, 0}}, {0, 0});
        QTest::newRow("a line") << supportOf({{1, 2}, {9, 2}}, {0, 0});
        QTest::newRow("a hair") << supportOf({{0, 0}, {90, 0}, {90, 0.003}, {0, 0.003}}, {0, 0});
        QTest::newRow("no number") << broken;
        QTest::newRow("lines that leave nothing") << apart;
        QTest::newRow("axes that leave nothing") << crossed;
    }
    void whatBoundsNothingIsEmpty()
    {
        QFETCH(std::vector<float>, support);
        QVERIFY(supportPolygon(support, {100, 100}).empty());
    }
};

ODOGRAPH_TEST(TestSupport, QCoreApplication)
#include "tst_support.moc"
