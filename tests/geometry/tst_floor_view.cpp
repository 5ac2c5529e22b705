// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/floor_view.h"

#include "tests/support/registered_test.h"

#include <Eigen/Cholesky>
#include <QTest>
#include <random>

using namespace odo;
using Eigen::Vector2d;
using Eigen::Vector3d;
using PoseCovariance = Eigen::Matrix<double, 6, 6>;

namespace {

CameraModel bentCamera()
{
    Intrinsics intrinsics = CameraModel::assumed(1280, 720).intrinsics();
    intrinsics.fxPx = intrinsics.fyPx = 900;
    intrinsics.distortion = {-0.2, 0.08, 0.001, -0.0005};
    return CameraModel::create(intrinsics).value();
}

/// A camera at a place that looks at a point of the floor, its picture's horizon level.
RigidTransform lookAt(const Vector3d &place, const Vector3d &target)
{
    const Vector3d forward = (target - place).normalized();
    const Vector3d right = forward.cross(Vector3d::UnitZ()).normalized();
    Eigen::Matrix3d axes;
    axes << right, forward.cross(right), forward;
    return {Eigen::Quaterniond(axes), place};
}

FloorView view(const PoseCovariance &covariance = PoseCovariance::Zero())
{
    return {bentCamera(), lookAt({-1.2, -1.8, 1.5}, {0.4, 0.3, 0}), covariance};
}

} // namespace

