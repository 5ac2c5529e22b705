// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/internal/planned_registration.h"
#include "core/calibration/placement_advice.h"
#include "core/simulation/demo_testbed.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <QTest>
#include <random>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double markerSigmaPx = 0.3, robotSigmaPx = 0.1;

MarkerLayout layout()
{
    return {"floor", {{"O", {0, 0}}, {"U", {3, 0}}, {"V", {0, 2}}, {"D", {3, 2}}, {"M", {1.5, 1}}}};
}

AdvisedCamera camera(const std::string &name, const Vector3d &position, double focalPx = 900)
{
    return {name, simulatedView(position, {1.5, 1, 0}, 1280, 720, focalPx), markerSigmaPx};
}

/// Two cameras somewhere beside the floor, each of which sees all markers.
std::vector<AdvisedCamera> drawnCameras(std::mt19937 &random)
{
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<AdvisedCamera> cameras;
    while (cameras.size() < 2) {
        const double direction = 2 * EIGEN_PI * share(random), away = 2.4 + 2 * share(random);
        AdvisedCamera one = camera(
            cameras.empty() ? "A" : "B",
            {1.5 + away * std::cos(direction), 1 + away * std::sin(direction), 1.2 + 1.3 * share(random)},
            700 + 300 * share(random));
        const FloorView exact(one.view.camera(), one.view.worldFromCamera(),
                              Eigen::Matrix<double, 6, 6>::Zero());
        if (const auto seen = registeredByMarkers(exact, layout(), markerSigmaPx); seen)
            cameras.push_back(std::move(one));
    }
    return cameras;
}

/// Where on the floor between the markers the cameras are the least accurate together, as they would be
/// registered.
Vector2d worstPosition(const std::vector<FloorView> &cameras)
{
    const FloorGrid grid = gridOver(layout(), 0, 12);
    const std::vector<double> sigma = accuracyMap(cameras, grid, robotSigmaPx).fusedSigmaM;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < sigma.size(); ++i)
        if (sigma[i] > sigma[worst])
            worst = i;
    return grid.at(int(worst) % grid.columns, int(worst) / grid.columns);
}

/// Registers cameras with noisy pixels of the markers and locates a point of the floor with them by a noisy
/// pixel each, many times: the root mean square of the error along the direction in which it is the largest.
double simulatedErrorM(const std::vector<FloorView> &truth, const Vector2d &point, std::mt19937 &random)
{
    constexpr int draws = 1500;
    std::normal_distribution<double> unit;
    const auto noisy = [&](const FloorView &view, const Vector2d &at, double sigmaPx) -> Vector2d {
        return *view.pixelFromWorld({at.x(), at.y(), 0}) + sigmaPx * Vector2d(unit(random), unit(random));
    };
    Eigen::Matrix2d errors = Eigen::Matrix2d::Zero();
    for (int i = 0; i < draws; ++i) {
        Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
        Vector2d sum = Vector2d::Zero();
        for (const FloorView &view : truth) {
            std::vector<PointPair> pairs;
            for (const Marker &marker : layout().markers)
                if (const auto pixel =
                        view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
                    isWithin(*pixel, view.camera().intrinsics()))
                    pairs.push_back(
                        {marker.pointInWorld, noisy(view, marker.pointInWorld, markerSigmaPx), marker.label});
            const auto pose =
                refinePlanePose(pairs, view.camera(), FocalLength::Known, view.worldFromCamera());
            const Eigen::Matrix<double, 6, 6> covariance =
                markerSigmaPx * markerSigmaPx * pose->inverseNormal;
            const FloorView registered(view.camera(), pose->worldFromCamera, covariance);
            const auto located =
                registered.locate(noisy(view, point, robotSigmaPx),
                                  robotSigmaPx * robotSigmaPx * Eigen::Matrix2d::Identity(), 0);
            const Eigen::Matrix2d weight =
                (located->pixelCovariance + located->calibrationCovariance).inverse();
            information += weight;
            sum += weight * located->pointInWorld;
        }
        const Vector2d error = information.inverse() * sum - point;
        errors += error * error.transpose() / draws;
    }
    return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(errors).eigenvalues().y());
}

} // namespace

