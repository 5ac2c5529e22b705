// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/silhouette_tracker.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>

using namespace odo;

namespace {

FloorView cameraAt(const Eigen::Vector3d &position)
{
    Intrinsics lens;
    lens.widthPx = 1280;
    lens.heightPx = 720;
    lens.fxPx = lens.fyPx = 900;
    lens.cxPx = 639.5;
    lens.cyPx = 359.5;
    Eigen::Matrix3d axes;
    axes.col(2) = -position.normalized();
    axes.col(0) = axes.col(2).cross(Eigen::Vector3d::UnitZ()).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return FloorView(*CameraModel::create(lens), {Eigen::Quaterniond(axes), position},
                     Eigen::Matrix<double, 6, 6>::Zero());
}

/// The box in the picture of an upright box that stands about the world's middle.
PixelRect imageOf(const FloorView &view, const Eigen::Vector3d &sizeM)
{
    Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
            for (const double z : {0.0, 1.0}) {
                const Eigen::Vector2d pixel =
                    *view.pixelFromWorld({x * sizeM.x(), y * sizeM.y(), z * sizeM.z()});
                low = low.cwiseMin(pixel);
                high = high.cwiseMax(pixel);
            }
    return {int(std::lround(low.x())), int(std::lround(low.y())), int(std::lround(high.x())) + 1,
            int(std::lround(high.y())) + 1};
}

} // namespace

class TestSizeOnFloor : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void peopleAreTooLargeAndRobotsAreNot_data()
    {
        QTest::addColumn<double>("cameraHeightM");
        for (const double heightM : {0.9, 1.5, 2.0, 2.5})
            QTest::addRow("camera %.1f m high", heightM) << heightM;
    }
    void peopleAreTooLargeAndRobotsAreNot()
    {
        QFETCH(double, cameraHeightM);
        const FloorView view = cameraAt({-2.2, -1.6, cameraHeightM});
        for (const Eigen::Vector3d &robot : {Eigen::Vector3d(0.2, 0.15, 0.1), Eigen::Vector3d(0.3, 0.3, 0.4),
                                             Eigen::Vector3d(0.6, 0.5, 0.3)})
            QVERIFY(!isTooLargeForRobot(view, imageOf(view, robot)));
        for (const Eigen::Vector3d &person :
             {Eigen::Vector3d(0.3, 0.5, 1.7), Eigen::Vector3d(0.25, 0.4, 1.45)})
            QVERIFY(cameraHeightM < 1.2 || isTooLargeForRobot(view, imageOf(view, person)));
        QVERIFY(isTooLargeForRobot(view, imageOf(view, {2.5, 0.3, 0.1})));
    }

    void aPlateOnTheFloorHasItsSize()
    {
        const FloorView view = cameraAt({-2.2, -1.6, 2});
        const auto size = sizeOnFloor(view, imageOf(view, {0.4, 0.4, 0}));
        QVERIFY(size && size->widthM > 0.35 && size->widthM < 0.6); // it is seen across a corner
        QVERIFY(size->reachM < 0.45);
    }

    void beyondTheHorizonNothingIsKnown()
    {
        const FloorView view = cameraAt({-3, 0, 0.3});
        QVERIFY(!sizeOnFloor(view, {600, 0, 640, 20}));
        QVERIFY(!isTooLargeForRobot(view, {600, 0, 640, 20}));
    }
};

ODOGRAPH_TEST(TestSizeOnFloor, QCoreApplication)
#include "tst_size_on_floor.moc"
