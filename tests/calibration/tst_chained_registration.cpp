// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/chained_registration.h"

#include "tests/support/registered_test.h"

#include <Eigen/LU>
#include <QTest>
#include <random>

using namespace odo;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

namespace {

CameraModel lens()
{
    Intrinsics intrinsics = CameraModel::assumed(1280, 720).intrinsics();
    intrinsics.fxPx = intrinsics.fyPx = 800;
    intrinsics.distortion = {-0.2, 0.06, 0.0008, -0.0006};
    return CameraModel::create(intrinsics).value();
}

FloorView viewFrom(const Vector3d &position, const Vector3d &target,
                   const Matrix6d &covariance = Matrix6d::Zero())
{
    const Vector3d forward = (target - position).normalized();
    const Vector3d right = forward.cross(Vector3d::UnitZ()).normalized();
    Eigen::Matrix3d axes;
    axes << right, forward.cross(right), forward;
    return FloorView(lens(), {Eigen::Quaterniond(axes), position}, covariance);
}

/// 2 mrad and 4 mm, as a registration by four markers leaves.
Matrix6d poseNoise()
{
    Vector6d sigma;
    sigma << 0.002, 0.002, 0.001, 0.004, 0.004, 0.003;
    return sigma.cwiseAbs2().asDiagonal();
}

const FloorView referenceView = viewFrom({0.4, -1.2, 2}, {1.4, 1.0, 0}, poseNoise());
const FloorView ownView = viewFrom({3.8, 0.2, 2}, {1.5, 1.2, 0});

std::vector<SharedPoint> sharedPoints(const FloorView &through = referenceView,
                                      const FloorView &own = ownView)
{
    std::vector<SharedPoint> points;
    const Vector2d positions[] = {{0.9, 0.5}, {2.0, 0.6}, {0.8, 1.7}, {2.1, 1.6}, {1.4, 1.1}, {1.7, 0.4}};
    for (const Vector2d &at : positions)
        points.push_back({std::string(1, char('a' + points.size())), *own.pixelFromWorld({at.x(), at.y(), 0}),
                          *through.pixelFromWorld({at.x(), at.y(), 0})});
    return points;
}

FloorView shaken(const FloorView &view, std::mt19937 &random)
{
    std::normal_distribution<double> normal;
    Vector6d step;
    for (int i = 0; i < 6; ++i)
        step(i) = std::sqrt(view.poseCovariance()(i, i)) * normal(random);
    RigidTransform pose = view.worldFromCamera();
    const Vector3d turn = step.head<3>();
    pose.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * pose.rotation;
    pose.translation += step.tail<3>();
    return FloorView(view.camera(), pose, view.poseCovariance());
}

bool refusedWith(const std::vector<SharedPoint> &points, const char *words)
{
    const auto chained = registerViaCamera(referenceView, foreignWords("B"), points, lens(), true);
    if (chained)
        return false;
    const std::string told = chained.error().message();
    if (told.find(words) == std::string::npos)
        qWarning("told instead: %s", told.c_str());
    return told.find(words) != std::string::npos && told.find("; ") != std::string::npos;
}

} // namespace

