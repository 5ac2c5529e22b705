// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_registration.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <random>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

CameraModel bentCamera()
{
    Intrinsics intrinsics = CameraModel::assumed(1280, 720).intrinsics();
    intrinsics.fxPx = 950;
    intrinsics.fyPx = 948;
    intrinsics.distortion = {-0.22, 0.07, 0.0008, -0.0006};
    return CameraModel::create(intrinsics).value();
}

CameraModel straightCamera(double focalPx)
{
    Intrinsics intrinsics = CameraModel::assumed(1280, 720).intrinsics();
    intrinsics.fxPx = intrinsics.fyPx = focalPx;
    return CameraModel::create(intrinsics).value();
}

RigidTransform lookAt(const Vector3d &position, const Vector3d &target)
{
    const Vector3d forward = (target - position).normalized();
    const Vector3d right = forward.cross(Vector3d::UnitZ()).normalized();
    Eigen::Matrix3d axes;
    axes << right, forward.cross(right), forward;
    return {Eigen::Quaterniond(axes), position};
}

const Vector3d position(-0.9, -1.6, 1.7);

RigidTransform pose()
{
    return lookAt(position, {1.0, 0.7, 0});
}

MarkerLayout layoutOf(const std::vector<Vector2d> &points)
{
    static const char *const labels[] = {"O", "U", "V", "D", "E", "F", "G", "H"};
    MarkerLayout layout{"floor", {}};
    for (const Vector2d &point : points)
        layout.markers.push_back({labels[layout.markers.size()], point});
    return layout;
}

MarkerLayout rectangle()
{
    return layoutOf({{0, 0}, {2, 0}, {0, 1.5}, {2, 1.5}});
}
MarkerLayout sixMarkers()
{
    return layoutOf({{0, 0}, {2, 0}, {0, 1.5}, {2, 1.5}, {1.1, 0.4}, {0.6, 1.1}});
}

std::vector<MarkerPixel> seenBy(const CameraModel &camera, const MarkerLayout &layout,
                                const RigidTransform &worldFromCamera = pose())
{
    const FloorView view(camera, worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
    std::vector<MarkerPixel> pixels;
    for (const Marker &marker : layout.markers)
        pixels.push_back(
            {marker.label,
             view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0}).value()});
    return pixels;
}

bool refusedWith(const MarkerLayout &layout, const std::vector<MarkerPixel> &pixels, const char *words,
                 bool intrinsicsKnown = true)
{
    const auto registration = registerFloor(layout, pixels, bentCamera(), intrinsicsKnown);
    if (registration) {
        qWarning("accepted: %s", registration->verdict.english().c_str());
        return false;
    }
    const std::string message = registration.error().message();
    return contains(message, words) && contains(message, "the floor cannot be registered: ");
}

} // namespace

