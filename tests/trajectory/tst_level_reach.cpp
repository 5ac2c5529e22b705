// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/trajectory/synthetic_trial.h"

#include "core/trajectory/internal/level_fit.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <algorithm>
#include <numbers>

using namespace odo;
using namespace odo::test;

namespace {

using Reach = std::array<double, supportDirections>;

const auto nothingMore = [](std::size_t, const Eigen::Vector3d &) { return 0.0; };

/// Of round levels about the place, from below.
SolidShape roundShape(std::array<double, 3> radiiM, std::array<double, 3> heightsM)
{
    SolidShape shape;
    shape.form = SolidShape::Form::Levels;
    shape.roundShare = 1;
    for (std::size_t i = 0; i < 3; ++i)
        shape.levels[i] = {heightsM[i], radiiM[i], radiiM[i], radiiM[i], radiiM[i]};
    return shape;
}

/// By projecting five thousand points of each rim.
Reach reachOfRims(const FloorView &view, const SolidShape &shape, const Eigen::Vector2d &position)
{
    Reach reach;
    reach.fill(-HUGE_VAL);
    for (const SolidLevel &level : shape.levels) {
        for (int i = 0; i < 5000; ++i) {
            const double angle = 2 * std::numbers::pi * i / 5000;
            const auto pixel =
                view.pixelFromWorld({position.x() + level.frontM * std::cos(angle),
                                     position.y() + level.frontM * std::sin(angle), level.heightM});
            for (std::size_t k = 0; k < supportDirections; ++k)
                reach[k] = std::max(reach[k], supportDirection(k).dot(*pixel));
        }
    }
    return reach;
}

double worstDifference(const Reach &a, const Reach &b)
{
    double worst = 0;
    for (std::size_t k = 0; k < supportDirections; ++k)
        worst = std::max(worst, std::abs(a[k] - b[k]));
    return worst;
}

} // namespace