class TestPlacementAdvice : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// Over simulated set-ups, each with its own noise, following the first advice brings what was promised.
    void whoFollowsItGetsThePromisedGain()
    {
        std::mt19937 random(7);
        int advised = 0;
        double promised = 0, got = 0;
        for (int setUp = 0; setUp < 20; ++setUp) {
            const std::vector<AdvisedCamera> cameras = drawnCameras(random);
            PlacementQuestion question;
            question.sigmaPx = robotSigmaPx;
            const auto advice = placementAdvice(cameras, layout(), question, {});
            QVERIFY2(advice.has_value(), advice ? "" : advice.error().message().c_str());
            if (advice->moves.empty())
                continue;
            ++advised;
            const PlacementMove &move = advice->moves.front();
            std::vector<FloorView> before, after;
            for (const AdvisedCamera &one : cameras) {
                const FloorView exact(one.view.camera(), one.view.worldFromCamera(),
                                      Eigen::Matrix<double, 6, 6>::Zero());
                before.push_back(*registeredByMarkers(exact, layout(), markerSigmaPx));
            }
            after = before;
            after[move.camera] = move.view;
            const double gain = simulatedErrorM(before, worstPosition(before), random) -
                                simulatedErrorM(after, worstPosition(after), random);
            const double told = advice->now.worstM - move.worstM;
            promised += told;
            got += gain;
            QVERIFY2(gain > 0.8 * told, qPrintable(QStringLiteral("%1: %2 mm of %3 mm, %4")
                                                       .arg(setUp)
                                                       .arg(1000 * gain)
                                                       .arg(1000 * told)
                                                       .arg(QString::fromStdString(move.words.english()))));
        }
        QVERIFY2(advised >= 15, qPrintable(QString::number(advised)));
        QVERIFY2(got > 0.9 * promised && got < 1.1 * promised, qPrintable(QString::number(got / promised)));
    }

    /// A camera that looks along the floor is better farther up or nearer; the sentence says the move as one
    /// sees it from behind the camera.
    void theSentenceSaysTheMove()
    {
        const std::vector<AdvisedCamera> cameras{camera("A", {1.5, -2.2, 2}, 700),
                                                 camera("low", {1.5, 5.5, 0.7}, 1300)};
        const auto advice = placementAdvice(cameras, layout(), {}, {});
        QVERIFY(advice.has_value() && !advice->moves.empty());
        for (const PlacementMove &move : advice->moves) {
            const std::string words = move.words.english();
            QVERIFY2(contains(words, "Moving " + cameras[move.camera].name + " by "), words.c_str());
            QCOMPARE(contains(words, " to the left"), move.leftM > 0);
            QCOMPARE(contains(words, " to the right"), move.leftM < 0);
            QCOMPARE(contains(words, " up"), move.upM > 0);
            QCOMPARE(contains(words, " away from "), move.backM > 0);
            QVERIFY(move.worstM <= 0.9 * advice->now.worstM + 1e-12);
            const Vector3d moved = move.view.cameraInWorld() - cameras[move.camera].view.cameraInWorld();
            QVERIFY(std::abs(moved.z() - move.upM) < 1e-9);
            QVERIFY(std::abs(moved.norm() - Vector3d(move.leftM, move.backM, move.upM).norm()) < 1e-9);
            const Vector3d right = cameras[move.camera].view.worldFromCamera().rotation * Vector3d::UnitX();
            QVERIFY(std::abs(moved.dot(right) + move.leftM) < 1e-6);
        }
    }

    /// What the time offset costs is the same everywhere, so less of the error can be gained.
    void aFastRobotGainsLess()
    {
        std::mt19937 random(11);
        const std::vector<AdvisedCamera> cameras = drawnCameras(random);
        PlacementQuestion fast;
        fast.speedMps = 2;
        fast.timeSigmaS = 0.004;
        const auto slow = placementAdvice(cameras, layout(), {}, {}),
                   quick = placementAdvice(cameras, layout(), fast, {});
        QVERIFY(slow && quick);
        QVERIFY(std::abs(quick->now.worstM - std::hypot(slow->now.worstM, 0.004)) < 1e-9);
        QVERIFY(quick->moves.empty() || quick->moves.front().worstM > slow->moves.front().worstM);
    }

    void noFloorIsLost()
    {
        std::mt19937 random(3);
        const std::vector<AdvisedCamera> cameras = drawnCameras(random);
        const auto advice = placementAdvice(cameras, layout(), {}, {});
        QVERIFY(advice.has_value());
        for (const PlacementMove &move : advice->moves) {
            std::vector<FloorView> views{cameras[0].view, cameras[1].view};
            views[move.camera] = move.view;
            const FloorScore then = floorScore(views, gridOver(layout(), 0, 12), 0.1, 0);
            QCOMPARE(then.unseen, 0);
        }
    }

    void whoSeesTooFewMarkersIsLeftOut()
    {
        // looks away from the floor
        const AdvisedCamera blind{"away", simulatedView({1.5, -2, 2}, {1.5, -6, 0}, 1280, 720, 900), 0.3};
        const auto one =
            placementAdvice(std::vector{camera("A", {1.5, -2.2, 2}, 700), blind}, layout(), {}, {});
        QVERIFY(one.has_value());
        QCOMPARE(one->remarks.size(), std::size_t(1));
        QVERIFY2(contains(one->remarks.front().english(), "camera 'away'"),
                 one->remarks.front().english().c_str());
        const auto none = placementAdvice(std::vector{blind}, layout(), {}, {});
        QVERIFY(!none && contains(none.error().message(), "no camera sees four markers"));
    }

    void itCanBeCancelled()
    {
        const CancelToken token;
        token.cancel();
        const auto advice = placementAdvice(std::vector{camera("A", {1.5, -2.2, 2}, 700)}, layout(), {},
                                            JobControl{token, {}});
        QVERIFY(!advice && advice.error().code == ErrorCode::Cancelled);
    }
};

ODOGRAPH_TEST(TestPlacementAdvice, QCoreApplication)
#include "tst_placement_advice.moc"
