// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/accuracy_map.h"
#include "core/calibration/intrinsics_influence.h"
#include "core/calibration/registration_checks.h"
#include "core/calibration/world_axes.h"
#include "tests/calibration/floor_views.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"

#include <Eigen/Eigenvalues>
#include <QTest>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

MarkerLayout layout()
{
    return {"floor", {{"O", {0, 0}}, {"U", {2.4, 0}}, {"V", {0, 1.8}}, {"D", {2.7, 2.0}}, {"E", {1.2, 0.7}}}};
}

FloorView trueView(double side)
{
    return simulatedView({1.2 + side * 2.1, -1.55, 2.0}, {1.2, 0.8, 0.0}, 1280, 720, 820);
}

std::vector<MarkerPixel> noisy(const FloorView &view, double sigmaPx, std::mt19937 &random)
{
    std::normal_distribution<double> noise(0, sigmaPx);
    std::vector<MarkerPixel> pixels = markersIn(view, layout(), 5);
    for (MarkerPixel &pixel : pixels)
        pixel.pixel += Vector2d(noise(random), noise(random));
    return pixels;
}

FloorView registered(const FloorView &truth, std::mt19937 &random)
{
    const auto pixels = noisy(truth, 0.3, random);
    return floorViewOf(*registerFloor(layout(), pixels, truth.camera(), true), truth.camera(), pixels);
}

} // namespace