class TestFloorRegistration : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void fourMarkersThroughABentLensGiveThePlaceExactly()
    {
        const auto registration =
            registerFloor(rectangle(), seenBy(bentCamera(), rectangle()), bentCamera(), true);
        QVERIFY(registration.has_value());
        QVERIFY((registration->worldFromCamera.translation - position).norm() < 1e-9);
        QVERIFY(registration->worldFromCamera.rotation.angularDistance(pose().rotation) < 1e-9);
        QVERIFY(registration->rmsPx < 1e-8);
        QCOMPARE(registration->markers.size(), std::size_t(4));
        QVERIFY(contains(registration->verdict.english(), "Good: 4 markers fit to 0.0 mm RMS"));
        QVERIFY(contains(registration->verdict.english(), "add a fifth"));
        QVERIFY(registration->verdict.english().find("distortion") == std::string::npos);
    }
    void markersThatOnlyOneListHasAreLeftOut()
    {
        MarkerLayout layout = sixMarkers();
        std::vector<MarkerPixel> pixels = seenBy(bentCamera(), layout);
        layout.markers.erase(layout.markers.begin());
        pixels.pop_back();
        const auto registration = registerFloor(layout, pixels, bentCamera(), true);
        QVERIFY(registration.has_value());
        QCOMPARE(registration->markers.size(), std::size_t(4));
        QVERIFY((registration->worldFromCamera.translation - position).norm() < 1e-9);
    }
    void covarianceAgreesWithMonteCarlo()
    {
        const MarkerLayout layout = sixMarkers();
        const std::vector<MarkerPixel> exact = seenBy(bentCamera(), layout);
        std::mt19937 random(17);
        const double sigmaPx = 0.3; // as the prior has it, so that the mean of what is stated must be right
        std::normal_distribution<double> noise(0, sigmaPx);
        Eigen::Matrix<double, 6, 6> sampled = Eigen::Matrix<double, 6, 6>::Zero(), stated = sampled;
        const int draws = 1500;
        for (int i = 0; i < draws; ++i) {
            std::vector<MarkerPixel> pixels = exact;
            for (MarkerPixel &pixel : pixels)
                pixel.pixel += Vector2d(noise(random), noise(random));
            const auto registration = registerFloor(layout, pixels, bentCamera(), true);
            QVERIFY(registration.has_value());
            const Eigen::AngleAxisd turn(registration->worldFromCamera.rotation *
                                         pose().rotation.conjugate());
            Eigen::Matrix<double, 6, 1> off;
            off << turn.angle() * turn.axis(), registration->worldFromCamera.translation - position;
            sampled += off * off.transpose() / draws;
            stated += registration->poseCovariance / draws;
        }
        for (int i = 0; i < 6; ++i) // 1500 draws know a σ to 1.8 %
            QVERIFY(std::abs(std::sqrt(sampled(i, i) / stated(i, i)) - 1) < 0.08);
    }
    void theLensIsEstimatedWhereTheViewDeterminesIt()
    {
        const CameraModel truth = straightCamera(1111);
        const auto registration =
            registerFloor(sixMarkers(), seenBy(truth, sixMarkers()), CameraModel::assumed(1280, 720), false);
        QVERIFY(registration.has_value());
        QCOMPARE(intrinsicsSourceOf(registration->intrinsics, false), IntrinsicsSource::Floor);
        const double sigmaPx = std::sqrt(registration->intrinsics.covariance(0, 0));
        QVERIFY(sigmaPx < 50);
        QVERIFY(std::abs(registration->intrinsics.fxPx - 1111) < sigmaPx);
        QVERIFY(contains(registration->verdict.english(), "were estimated from the markers"));
    }
    void theLensIsAssumedWhereTheViewDoesNotDetermineIt()
    {
        // Straight from above the picture is a plain scale: any focal length fits with another height.
        const RigidTransform above{Eigen::Quaterniond(Eigen::AngleAxisd(EIGEN_PI, Vector3d::UnitX())),
                                   {1, 0.7, 3}};
        const CameraModel truth = straightCamera(900);
        const auto registration = registerFloor(sixMarkers(), seenBy(truth, sixMarkers(), above),
                                                CameraModel::assumed(1280, 720), false);
        QVERIFY(registration.has_value());
        QCOMPARE(intrinsicsSourceOf(registration->intrinsics, false), IntrinsicsSource::Assumed);
        const double sigmaPx = std::sqrt(registration->intrinsics.covariance(0, 0));
        QVERIFY(sigmaPx > 0.3 * registration->intrinsics.fxPx);
        QVERIFY(contains(registration->verdict.english(), "the markers hardly determine it"));
        QVERIFY(registration->rmsM < 1e-3);
    }
    void refusesTooFewMarkers()
    {
        MarkerLayout layout = rectangle();
        std::vector<MarkerPixel> pixels = seenBy(bentCamera(), layout);
        pixels[3].label = 'X';
        QVERIFY(refusedWith(layout, pixels, "they have 3 (O, U and V)"));
        QVERIFY(refusedWith(layout, {}, "they have 0 (none)"));
    }
    void refusesDoubledMarkers()
    {
        const std::vector<MarkerPixel> pixels = seenBy(bentCamera(), rectangle());
        MarkerLayout layout = rectangle();
        layout.markers[1].label = 'O';
        QVERIFY(refusedWith(layout, pixels, "marker O appears twice in the layout"));
        std::vector<MarkerPixel> twice = pixels;
        twice[2].label = 'D';
        QVERIFY(refusedWith(rectangle(), twice, "marker D appears twice in the image"));
        layout = rectangle();
        layout.markers[1].pointInWorld = {0.0005, 0};
        QVERIFY(refusedWith(layout, pixels, "markers O and U have the same floor position"));
        twice = pixels;
        twice[3].pixel = pixels[1].pixel + Vector2d(0.4, 0.2);
        QVERIFY(refusedWith(rectangle(), twice, "markers U and D are on the same pixel"));
    }
    void refusesCollinearMarkers()
    {
        const MarkerLayout line = layoutOf({{0, 0}, {1, 0}, {2, 0}, {1.5, 1}});
        QVERIFY(refusedWith(line, seenBy(bentCamera(), line), "O, U and V lie on one line"));
        // nearly: 1 cm on 2 m
        MarkerLayout nearly = layoutOf({{0, 0.005}, {0.6, -0.004}, {1.3, 0.006}, {2, -0.005}, {1.7, 0.004}});
        QVERIFY(refusedWith(nearly, seenBy(bentCamera(), nearly), "lie on one line"));
    }
    void nearlyCollinearMarkersWithNoiseAreNeverAccepted()
    {
        std::mt19937 random(23);
        std::normal_distribution<double> offM(0, 0.004), offPx(0, 0.5);
        for (int i = 0; i < 300; ++i) {
            MarkerLayout layout = layoutOf({{0, 0}, {0.5, 0}, {1.2, 0}, {1.6, 0}, {2, 0}});
            std::vector<MarkerPixel> pixels = seenBy(bentCamera(), layout);
            for (std::size_t m = 0; m < pixels.size(); ++m) {
                layout.markers[m].pointInWorld.y() += offM(random);
                pixels[m].pixel += Vector2d(offPx(random), offPx(random));
            }
            QVERIFY(!registerFloor(layout, pixels, bentCamera(), true).has_value());
        }
    }
    void refusesAMirroredLayoutAndSaysWhatIsMirrored()
    {
        MarkerLayout mirrored = sixMarkers();
        for (Marker &marker : mirrored.markers)
            marker.pointInWorld.y() *= -1;
        QVERIFY(refusedWith(mirrored, seenBy(bentCamera(), sixMarkers()), "mirrored"));
        QVERIFY(refusedWith(mirrored, seenBy(bentCamera(), sixMarkers()), "camera would be below the floor"));
        QVERIFY(refusedWith(mirrored, seenBy(bentCamera(), sixMarkers()), "check the signs of the layout"));
    }
    void namesTheTwoLabelsThatAreExchanged()
    {
        for (const MarkerLayout &layout : {rectangle(), sixMarkers()}) {
            const std::vector<MarkerPixel> right = seenBy(bentCamera(), layout);
            for (std::size_t i = 0; i < right.size(); ++i) {
                for (std::size_t j = i + 1; j < right.size(); ++j) {
                    std::vector<MarkerPixel> pixels = right;
                    std::swap(pixels[i].pixel, pixels[j].pixel);
                    const std::string words =
                        "with " + right[i].label + " and " + right[j].label + " swapped";
                    QVERIFY(refusedWith(layout, pixels, words.c_str()));
                    if (layout.markers.size() > 4)
                        QVERIFY(!registerFloor(layout, pixels, bentCamera(), false).has_value());
                }
            }
        }
    }
    void ofAllOrdersOfFourMarkersOnlyTheRightOneIsAccepted()
    {
        // No square or rectangle, which look the same when turned.
        const MarkerLayout layout = layoutOf({{0, 0}, {2, 0}, {0, 1.5}, {2, 1.8}});
        const std::vector<MarkerPixel> right = seenBy(bentCamera(), layout);
        std::array<std::size_t, 4> order{0, 1, 2, 3};
        int accepted = 0;
        do {
            std::vector<MarkerPixel> pixels = right;
            for (std::size_t i = 0; i < 4; ++i)
                pixels[i].pixel = right[order[i]].pixel;
            const auto registration = registerFloor(layout, pixels, bentCamera(), true);
            // One other order fits by chance to 1.8 px: the right one fits far better, so it is refused all
            // the same.
            accepted += registration.has_value();
        } while (std::ranges::next_permutation(order).found);
        QCOMPARE(accepted, 1);
    }
    void refusesWhatIsNoNumber()
    {
        MarkerLayout layout = rectangle();
        std::vector<MarkerPixel> pixels = seenBy(bentCamera(), layout);
        pixels[1].pixel.y() = std::nan("");
        QVERIFY(refusedWith(layout, pixels, "the pixel of marker U is not a finite number"));
        layout.markers[2].pointInWorld.x() = std::numeric_limits<double>::infinity();
        QVERIFY(refusedWith(layout, pixels, "the position of marker V is not a finite number"));
    }
    void refusesAWrongUnit()
    {
        const std::vector<MarkerPixel> pixels = seenBy(bentCamera(), rectangle());
        for (const auto &[factor, words] : {std::pair(1e-3, "only 1.7 mm above the floor; check the unit"),
                                            std::pair(1e3, "1700 m above the floor; check the unit")}) {
            MarkerLayout layout = rectangle();
            for (Marker &marker : layout.markers)
                marker.pointInWorld *= factor;
            QVERIFY(refusedWith(layout, pixels, words));
        }
    }
    void refusesMarkersThatFitNoPlane()
    {
        const MarkerLayout layout = sixMarkers();
        std::vector<MarkerPixel> pixels = seenBy(bentCamera(), layout);
        pixels[4].pixel += Vector2d(160, -140);
        QVERIFY(refusedWith(layout, pixels, "do not fit a flat floor"));
    }
    void refusesFourMarkersOfWhichOneIsCareless()
    {
        // Of 7 px aside two are left in the residuals, which alone would pass; a fifth marker tells which it
        // is.
        const MarkerLayout layout = rectangle();
        std::vector<MarkerPixel> pixels = seenBy(bentCamera(), layout);
        pixels[3].pixel += Vector2d(3, 1);
        QVERIFY2(!refusedWith(layout, pixels, "are too few to identify the wrong one"),
                 "three pixels may happen to anybody");
        pixels[3].pixel += Vector2d(4, 2);
        QVERIFY(refusedWith(layout, pixels,
                            "are too few to identify the wrong one; it may be wrong by much more; mark and "
                            "remeasure them, or add another"));
        MarkerLayout five = layoutOf({{0, 0}, {2, 0}, {0, 1.5}, {2, 1.5}, {1.1, 0.4}});
        pixels = seenBy(bentCamera(), five);
        pixels[3].pixel += Vector2d(3, 1);
        const auto told = registerFloor(five, pixels, bentCamera(), true);
        QVERIFY2(told.has_value(), told ? "" : told.error().message().c_str());
        QVERIFY2(told->verdict.english().find("worst D") != std::string::npos,
                 told->verdict.english().c_str());
    }
    void aMarkerMeasuredWronglyIsNamedInTheVerdict()
    {
        const MarkerLayout truth = sixMarkers();
        MarkerLayout layout = truth;
        layout.markers[5].pointInWorld.x() += 0.05;
        const auto registration = registerFloor(layout, seenBy(bentCamera(), truth), bentCamera(), true);
        QVERIFY(registration.has_value());
        QVERIFY(contains(registration->verdict.english(), "worst F"));
        QVERIFY(contains(registration->verdict.english(), "Poor, measure the markers again"));
    }
    void soundLayoutsAreHardlyEverRefused()
    {
        std::mt19937 random(29);
        std::uniform_real_distribution<double> across(-1, 1);
        std::normal_distribution<double> noise(0, 0.5);
        int refused = 0, tried = 0;
        while (tried < 500) {
            const RigidTransform stand =
                lookAt({3 * across(random), -2.5 + across(random), 2 + 0.8 * across(random)}, {1, 0.75, 0});
            MarkerLayout layout = rectangle();
            for (Marker &marker : layout.markers)
                marker.pointInWorld += 0.3 * Vector2d(across(random), across(random));
            std::vector<MarkerPixel> pixels = seenBy(bentCamera(), layout, stand);
            for (MarkerPixel &pixel : pixels)
                pixel.pixel += Vector2d(noise(random), noise(random));
            ++tried;
            const auto registration = registerFloor(layout, pixels, bentCamera(), true);
            refused += !registration.has_value();
            if (!registration)
                qWarning("refused: %s", registration.error().message().c_str());
            else
                QVERIFY((registration->worldFromCamera.translation - stand.translation).norm() < 0.1);
        }
        QCOMPARE(refused, 0);
    }
};

ODOGRAPH_TEST(TestFloorRegistration, QCoreApplication)
#include "tst_floor_registration.moc"
