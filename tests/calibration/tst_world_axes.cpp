// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/intrinsics_influence.h"
#include "core/calibration/world_axes.h"
#include "core/simulation/demo_testbed.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <random>

using namespace odo;
using Eigen::Vector2d;

namespace {

MarkerLayout layout()
{
    return {"floor", {{"O", {0, 0}}, {"U", {2.4, 0}}, {"V", {0, 1.8}}, {"D", {2.7, 2.0}}, {"E", {1.2, 0.7}}}};
}

bool refusedWith(const AxesChange &change, const char *words)
{
    const auto transform = axesTransformOf(layout(), change);
    if (transform)
        return false;
    const bool found = transform.error().message().find(words) != std::string::npos;
    if (!found)
        qWarning("told instead: %s", transform.error().message().c_str());
    return found;
}

} // namespace

class TestWorldAxes : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theOriginAndTheDirectionAreThoseAskedFor()
    {
        AxesChange change;
        change.originMarker = "D";
        change.xAlong = {{"D", "V"}};
        const MarkerLayout moved = transformed(layout(), *axesTransformOf(layout(), change));
        QVERIFY(moved.markers[3].pointInWorld.norm() < 1e-12);
        QVERIFY(std::abs(moved.markers[2].pointInWorld.y()) < 1e-12);
        QVERIFY(moved.markers[2].pointInWorld.x() > 0);
        // Right-handed still: O lies to the left of the way from D to V as it did.
        QVERIFY(moved.markers[0].pointInWorld.y() > 0);
    }
    void aPointAnAngleAndAUnit()
    {
        AxesChange change;
        change.lengthFactor = *lengthFactorFrom("inch");
        change.originM = Vector2d(1, 2);
        change.turnDegrees = 90;
        const auto transform = axesTransformOf(layout(), change);
        QVERIFY((*transform * Vector2d(1 / 25.4, 2 / 25.4)).norm() < 1e-12);
        // The new X runs along the old Y.
        QVERIFY((*transform * Vector2d(1 / 25.4, 3 / 25.4) - Vector2d(1, 0)).norm() < 1e-12);
        QVERIFY(!lengthFactorFrom("ell").has_value());
        QCOMPARE(*lengthFactorFrom("cm"), 10.0);
        QCOMPARE(*lengthFactorFrom("m"), 1000.0);
    }
    void reversingBothAxesIsAHalfTurn()
    {
        AxesChange change;
        change.reverseX = change.reverseY = true;
        const auto transform = axesTransformOf(layout(), change);
        QVERIFY((*transform * Vector2d(1, 2) - Vector2d(-1, -2)).norm() < 1e-12);
    }
    void whatCannotBeIsRefusedByName()
    {
        AxesChange mirrored;
        mirrored.reverseX = true;
        QVERIFY(refusedWith(mirrored, "reversing X alone would mirror the floor"));
        AxesChange unknown;
        unknown.originMarker = "Z";
        QVERIFY(refusedWith(unknown, "it has no marker Z; name one of O, U, V, D and E"));
        AxesChange both;
        both.originMarker = "O";
        both.originM = Vector2d(1, 1);
        QVERIFY(refusedWith(both, "both a marker and a point"));
        AxesChange directions;
        directions.turnDegrees = 3;
        directions.xAlong = {{"O", "U"}};
        QVERIFY(refusedWith(directions, "both an angle and a pair"));
        AxesChange same;
        same.xAlong = {{"O", "O"}};
        QVERIFY(refusedWith(same, "have the same position"));
        AxesChange nothing;
        nothing.lengthFactor = 0;
        QVERIFY(refusedWith(nothing, "is not possible"));
    }
    void aRegistrationIsCarriedAsIfItHadBeenMadeInTheNewAxes()
    {
        const FloorView truth = simulatedView({-0.9, -1.55, 2.0}, {1.2, 0.8, 0.0}, 1280, 720, 860);
        std::mt19937 random(3);
        std::normal_distribution<double> noise(0, 0.3);
        std::vector<MarkerPixel> pixels;
        for (const Marker &marker : layout().markers)
            pixels.push_back(
                {marker.label, *truth.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0}) +
                                   Vector2d(noise(random), noise(random))});
        AxesChange change;
        change.lengthFactor = 2;
        change.originMarker = "U";
        change.turnDegrees = 35;
        const auto transform = axesTransformOf(layout(), change);
        const auto before = registerFloor(layout(), pixels, truth.camera(), true);
        const auto anew = registerFloor(transformed(layout(), *transform), pixels, truth.camera(), true);
        QVERIFY(before && anew);
        const FloorRegistration carried = transformed(*before, *transform);
        QVERIFY((carried.worldFromCamera.translation - anew->worldFromCamera.translation).norm() < 1e-6);
        QVERIFY(carried.worldFromCamera.rotation.angularDistance(anew->worldFromCamera.rotation) < 1e-7);
        QVERIFY((carried.poseCovariance - anew->poseCovariance).norm() < 1e-4 * anew->poseCovariance.norm());
        QVERIFY(std::abs(carried.floorSigmaM - anew->floorSigmaM) < 1e-4 * anew->floorSigmaM);
        QVERIFY(std::abs(carried.rmsM - anew->rmsM) < 1e-5);
        QVERIFY(carried.verdict.english().find("all lengths multiplied by 2.0000") != std::string::npos);
    }
};

ODOGRAPH_TEST(TestWorldAxes, QCoreApplication)
#include "tst_world_axes.moc"