class TestFloorChecks : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theSigmaOfALengthIsWhatItScatters()
    {
        const FloorView truth = trueView(-1);
        std::mt19937 random(5);
        std::normal_distribution<double> noise(0, 0.5);
        double squares = 0, stated = 0;
        const int draws = 1500;
        for (int i = 0; i < draws; ++i) {
            const FloorView view = registered(truth, random);
            const Vector2d from =
                *truth.pixelFromWorld({0.5, 0.4, 0}) + Vector2d(noise(random), noise(random));
            const Vector2d to = *truth.pixelFromWorld({1.5, 1.4, 0}) + Vector2d(noise(random), noise(random));
            const SeenLength seen[] = {{&view, "A", from, to}};
            const auto check = checkLength(seen, std::nullopt);
            QVERIFY(check.has_value());
            squares += std::pow(check->lengthM - std::sqrt(2.0), 2) / draws;
            stated += check->sigmaM * check->sigmaM / draws;
        }
        // 1500 draws know a σ to 1.8 %.
        QVERIFY2(std::abs(std::sqrt(squares / stated) - 1) < 0.08,
                 qPrintable(QString::number(std::sqrt(squares / stated))));
    }
    void twoCamerasKnowALengthBetterAndSayWhereItIsWrong()
    {
        std::mt19937 random(6);
        const FloorView a = registered(trueView(-1), random), b = registered(trueView(1), random);
        const auto seenBy = [](const FloorView &view, const FloorView &truth, const char *name) {
            return SeenLength{&view, name, *truth.pixelFromWorld({0.5, 0.4, 0}),
                              *truth.pixelFromWorld({1.5, 0.4, 0})};
        };
        const SeenLength both[] = {seenBy(a, trueView(-1), "A"), seenBy(b, trueView(1), "B")};
        const auto one = checkLength({both, 1}, 1.0), two = checkLength(both, 1.0),
                   wrong = checkLength(both, 1.05);
        QVERIFY(one && two && wrong);
        QVERIFY(two->sigmaM < one->sigmaM);
        QVERIFY(two->agrees);
        QVERIFY(contains(two->words.english(), "within the limit of"));
        QVERIFY(!wrong->agrees);
        QVERIFY(contains(wrong->words.english(), "shorter than the 1050.0 mm entered: beyond the limit of"));
    }
    void badLengthsHaveTheirSentences()
    {
        const FloorView view = trueView(-1);
        const Vector2d here(640, 500);
        const SeenLength same[] = {{&view, "A", here, here}}, sky[] = {{&view, "A", here, {640, -3000}}};
        const SeenLength fine[] = {{&view, "A", here, {300, 400}}};
        QVERIFY(contains(checkLength({}, 1.0).error().message(), "no camera shows it"));
        QVERIFY(contains(checkLength(same, 1.0).error().message(), "both ends are on the same pixel"));
        QVERIFY(contains(checkLength(sky, 1.0).error().message(),
                         "the second end is at or beyond the horizon of camera 'A'"));
        QVERIFY(contains(checkLength(fine, -1.0).error().message(), "is not above 0"));
    }
    void theMapSaysWhatAPositionScatters()
    {
        std::mt19937 random(8);
        std::normal_distribution<double> noise(0, 0.2);
        const FloorView truth = trueView(-1), other = trueView(1);
        const FloorGrid grid = gridOver(layout(), 0.2, 9);
        const FloorView views[] = {registered(truth, random), registered(other, random)};
        const AccuracyMap map = accuracyMap(views, grid, 0.2);
        QCOMPARE(map.fusedSigmaM.size(), std::size_t(grid.columns) * std::size_t(grid.rows));
        int seen = 0;
        for (std::size_t i = 0; i < map.fusedSigmaM.size(); ++i) {
            if (std::isnan(map.cameraSigmaM[0][i]) || std::isnan(map.cameraSigmaM[1][i]))
                continue;
            ++seen;
            QVERIFY(map.fusedSigmaM[i] <=
                    std::min(map.cameraSigmaM[0][i], map.cameraSigmaM[1][i]) * (1 + 1e-9));
        }
        QVERIFY(seen > 20);
        // At one place, by brute force.
        const Vector2d position = grid.at(4, 3);
        Eigen::Matrix2d sampled = Eigen::Matrix2d::Zero();
        double stated = 0;
        const int draws = 1200;
        for (int i = 0; i < draws; ++i) {
            const FloorView view = registered(truth, random);
            const Vector2d pixel = *truth.pixelFromWorld({position.x(), position.y(), 0}) +
                                   Vector2d(noise(random), noise(random));
            const Vector2d error = *view.floorFromPixel(pixel, 0) - position;
            sampled += error * error.transpose() / draws;
            stated += std::pow(accuracyMap({&view, 1}, {position, 0.1, 1, 1}, 0.2).fusedSigmaM[0], 2) / draws;
        }
        const double actual = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(sampled).eigenvalues().y();
        QVERIFY2(std::abs(std::sqrt(actual / stated) - 1) < 0.1,
                 qPrintable(QString::number(std::sqrt(actual / stated))));
    }
    void aPlannedCameraPromisesWhatARealOneKeeps()
    {
        PlannedCamera planned;
        planned.heightM = 2.0;
        planned.distanceM = 2.4;
        planned.aimM = {1.2, 0.8};
        planned.fieldOfViewDegrees = 76;
        const auto view = plannedView(planned, layout());
        QVERIFY2(view.has_value(), view ? "" : view.error().message().c_str());
        QVERIFY(std::abs(view->cameraInWorld().z() - 2) < 1e-12);
        const Vector2d aimed = *view->pixelFromWorld({1.2, 0.8, 0});
        QVERIFY((aimed - Vector2d(639.5, 359.5)).norm() < 1e-6);
        QVERIFY(view->pixelFromWorld({1.2, 0.9, 0})->y() < aimed.y()); // what is farther is higher up
        std::mt19937 random(9);
        std::normal_distribution<double> noise(0, 0.3);
        auto pixels = markersIn(*view, layout(), 0);
        double sampled = 0;
        const Vector2d at = *view->pixelFromWorld({0.6, 1.2, 0});
        for (int i = 0; i < 800; ++i) {
            auto drawnPixels = pixels;
            for (MarkerPixel &pixel : drawnPixels)
                pixel.pixel += Vector2d(noise(random), noise(random));
            const auto registration = registerFloor(layout(), drawnPixels, view->camera(), true);
            const FloorView real(view->camera(), registration->worldFromCamera, registration->poseCovariance);
            sampled += (*real.floorFromPixel(at, 0) - Vector2d(0.6, 1.2)).squaredNorm() / 800;
        }
        const double promised = view->locate(at, Eigen::Matrix2d::Zero(), 0)->calibrationCovariance.trace();
        QVERIFY2(std::abs(std::sqrt(sampled / promised) - 1) < 0.1,
                 qPrintable(QString::number(std::sqrt(sampled / promised))));
    }
    void aPlanThatCannotBeIsRefused()
    {
        PlannedCamera planned;
        planned.heightM = -1;
        QVERIFY(contains(plannedView(planned, layout()).error().message(),
                         "height above the floor cannot be -1.00 m"));
        planned.heightM = 0.5;
        planned.distanceM = 0.5;
        planned.fieldOfViewDegrees = 30;
        QVERIFY(contains(plannedView(planned, layout()).error().message(), "of the layout's markers"));
        planned.fieldOfViewDegrees = 179;
        QVERIFY(contains(plannedView(planned, layout()).error().message(), "its field of view is 179.0°"));
    }
    void aCameraThatMovedAndAMarkerThatMovedAreToldApart()
    {
        const FloorView truth = trueView(-1);
        std::mt19937 random(10);
        const auto stored = noisy(truth, 0.2, random);
        const auto still = checkCameraPosition("B", truth, stored, noisy(truth, 0.2, random), 0.2);
        QVERIFY(still.has_value());
        QCOMPARE(int(still->verdict), int(CameraPositionCheck::Verdict::Still));
        QVERIFY(contains(still->words.english(), "B has not moved: 5 markers"));

        RigidTransform turned = truth.worldFromCamera();
        turned.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(0.007, Vector3d(0.3, 0.1, 1).normalized())) *
                          turned.rotation;
        const FloorView bumped(truth.camera(), turned, Eigen::Matrix<double, 6, 6>::Zero());
        const auto moved = checkCameraPosition("B", truth, stored, noisy(bumped, 0.2, random), 0.2);
        QCOMPARE(int(moved->verdict), int(CameraPositionCheck::Verdict::CameraMoved));
        QVERIFY(contains(moved->words.english(), "B has moved "));
        QVERIFY(contains(moved->words.english(), " px = "));

        auto one = noisy(truth, 0.2, random);
        one[1].pixel = *truth.pixelFromWorld({2.43, 0.01, 0});
        const auto marker = checkCameraPosition("B", truth, stored, one, 0.2);
        QCOMPARE(int(marker->verdict), int(CameraPositionCheck::Verdict::MarkersMoved));
        QVERIFY(contains(marker->words.english(), "Marker U has moved"));
        QVERIFY(std::abs(marker->shiftM - std::hypot(0.03, 0.01)) < 0.003);

        auto three = one;
        three.erase(three.begin() + 3, three.end());
        const auto missing = checkCameraPosition("B", truth, stored, {one[0]}, 0.2);
        QVERIFY(!missing.has_value());
        QVERIFY(contains(missing.error().message(), "1 of its 5 markers were found again, two are needed"));
        QVERIFY(contains(
            checkCameraPosition("B", truth, stored, {stored.begin() + 2, stored.end()}, 0.2)->words.english(),
            "Not found again: O and U."));
    }
    void noFalseAlarmsAndNoShiftOfTwoPixelsMissed()
    {
        const FloorView truth = trueView(-1);
        std::mt19937 random(12);
        int alarms = 0, missed = 0;
        const int draws = 3000;
        for (int i = 0; i < draws; ++i) {
            const auto stored = noisy(truth, 0.3, random);
            auto found = noisy(truth, 0.3, random);
            alarms += checkCameraPosition("B", truth, stored, found, 0.3)->verdict !=
                      CameraPositionCheck::Verdict::Still;
            for (MarkerPixel &pixel : found)
                pixel.pixel.x() += 2.5;
            missed += checkCameraPosition("B", truth, stored, found, 0.3)->verdict !=
                      CameraPositionCheck::Verdict::CameraMoved;
        }
        qInfo("%d false alarms and %d missed in %d", alarms, missed, draws);
        QVERIFY(alarms <= draws / 300 && missed <= draws / 50);
    }
    void foundAgainInAPicture()
    {
        const DrawnView before = drawFloorView(layout(), MarkerShape::Ring, 0.16, 31);
        const auto again =
            findAgain(before.frame, layout(), before.truth, before.scene.cameras[0].view.camera());
        QCOMPARE(again.size(), before.truth.size());
        QCOMPARE(
            int(checkCameraPosition("B", before.scene.cameras[0].view, before.truth, again, 0.2)->verdict),
            int(CameraPositionCheck::Verdict::Still));
        SimulatedScene scene = before.scene;
        const FloorView &view = scene.cameras[0].view;
        RigidTransform turned = view.worldFromCamera();
        turned.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(0.006, Vector3d::UnitZ())) * turned.rotation;
        scene.cameras[0].view = FloorView(view.camera(), turned, view.poseCovariance());
        const auto shifted =
            findAgain(SceneRenderer(scene, 0).render(0), layout(), before.truth, view.camera());
        QCOMPARE(int(checkCameraPosition("B", view, before.truth, shifted, 0.2)->verdict),
                 int(CameraPositionCheck::Verdict::CameraMoved));
    }
};

ODOGRAPH_TEST(TestFloorChecks, QCoreApplication)
#include "tst_floor_checks.moc"