class TestLevelReach : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aRoundLevelReachesAsFarAsItsRim_data()
    {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("distance");
        QTest::newRow("large and near") << 0.15 << 2.5;
        QTest::newRow("large and far") << 0.15 << 4.0;
        QTest::newRow("small: about its middle") << 0.019 << 2.5;
        QTest::newRow("a little more") << 0.021 << 2.5;
    }
    void aRoundLevelReachesAsFarAsItsRim()
    {
        QFETCH(double, radius);
        QFETCH(double, distance);
        const FloorView view = cameraLookingAt({0, -0.8 * distance, 0.6 * distance}, {0, 0, 0});
        const SolidShape shape = roundShape({radius, radius, radius}, {0.02, 0.05, 0.08});
        for (const Eigen::Vector2d &position : {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.7, 0.2)}) {
            const double pose[] = {position.x(), position.y(), 0.4};
            Reach reach;
            QVERIFY(reachOfLevels(view, levelsOfShape<double>(shape), shape.roundShare, pose, reach,
                                  nothingMore));
            // A tenth of what a silhouette's edge is known to; 5000 points leave 1e-4 px. An ellipse about
            // the middle's picture is a pixel off.
            const double worst = worstDifference(reach, reachOfRims(view, shape, position));
            QVERIFY2(worst < 0.03, qPrintable(QString::number(worst)));
        }
    }

    /// The farthest of the levels tells in each direction.
    void levelsOfManySizesReachAsTheirRims()
    {
        const SolidShape shape = roundShape({0.10, 0.15, 0.05}, {0.01, 0.06, 0.2});
        const double pose[] = {0.3, -0.2, 0};
        Reach reach;
        QVERIFY(reachOfLevels(cameraA(), levelsOfShape<double>(shape), shape.roundShare, pose, reach,
                              nothingMore));
        const double worst = worstDifference(reach, reachOfRims(cameraA(), shape, {0.3, -0.2}));
        QVERIFY2(worst < 0.03, qPrintable(QString::number(worst)));
    }

    /// Pixels by metres and radians, against differences of the rims themselves.
    void itsDerivativesAreThoseOfThePose()
    {
        using Jet = ceres::Jet<double, 3>;
        SolidShape shape = roundShape({0.15, 0.15, 0.1}, {0.02, 0.05, 0.08});
        for (SolidLevel &level : shape.levels)
            level.leftM = level.rightM = 0.09;
        shape.roundShare = 0.6;
        const FloorView view = cameraA();
        const Jet pose[] = {Jet(0.3, 0), Jet(-0.2, 1), Jet(0.5, 2)};
        std::array<Jet, supportDirections> reach;
        QVERIFY(
            reachOfLevels(view, levelsOfShape<Jet>(shape), Jet(shape.roundShare), pose, reach, nothingMore));
        constexpr double step = 1e-5;
        for (int by = 0; by < 3; ++by) {
            double less[] = {0.3, -0.2, 0.5}, more[] = {0.3, -0.2, 0.5};
            less[by] -= step;
            more[by] += step;
            Reach before, behind;
            QVERIFY(reachOfLevels(view, levelsOfShape<double>(shape), shape.roundShare, less, before,
                                  nothingMore));
            QVERIFY(reachOfLevels(view, levelsOfShape<double>(shape), shape.roundShare, more, behind,
                                  nothingMore));
            for (std::size_t k = 0; k < supportDirections; ++k) {
                const double slope = (behind[k] - before[k]) / (2 * step);
                // Hundreds of pixels a metre; the point that touches wanders a little with the pose.
                QVERIFY2(
                    std::abs(reach[k].v[by] - slope) < 1.0,
                    qPrintable(
                        QStringLiteral("%1 %2: %3 not %4").arg(by).arg(k).arg(reach[k].v[by]).arg(slope)));
            }
        }
    }

    /// A body that reaches a centimetre farther in every direction is a centimetre larger in the picture.
    void whatReachesFartherIsAdded()
    {
        const SolidShape shape = roundShape({0.1, 0.1, 0.1}, {0.02, 0.05, 0.08});
        const double pose[] = {0.3, -0.2, 0};
        Reach plain, wider;
        QVERIFY(reachOfLevels(cameraA(), levelsOfShape<double>(shape), shape.roundShare, pose, plain,
                              nothingMore));
        const auto farther = [](std::size_t, const Eigen::Vector3d &slope) { return 0.01 * slope.norm(); };
        QVERIFY(
            reachOfLevels(cameraA(), levelsOfShape<double>(shape), shape.roundShare, pose, wider, farther));
        const double pxPerM = 950 / (cameraA().cameraInWorld() - Eigen::Vector3d(0.3, -0.2, 0.05)).norm();
        for (std::size_t k = 0; k < supportDirections; ++k)
            // a touching point is up to 5 % nearer than the middle
            QVERIFY(std::abs((wider[k] - plain[k]) / (0.01 * pxPerM) - 1) < 0.1);
    }

    void behindTheCameraThereIsNone()
    {
        const SolidShape shape = roundShape({0.1, 0.1, 0.1}, {0.02, 0.05, 0.08});
        const double pose[] = {-4, -5, 0};
        Reach reach;
        QVERIFY(!reachOfLevels(cameraA(), levelsOfShape<double>(shape), shape.roundShare, pose, reach,
                               nothingMore));
    }

    void whatIsFarOffCountsLessAndLess()
    {
        QCOMPARE(limitedDifference(0.001), 0.001);
        QVERIFY(std::abs(limitedDifference(0.1) - 0.1) < 1e-4);
        QVERIFY(std::abs(limitedDifference(30.0) + limitedDifference(-30.0)) < 1e-12 &&
                limitedDifference(30.0) < 7);
        // The picture is right where what was seen is as far as the solid, but for how much all is drawn too
        // wide.
        Reach reach;
        std::vector<float> seen(supportDirections, 20.0F);
        for (std::size_t k = 0; k < supportDirections; ++k)
            reach[k] = 20 + supportDirection(k).dot(Eigen::Vector2d(300, 200)) - 0.25;
        Reach off;
        reachDifferences(seen, {300, 200}, 0.25, reach, off.data());
        QVERIFY(std::ranges::all_of(off, [](double one) { return std::abs(one) < 1e-5; }));
        reachDifferences(seen, {300, 200}, 0.2, reach, off.data()); // 0.05 px are a tenth of σ
        QVERIFY(std::ranges::all_of(off, [](double one) { return std::abs(one - 0.1) < 1e-3; }));
    }
};

ODOGRAPH_TEST(TestLevelReach, QCoreApplication)
#include "tst_level_reach.moc"
