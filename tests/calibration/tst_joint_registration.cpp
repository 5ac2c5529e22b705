// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/joint_registration.h"
#include "tests/calibration/floor_views.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double tapeM = 0.002;

MarkerLayout positions()
{
    return {"floor",
            {{"O", {0, 0}},
             {"U", {2.4, 0}},
             {"V", {0, 1.8}},
             {"D", {2.7, 2.0}},
             {"E", {1.2, 0.7}},
             {"F", {0.6, 1.3}}}};
}

std::vector<FloorView> truth()
{
    return {simulatedView({-0.9, -1.55, 2.0}, {1.2, 0.9, 0.0}, 1280, 720, 760),
            simulatedView({3.6, -1.3, 1.8}, {1.2, 0.9, 0.0}, 1280, 720, 740),
            simulatedView({1.4, 4.4, 2.2}, {1.2, 0.9, 0.0}, 1280, 720, 780)};
}

struct Draw
{
    MarkerLayout measured;
    std::vector<JointCamera> cameras;
    std::vector<FloorRegistration> separate;
};

Draw draw(std::size_t cameras, std::mt19937 &random)
{
    std::normal_distribution<double> noise;
    Draw drawn{positions(), {}, {}};
    for (Marker &marker : drawn.measured.markers)
        marker.pointInWorld += tapeM * Vector2d(noise(random), noise(random));
    for (std::size_t i = 0; i < cameras; ++i) {
        const FloorView view = truth()[i];
        auto pixels = markersIn(view, positions(), 5);
        for (MarkerPixel &pixel : pixels)
            pixel.pixel += 0.3 * Vector2d(noise(random), noise(random));
        drawn.separate.push_back(*registerFloor(drawn.measured, pixels, view.camera(), true));
        drawn.cameras.push_back({std::string(1, static_cast<char>('A' + i)), view.camera(),
                                 drawn.separate.back().worldFromCamera, pixels});
    }
    return drawn;
}

/// Squared error over the floor, and what is stated of it.
void measure(const FloorRegistration &registration, const FloorView &view, double &actual, double &stated)
{
    const FloorView fitted(view.camera(), registration.worldFromCamera, registration.poseCovariance);
    for (double x = 0.2; x < 2.4; x += 0.5) {
        for (double y = 0.2; y < 1.8; y += 0.5) {
            const auto seen = fitted.locate(*view.pixelFromWorld({x, y, 0}), Eigen::Matrix2d::Zero(), 0);
            actual += (seen->pointInWorld - Vector2d(x, y)).squaredNorm();
            stated += seen->calibrationCovariance.trace();
        }
    }
}

} // namespace

