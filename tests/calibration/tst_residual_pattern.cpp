// SPDX-License-Identifier: GPL-3.0-or-later
// Residuals that follow a pattern are named, and chance is not.
#include "core/calibration/floor_registration.h"
#include "tests/calibration/floor_set_ups.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr double noisePx = 0.3, tapeM = 0.0005;

struct Drawn
{
    FloorView truth;
    MarkedFloor floor;
};

Drawn drawn(std::size_t markers, std::mt19937 &random)
{
    const FloorView truth = drawnFloorView(drawnLens(LensKind::Webcam, random), random);
    return {truth, MarkedFloor(truth, Arrangement::AllRound, markers, tapeM, noisePx, random)};
}

bool isGood(const FloorRegistration &registration)
{
    return contains(registration.verdict.english(), "Good:");
}

} // namespace

class TestResidualPattern : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void chanceIsNoPattern()
    {
        std::mt19937 random(1);
        int named = 0;
        for (int draw = 0; draw < 200; ++draw) {
            const Drawn one = drawn(draw % 2 == 0 ? 12 : 30, random);
            for (const bool known : {true, false}) {
                const auto registration =
                    registerFloor(one.floor.layout, one.floor.pixels,
                                  known ? one.truth.camera() : CameraModel::assumed(1280, 720), known);
                QVERIFY(registration.has_value());
                named += registration->residualPattern != ResidualPattern::None ? 1 : 0;
            }
        }
        QVERIFY2(named <= 1, qPrintable(QString::number(named)));
    }

    /// Of twenty draws, since a far camera shows little of it.
    void aWrongLensIsNamed()
    {
        std::mt19937 random(2);
        int named = 0, silent = 0;
        for (int draw = 0; draw < 20; ++draw) {
            const Drawn one = drawn(20, random);
            Intrinsics wrong = one.truth.camera().intrinsics();
            wrong.distortion[0] += 0.08;
            const auto registration =
                registerFloor(one.floor.layout, one.floor.pixels, CameraModel::create(wrong).value(), true);
            QVERIFY(registration.has_value());
            const bool isNamed = contains(registration->verdict.english(), "The residuals follow the lens");
            QCOMPARE(isNamed, registration->residualPattern == ResidualPattern::Intrinsics);
            named += isNamed ? 1 : 0;
            silent += isGood(*registration) && registration->rmsPx > 1 ? 1 : 0;
        }
        QVERIFY2(named >= 16, qPrintable(QString::number(named)));
        QCOMPARE(silent, 0);
    }

    void aLayoutWithOneSideStretchedIsNamed()
    {
        std::mt19937 random(3);
        int named = 0, silent = 0;
        for (int draw = 0; draw < 20; ++draw) {
            Drawn one = drawn(16, random);
            for (Marker &marker : one.floor.layout.markers)
                marker.pointInWorld.x() *= 1.03;
            const auto registration =
                registerFloor(one.floor.layout, one.floor.pixels, one.truth.camera(), true);
            QVERIFY(registration.has_value());
            named += registration->residualPattern == ResidualPattern::Layout ? 1 : 0;
            silent += isGood(*registration) ? 1 : 0;
        }
        QVERIFY2(named >= 16, qPrintable(QString::number(named)));
        QCOMPARE(silent, 0);
    }

    void oneWrongMarkerIsNamed()
    {
        std::mt19937 random(4);
        int named = 0;
        for (int draw = 0; draw < 20; ++draw) {
            Drawn one = drawn(12, random);
            one.floor.layout.markers[5].pointInWorld += Eigen::Vector2d(0.024, 0.018);
            const auto registration =
                registerFloor(one.floor.layout, one.floor.pixels, one.truth.camera(), true);
            QVERIFY(registration.has_value());
            named += contains(registration->verdict.english(), "Marker m5 is ") ? 1 : 0;
        }
        QVERIFY2(named >= 18, qPrintable(QString::number(named)));
    }

    void tooFewMarkersAreNotJudged()
    {
        std::mt19937 random(5);
        Drawn one = drawn(6, random);
        one.floor.layout.markers[5].pointInWorld.x() += 0.01;
        const auto registration = registerFloor(one.floor.layout, one.floor.pixels, one.truth.camera(), true);
        QVERIFY(registration.has_value());
        QCOMPARE(registration->residualPattern, ResidualPattern::None);
    }
};

ODOGRAPH_TEST(TestResidualPattern, QCoreApplication)
#include "tst_residual_pattern.moc"
