// SPDX-License-Identifier: GPL-3.0-or-later
// A camera's pose on the floor by another one's and their relation: its covariance against drawn errors.
#include "core/calibration/related_registration.h"

#include "core/calibration/intrinsics_influence.h"
#include "core/simulation/demo_testbed.h"
#include "tests/support/registered_test.h"

#include <Eigen/LU>
#include <QTest>
#include <cmath>
#include <random>

using namespace odo;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

namespace {

Matrix6d covariance(double turn, double shift)
{
    Vector6d sigma;
    sigma << turn, 0.6 * turn, 0.8 * turn, shift, 1.4 * shift, 0.7 * shift;
    Matrix6d mixed = sigma.cwiseAbs2().asDiagonal();
    mixed(0, 4) = mixed(4, 0) = 0.5 * sigma(0) * sigma(4);
    return mixed;
}

RigidTransform turnedFromLeft(const RigidTransform &pose, const Vector6d &step)
{
    const Vector3d turn = step.head<3>();
    return {Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * pose.rotation,
            pose.translation + step.tail<3>()};
}

Vector6d differenceFrom(const RigidTransform &truth, const RigidTransform &pose)
{
    const Eigen::AngleAxisd turn(pose.rotation * truth.rotation.conjugate());
    Vector6d error;
    error << turn.angle() * turn.axis(), pose.translation - truth.translation;
    return error;
}

const FloorView viewA = simulatedView({0.4, -1.6, 1.9}, {1.3, 1.0, 0}, 1280, 720, 900);
const FloorView viewB = simulatedView({2.1, -1.4, 1.7}, {1.5, 1.1, 0}, 1280, 720, 850);

CameraPair truePair()
{
    CameraPair pair;
    pair.bFromA = viewB.cameraFromWorld() * viewA.worldFromCamera();
    pair.covariance = covariance(0.001, 0.003);
    pair.baselineM = pair.bFromA.translation.norm();
    return pair;
}

} // namespace

class TestRelatedRegistration : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void thePoseAndItsCovarianceFollow()
    {
        const PoseOnFloor a{viewA.worldFromCamera(), covariance(0.002, 0.004)};
        const CameraPair pair = truePair();
        const PoseOnFloor b = poseByRelation(a, pair);
        QVERIFY(differenceFrom(viewB.worldFromCamera(), b.worldFromCamera).norm() < 1e-9);
        std::mt19937 random(1);
        std::normal_distribution<double> normal(0, 1);
        const Matrix6d rootA = a.covariance.llt().matrixL(), rootPair = pair.covariance.llt().matrixL();
        const auto drawn = [&](const Matrix6d &root) {
            Vector6d unit;
            for (double &value : unit)
                value = normal(random);
            return Vector6d(root * unit);
        };
        constexpr int draws = 4000;
        double mahalanobis = 0;
        for (int i = 0; i < draws; ++i) {
            CameraPair other = pair;
            other.bFromA = turnedFromLeft(pair.bFromA, drawn(rootPair));
            const RigidTransform pose =
                turnedFromLeft(a.worldFromCamera, drawn(rootA)) * other.bFromA.inverse();
            const Vector6d error = differenceFrom(b.worldFromCamera, pose);
            mahalanobis += error.dot(b.covariance.inverse() * error) / draws;
        }
        // χ² of six degrees of freedom has the mean 6 and the variance 12.
        QVERIFY2(std::abs(mahalanobis - 6) < 4 * std::sqrt(12.0 / draws),
                 qPrintable(QString::number(mahalanobis)));
        const CameraPair back = reversed(reversed(pair));
        QVERIFY(differenceFrom(pair.bFromA, back.bFromA).norm() < 1e-12);
        QVERIFY((back.covariance - pair.covariance).norm() < 1e-12);
    }

    void itRegistersTheOtherCamera()
    {
        const PoseOnFloor b = poseByRelation({viewA.worldFromCamera(), covariance(0.001, 0.002)}, truePair());
        const auto registered = registerByPose(b, cameraSubject("A"), viewB.camera(), 0.2);
        QVERIFY2(registered.has_value(), registered ? "" : registered.error().message().c_str());
        QVERIFY(registered->registration.floorSigmaM > 0.002 && registered->registration.floorSigmaM < 0.08);
        QVERIFY(registered->registration.verdict.english().find(
                    "via camera 'A' and a board that both see; floor uncertainty ±") != std::string::npos);
        const FloorView view = floorViewOf(registered->registration, viewB.camera(), registered->pixels);
        const auto pixel = viewB.pixelFromWorld({1.2, 0.8, 0});
        QVERIFY((*view.floorFromPixel(*pixel, 0) - Eigen::Vector2d(1.2, 0.8)).norm() < 1e-9);
    }

    void whatSaysTooLittleIsRefused()
    {
        PoseOnFloor b{viewB.worldFromCamera(), covariance(0.1, 0.5)};
        const auto unsure = registerByPose(b, cameraSubject("A"), viewB.camera(), 0.2);
        QVERIFY(!unsure.has_value());
        QVERIFY2(unsure.error().message().starts_with(
                     "the camera cannot be registered by the pair: the floor uncertainty would be ±"),
                 unsure.error().message().c_str());
        b = {simulatedView({0, 0, 1.5}, {0, 9, 9}, 1280, 720, 900).worldFromCamera(), Matrix6d::Zero()};
        const auto up = registerByPose(b, cameraSubject("A"), viewB.camera(), 0.2);
        QCOMPARE(up.error().message(),
                 std::string("the camera cannot be registered by the pair: it would see hardly any floor; "
                             "check the registration of camera 'A' and the pair"));
    }

    void aDifferenceIsJudgedByItsSigma()
    {
        const PoseOnFloor one{viewB.worldFromCamera(), covariance(0.001, 0.003)};
        PoseOnFloor other = one;
        other.worldFromCamera.translation.x() += 0.005;
        QVERIFY(!differenceOf(one, other).isSignificant);
        QVERIFY(std::abs(differenceOf(one, other).distanceM - 0.005) < 1e-9);
        other.worldFromCamera.translation.x() += 0.1;
        QVERIFY(differenceOf(one, other).isSignificant);
    }
};

ODOGRAPH_TEST(TestRelatedRegistration, QCoreApplication)
#include "tst_related_registration.moc"