class TestJointRegistration : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void togetherIsBetterThanApartAndAsSureAsItSays()
    {
        std::mt19937 random(7);
        double apart = 0, together = 0, stated = 0, unused = 0;
        int caveats = 0;
        const int draws = 120;
        for (int i = 0; i < draws; ++i) {
            const Draw drawn = draw(3, random);
            const auto joint = registerJointly(drawn.measured, drawn.cameras, tapeM);
            QVERIFY2(joint.has_value(), joint ? "" : joint.error().message().c_str());
            caveats += !joint->caveats.empty();
            for (std::size_t camera = 0; camera < 3; ++camera) {
                measure(drawn.separate[camera], truth()[camera], apart, unused);
                measure(joint->registrations[camera], truth()[camera], together, stated);
            }
        }
        qInfo("apart %.2f mm, together %.2f mm, stated %.2f mm; %d of %d with a doubt",
              1e3 * std::sqrt(apart / draws / 60), 1e3 * std::sqrt(together / draws / 60),
              1e3 * std::sqrt(stated / draws / 60), caveats, draws);
        QVERIFY(together < 0.97 * apart);
        // The draws' points err together; 120 draws of three cameras that share their markers know the ratio
        // to some 10 %.
        QVERIFY(std::abs(std::sqrt(together / stated) - 1) < 0.2);
        QVERIFY(caveats <= draws / 40);
    }
    void anImageRegisteredTwiceCountsOnce()
    {
        std::mt19937 random(9);
        Draw drawn = draw(2, random);
        const auto two = registerJointly(drawn.measured, drawn.cameras, tapeM);
        drawn.cameras.insert(drawn.cameras.begin() + 1, drawn.cameras[0]);
        drawn.cameras[1].name = "A again";
        drawn.cameras[1].pixels[2].pixel += Vector2d(0.1, 0.05);
        const auto three = registerJointly(drawn.measured, drawn.cameras, tapeM);
        QVERIFY2(two && three, three ? "" : three.error().message().c_str());
        QCOMPARE(three->registrations.size(), std::size_t(3));
        for (std::size_t camera : {0u, 1u, 2u}) {
            const FloorRegistration &expected = two->registrations[camera == 2 ? 1 : 0];
            QCOMPARE(three->registrations[camera].poseCovariance, expected.poseCovariance);
            QCOMPARE(three->registrations[camera].worldFromCamera.translation,
                     expected.worldFromCamera.translation);
        }
        const std::string words = "A and A again have the same pixels and count as one camera.";
        QVERIFY(contains(three->verdict.english(), words));
        QVERIFY(contains(three->registrations[1].verdict.english(), words));
        QCOMPARE(three->registrations[2].verdict, two->registrations[1].verdict);
        drawn.cameras.pop_back();
        const auto one = registerJointly(drawn.measured, drawn.cameras, tapeM);
        QVERIFY(!one && contains(one.error().message(), "1 registered camera, two are needed"));
    }
    void aMarkerMeasuredWronglyIsNamed()
    {
        std::mt19937 random(8);
        int named = 0;
        for (int i = 0; i < 30; ++i) {
            Draw drawn = draw(2, random);
            drawn.measured.markers[1].pointInWorld += Vector2d(0.023, 0);
            const auto joint = registerJointly(drawn.measured, drawn.cameras, 0.002);
            QVERIFY(joint.has_value());
            const bool isNamed = joint->caveats.size() == 1 &&
                                 joint->caveats[0].english().starts_with("U is ") &&
                                 contains(joint->caveats[0].english(), "mm off in all cameras: remeasure it");
            named += isNamed;
            if (!isNamed)
                qInfo("%s", joint->verdict.english().c_str());
            const auto marker = std::ranges::find(joint->markers, "U", &JointMarker::label);
            if (marker->isSuspicious)
                QVERIFY(std::abs(marker->offM.norm() - 0.023) < 0.02);
        }
        qInfo("named in %d of 30", named);
        QVERIFY(named >= 26);
    }
    void aPixelMarkedWronglyIsNamed()
    {
        std::mt19937 random(9);
        int named = 0;
        for (int i = 0; i < 30; ++i) {
            Draw drawn = draw(3, random);
            drawn.cameras[1].pixels[3].pixel += Vector2d(9, -8);
            const auto joint = registerJointly(drawn.measured, drawn.cameras, tapeM);
            QVERIFY(joint.has_value());
            named += joint->caveats.size() == 1 && joint->caveats[0].english().starts_with("B sees D 1");
        }
        qInfo("named in %d of 30", named);
        QVERIFY(named >= 27);
    }
    void pointsInNoLayoutHelp()
    {
        std::mt19937 random(10);
        std::normal_distribution<double> noise;
        double without = 0, with = 0, unused = 0;
        for (int i = 0; i < 120; ++i) {
            Draw drawn = draw(2, random);
            const auto plain = registerJointly(drawn.measured, drawn.cameras, tapeM);
            for (std::size_t camera = 0; camera < 2; ++camera) {
                int number = 0;
                for (double x = 0.4; x < 2.4; x += 0.6) {
                    for (double y = 0.4; y < 1.8; y += 0.6)
                        drawn.cameras[camera].pixels.push_back(
                            {"tile " + std::to_string(++number),
                             *truth()[camera].pixelFromWorld({x, y, 0}) +
                                 0.3 * Vector2d(noise(random), noise(random))});
                }
            }
            const auto helped = registerJointly(drawn.measured, drawn.cameras, tapeM);
            QVERIFY(plain && helped);
            QCOMPARE(helped->otherPoints.markers.size(), std::size_t(12));
            QCOMPARE(helped->markers.size(), std::size_t(6));
            for (std::size_t camera = 0; camera < 2; ++camera) {
                measure(plain->registrations[camera], truth()[camera], without, unused);
                measure(helped->registrations[camera], truth()[camera], with, unused);
            }
        }
        qInfo("other points bring the error to %.2f of what it is without", std::sqrt(with / without));
        QVERIFY(with < without);
    }
    void refusesWhatCannotBeJoined()
    {
        std::mt19937 random(11);
        Draw drawn = draw(2, random);
        QVERIFY(contains(registerJointly(drawn.measured, {drawn.cameras[0]}).error().message(),
                         "layout 'floor' has 1 registered camera, two are needed"));
        QVERIFY(contains(registerJointly(drawn.measured, drawn.cameras, 0).error().message(),
                         "tape measure is not above 0"));
        auto twice = drawn.cameras;
        twice[1].name = 'A';
        QVERIFY(
            contains(registerJointly(drawn.measured, twice).error().message(), "camera 'A' appears twice"));
        auto few = drawn.cameras;
        few[1].pixels.resize(2);
        QVERIFY(contains(registerJointly(drawn.measured, few).error().message(),
                         "camera 'B' sees only 2 of the markers"));
        auto apart = drawn.cameras;
        apart[0].pixels.erase(apart[0].pixels.begin() + 3, apart[0].pixels.end());
        apart[1].pixels.erase(apart[1].pixels.begin(), apart[1].pixels.begin() + 3);
        QVERIFY(contains(registerJointly(drawn.measured, apart).error().message(),
                         "no two of the cameras see the same marker"));
    }
};

ODOGRAPH_TEST(TestJointRegistration, QCoreApplication)
#include "tst_joint_registration.moc"