class TestChainedRegistration : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void exactPointsGiveThePlaceExactly()
    {
        const auto chained =
            registerViaCamera(referenceView, foreignWords("B"), sharedPoints(), lens(), true);
        QVERIFY2(chained.has_value(), chained ? "" : chained.error().message().c_str());
        const RigidTransform &pose = chained->registration.worldFromCamera;
        QVERIFY((pose.translation - ownView.cameraInWorld()).norm() < 1e-7);
        QVERIFY(pose.rotation.angularDistance(ownView.worldFromCamera().rotation) < 1e-7);
        QCOMPARE(chained->positions.markers.size(), std::size_t(6));
        QVERIFY(chained->registration.verdict.english().find("via B, 6 floor points") != std::string::npos);
    }
    /// A shift of B's whole world is C's shift, point for point: the closed form of the common part.
    void aShiftOfTheOtherCameraIsCarriedWhole()
    {
        Matrix6d shift = Matrix6d::Zero();
        shift(3, 3) = 0.01 * 0.01;
        const auto still = registerViaCamera(viewFrom({0.4, -1.2, 2}, {1.4, 1.0, 0}), foreignWords("B"),
                                             sharedPoints(), lens(), true);
        const auto moving = registerViaCamera(viewFrom({0.4, -1.2, 2}, {1.4, 1.0, 0}, shift),
                                              foreignWords("B"), sharedPoints(), lens(), true);
        QVERIFY(still.has_value() && moving.has_value());
        const Matrix6d common = moving->registration.poseCovariance - still->registration.poseCovariance;
        QVERIFY((common - shift).norm() < 1e-6 * shift.norm());
    }
    /// Over two links, everything drawn: pixels of both pictures at 0.3 px and the first camera's pose.
    void theCovarianceIsThatOfManyTrials()
    {
        std::mt19937 random(7);
        std::normal_distribution<double> pixelNoise(0, 0.3);
        const FloorView last = viewFrom({2.2, 3.6, 2.1}, {1.5, 1.0, 0});
        const Vector2d robot(1.2, 1.3);
        const Vector2d robotPixel = *last.pixelFromWorld({robot.x(), robot.y(), 0});
        const auto noisy = [&](std::vector<SharedPoint> points) {
            for (SharedPoint &point : points) {
                point.pixel += Vector2d(pixelNoise(random), pixelNoise(random));
                point.referencePixel += Vector2d(pixelNoise(random), pixelNoise(random));
            }
            return points;
        };
        constexpr int trials = 400;
        double normalised = 0, worst = 0;
        for (int i = 0; i < trials; ++i) {
            const auto first = registerViaCamera(shaken(referenceView, random), foreignWords("B"),
                                                 noisy(sharedPoints()), lens(), true);
            QVERIFY(first.has_value());
            const FloorView middle(lens(), first->registration.worldFromCamera,
                                   first->registration.poseCovariance);
            const auto second = registerViaCamera(middle, foreignWords("C"),
                                                  noisy(sharedPoints(ownView, last)), lens(), true);
            QVERIFY(second.has_value());
            const FloorView view(lens(), second->registration.worldFromCamera,
                                 second->registration.poseCovariance);
            const auto position = view.locate(robotPixel, Eigen::Matrix2d::Zero(), 0);
            QVERIFY(position.has_value());
            const Vector2d error = position->pointInWorld - robot;
            normalised += error.dot(position->calibrationCovariance.inverse() * error) / trials;
            worst = std::max(worst, error.norm());
        }
        // Mean of a chi-square of two degrees: 2, ±0.1 at 400 trials; the residuals of six points widen the
        // stated covariance in some trials, never narrow it.
        QVERIFY2(normalised > 1.4 && normalised < 2.3, qPrintable(QString::number(normalised)));
        QVERIFY2(worst < 0.05, qPrintable(QString::number(worst)));
    }
    void refusalsSayWhatToDo()
    {
        std::vector<SharedPoint> points = sharedPoints();
        points.resize(3);
        QVERIFY(refusedWith(points, "both cameras must see the same four points or more; 3 given"));
        points = sharedPoints();
        points[1].label = 'a';
        QVERIFY(refusedWith(points, "point a appears twice"));
        points = sharedPoints();
        points[1].pixel = points[0].pixel;
        QVERIFY(refusedWith(points, "points a and b are on the same pixel"));
        points = sharedPoints();
        points[2].pixel = {1500, 300};
        QVERIFY(refusedWith(points, "point c is outside the image of the camera to register (1280×720)"));
        points = sharedPoints();
        for (SharedPoint &point : points)
            point.pixel.x() = 1279 - point.pixel.x();
        QVERIFY(refusedWith(points, "mirrored"));
        points = sharedPoints();
        points.resize(4);
        for (int i = 0; i < 4; ++i) {
            const Vector3d position(0.9 + 0.3 * i, 0.9, 0);
            points[std::size_t(i)].pixel = *ownView.pixelFromWorld(position);
            points[std::size_t(i)].referencePixel = *referenceView.pixelFromWorld(position);
        }
        QVERIFY(refusedWith(points, "on one line"));
    }
    void aPointBeyondTheHorizonIsNamed()
    {
        // A camera that looks level: the upper half of its picture is no floor.
        const FloorView level = viewFrom({0.4, -1.2, 2}, {1.4, 1.0, 1.9});
        std::vector<SharedPoint> points = sharedPoints();
        for (SharedPoint &point : points)
            point.referencePixel = {100 + 200.0 * double(&point - points.data()), 700};
        points[2].referencePixel = {600, 100};
        const auto chained = registerViaCamera(level, foreignWords("B"), points, lens(), true);
        QVERIFY(!chained.has_value());
        QVERIFY(chained.error().message().find("point c is at or beyond the horizon of B; choose") !=
                std::string::npos);
    }
};

ODOGRAPH_TEST(TestChainedRegistration, QCoreApplication)
#include "tst_chained_registration.moc"