class TestFloorView : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void floorAndPixelRoundTrip()
    {
        const FloorView floor = view();
        for (double x = -0.5; x <= 1.5; x += 0.25) {
            for (double y = -0.5; y <= 1.5; y += 0.25) {
                const auto pixel = floor.pixelFromWorld({x, y, 0.06});
                QVERIFY(pixel.has_value());
                const auto back = floor.floorFromPixel(*pixel, 0.06);
                QVERIFY(back.has_value());
                QVERIFY((*back - Vector2d(x, y)).norm() < 1e-11);
            }
        }
    }
    void aCameraStraightAboveIsAScale()
    {
        // Looking down from 2 m with f = 1000 a pixel is 2 mm; the picture's y runs against the world's.
        Intrinsics intrinsics = CameraModel::assumed(1001, 1001).intrinsics();
        intrinsics.fxPx = intrinsics.fyPx = 1000;
        const Eigen::Quaterniond down(Eigen::AngleAxisd(std::acos(-1.0), Vector3d::UnitX()));
        const FloorView floor(CameraModel::create(intrinsics).value(), {down, {0, 0, 2}},
                              PoseCovariance::Zero());
        const auto position = floor.locate({600, 450}, Eigen::Matrix2d::Identity() * 0.25, 0);
        QVERIFY(position.has_value());
        QVERIFY((position->pointInWorld - Vector2d(0.2, 0.1)).norm() < 1e-12);
        QVERIFY((position->pixelCovariance - Eigen::Matrix2d::Identity() * 1e-6).norm() < 1e-15);
        QVERIFY((position->displacementPerMetreHeight - Vector2d(-0.1, -0.05)).norm() < 1e-12);
        QVERIFY(position->calibrationCovariance.norm() == 0);
    }
    /// Straight above at 2 m, an angle across the axis is 2 m × angle at the centre, and a roll is the
    /// distance from the centre × angle, across it.
    void aTurnThatIsNotKnownIsAnErrorOnTheFloor()
    {
        Intrinsics intrinsics = CameraModel::assumed(1001, 1001).intrinsics();
        intrinsics.fxPx = intrinsics.fyPx = 1000;
        const Eigen::Quaterniond down(Eigen::AngleAxisd(std::acos(-1.0), Vector3d::UnitX()));
        const FloorView exact(CameraModel::create(intrinsics).value(), {down, {0, 0, 2}},
                              PoseCovariance::Zero()),
            across = exact.perhapsTurned(0, 0.003), rolled = exact.perhapsTurned(0.003, 0);
        const auto centre = across.locate({500, 500}, Eigen::Matrix2d::Zero(), 0);
        QVERIFY((centre->calibrationCovariance - Eigen::Matrix2d::Identity() * 36e-6).norm() < 1e-12);
        QVERIFY(rolled.locate({500, 500}, Eigen::Matrix2d::Zero(), 0)->calibrationCovariance.norm() < 1e-12);
        const auto beside = rolled.locate({900, 500}, Eigen::Matrix2d::Zero(), 0); // 0.8 m to the right
        QVERIFY(std::abs(beside->calibrationCovariance(1, 1) - 0.0024 * 0.0024) < 1e-12);
        QVERIFY(std::abs(beside->calibrationCovariance(0, 0)) < 1e-12);
    }
    void heightDisplacesAsStated()
    {
        const FloorView floor = view();
        const Vector2d pixel(700, 300);
        const auto position = floor.locate(pixel, Eigen::Matrix2d::Identity(), 0.05);
        const Vector2d numeric =
            (*floor.floorFromPixel(pixel, 0.051) - *floor.floorFromPixel(pixel, 0.049)) / 0.002;
        QVERIFY((position->displacementPerMetreHeight - numeric).norm() < 1e-6 * numeric.norm());
    }
    void covarianceAgreesWithMonteCarlo()
    {
        PoseCovariance covariance = PoseCovariance::Zero();
        covariance.diagonal() << 4e-6, 9e-6, 2e-6, 1e-5, 2e-5, 5e-6;
        covariance(0, 4) = covariance(4, 0) = 5e-6;
        const FloorView floor = view(covariance);
        const Vector2d pixel(820, 260);
        Eigen::Matrix2d pixelCovariance;
        pixelCovariance << 1.0, 0.3, 0.3, 0.5;
        const auto stated = floor.locate(pixel, pixelCovariance, 0.05);

        std::mt19937 random(3);
        std::normal_distribution<double> normal;
        const Eigen::Matrix2d pixelRoot = pixelCovariance.llt().matrixL();
        const PoseCovariance poseRoot = covariance.llt().matrixL();
        Eigen::Matrix2d fromPixel = Eigen::Matrix2d::Zero(), fromPose = Eigen::Matrix2d::Zero();
        const int draws = 40000;
        for (int i = 0; i < draws; ++i) {
            const Vector2d noise(normal(random), normal(random));
            const Vector2d moved =
                *floor.floorFromPixel(pixel + pixelRoot * noise, 0.05) - stated->pointInWorld;
            fromPixel += moved * moved.transpose() / draws;
            Eigen::Matrix<double, 6, 1> draw;
            for (double &value : draw)
                value = normal(random);
            draw = poseRoot * draw;
            const Vector3d turn = draw.head<3>();
            const RigidTransform pose{Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())) *
                                          floor.worldFromCamera().rotation,
                                      floor.worldFromCamera().translation + draw.tail<3>()};
            const FloorView shifted(floor.camera(), pose, covariance);
            const Vector2d off = *shifted.floorFromPixel(pixel, 0.05) - stated->pointInWorld;
            fromPose += off * off.transpose() / draws;
        }
        // 40000 draws leave 0.7 % on a variance; curvature adds less than that here.
        QVERIFY((fromPixel - stated->pixelCovariance).norm() < 0.03 * fromPixel.norm());
        QVERIFY((fromPose - stated->calibrationCovariance).norm() < 0.03 * fromPose.norm());
    }
    void nothingIsLocatedAtOrBeyondTheHorizon()
    {
        const Vector3d place(0, 0, 1);
        const FloorView floor(CameraModel::assumed(1280, 720), lookAt(place, {5, 0, 1}),
                              PoseCovariance::Zero());
        const Vector2d centre(639.5, 359.5); // the camera looks along the horizon
        const double f = floor.camera().intrinsics().fxPx;
        const auto below = [&](double degrees) {
            return floor.floorFromPixel(centre + Vector2d(0, f * std::tan(degrees * std::acos(-1.0) / 180)),
                                        0);
        };
        QVERIFY(!below(-5).has_value());
        QVERIFY(!below(0).has_value());
        QVERIFY(!below(0.99).has_value());
        QVERIFY(below(1.01).has_value());
        QVERIFY(std::abs(below(10)->x() - 1 / std::tan(10 * std::acos(-1.0) / 180)) < 1e-9);
        QVERIFY(!floor.locate(centre, Eigen::Matrix2d::Identity(), 0).has_value());
        QVERIFY(!floor.pixelFromWorld({-3, 0, 0}).has_value()); // behind it
    }
    void aPlaneAboveTheCameraIsMetByRaysThatClimb()
    {
        const FloorView floor(CameraModel::assumed(1280, 720), lookAt({0, 0, 1}, {5, 0, 1}),
                              PoseCovariance::Zero());
        const auto pixel = floor.pixelFromWorld({4, 0.5, 1.6});
        QVERIFY(pixel.has_value());
        QVERIFY(!floor.floorFromPixel(*pixel, 0).has_value());
        QVERIFY((*floor.floorFromPixel(*pixel, 1.6) - Vector2d(4, 0.5)).norm() < 1e-9);
    }
};

ODOGRAPH_TEST(TestFloorView, QCoreApplication)
#include "tst_floor_view.moc"
