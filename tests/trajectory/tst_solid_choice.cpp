// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/trajectory/filmed_solid.h"

#include "core/trajectory/internal/body_direction.h"
#include "core/trajectory/internal/body_heading.h"
#include "core/trajectory/solid_choice.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <numbers>

using namespace odo;
using namespace odo::test;

namespace {

const RobotShape untold;

const Course eight = figureEight(0.9, 0.6, 7);

/// A buggy: wheels wide on the floor, a longer chassis above it, an upper part that sits to the rear.
SolidShape buggy()
{
    SolidShape shape;
    shape.form = SolidShape::Form::Levels;
    shape.levels = {SolidLevel{0.004, 0.05, 0.06, 0.09, 0.09}, SolidLevel{0.045, 0.10, 0.10, 0.07, 0.07},
                    SolidLevel{0.095, 0.03, 0.08, 0.05, 0.05}};
    shape.lengthM = 0.20;
    shape.widthM = 0.18;
    shape.topM = 0.095;
    return shape;
}

struct PositionErrors
{
    double rmsM = 0, insideShare = 0;
};

PositionErrors errorsOf(const std::vector<Sighting> &sightings)
{
    PositionErrors errors;
    double count = 0;
    for (const Sighting &sighting : sightings) {
        if (!sighting.seen)
            continue;
        const Eigen::Vector2d off = sighting.position.pointInWorld - eight(toSeconds(sighting.time)).position;
        const Eigen::Matrix2d covariance =
            sighting.position.pixelCovariance + sighting.position.calibrationCovariance;
        errors.rmsM += off.squaredNorm();
        errors.insideShare += off.dot(covariance.inverse() * off) < 5.991; // 95 % of two dimensions
        count += 1;
    }
    return {std::sqrt(errors.rmsM / count), errors.insideShare / count};
}

} // namespace

class TestSolidChoice : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aBuggyIsNoBox_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 6; ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }
    void aBuggyIsNoBox()
    {
        QFETCH(int, seed);
        std::mt19937 random{std::uint32_t(seed)};
        const std::vector<ViewTrack> views{filmSilhouette("A", cameraA(), buggy(), eight, 0.2, random),
                                           filmSilhouette("B", cameraB(), buggy(), eight, 0.2, random)};
        const auto solid = findSolid(views, untold);
        QVERIFY(solid.has_value());
        QCOMPARE(int(solid->shape.form), int(SolidShape::Form::Levels));
        // A tenth of the sizes: the levels that lie inside the hull of the others show nothing of themselves.
        QVERIFY2(std::abs(solid->shape.lengthM - 0.20) < 0.02 && std::abs(solid->shape.widthM - 0.18) < 0.02,
                 qPrintable(QStringLiteral("%1 %2").arg(solid->shape.lengthM).arg(solid->shape.widthM)));
        QVERIFY2(std::abs(solid->shape.topM - 0.095) < 0.012, qPrintable(QString::number(solid->shape.topM)));
        for (const auto &view : solid->seen) {
            const PositionErrors errors = errorsOf(view);
            // 0.2 px of noise are 0.6 mm a picture; twice that.
            QVERIFY2(errors.rmsM < 0.0012, qPrintable(QString::number(errors.rmsM)));
            QVERIFY2(errors.insideShare > 0.8, qPrintable(QString::number(errors.insideShare)));
        }
    }

    void aColouredPartIsMeasuredAsBefore()
    {
        std::mt19937 random(1);
        const std::vector<ViewTrack> views{filmSolid("A", cameraA(), buggy(), eight, 0.2, random),
                                           filmSolid("B", cameraB(), buggy(), eight, 0.2, random)};
        const auto solid = findSolid(views, untold);
        QVERIFY(!solid || solid->shape.form != SolidShape::Form::Levels);
    }

    void aBoxIsMeasuredAsOneOfLevels()
    {
        const SolidShape box{SolidShape::Form::Box, 0.26, 0.19, 0, 0.06};
        std::mt19937 random(4);
        const std::vector<ViewTrack> views{filmSilhouette("A", cameraA(), box, eight, 0.05, random),
                                           filmSilhouette("B", cameraB(), box, eight, 0.05, random)};
        const auto solid = findSolid(views, untold);
        QVERIFY(solid && std::abs(solid->shape.lengthM - 0.26) < 0.005 &&
                std::abs(solid->shape.widthM - 0.19) < 0.005);
        const PositionErrors errors = errorsOf(solid->seen.front());
        QVERIFY2(errors.rmsM < 0.002 && errors.insideShare > 0.9,
                 qPrintable(QStringLiteral("%1 %2").arg(errors.rmsM).arg(errors.insideShare)));
    }

    void whatNoSolidExplainsGivesNone()
    {
        const SolidShape box{SolidShape::Form::Box, 0.26, 0.19, 0, 0.06};
        std::mt19937 random(5);
        ViewTrack track = filmSolid("A", cameraA(), box, eight, 0.05, random);
        for (std::size_t i = 0; i < track.observations.size(); ++i)
            track.observations[i].ellipse.semiMajorPx *= i % 2 == 0 ? 1.6 : 0.8;
        QVERIFY(!findSolid({track}, untold));
    }

    void anotherPointOfItIsMeasured_data()
    {
        QTest::addColumn<int>("form");
        QTest::newRow("box") << 0;
        QTest::newRow("cylinder, whose motion tells its front") << 1;
        QTest::newRow("of several levels") << 2;
    }
    void anotherPointOfItIsMeasured()
    {
        QFETCH(int, form);
        const SolidShape shapes[] = {{SolidShape::Form::Box, 0.26, 0.19, 0, 0.06},
                                     {SolidShape::Form::Cylinder, 0.2, 0.2, 0, 0.06},
                                     buggy()};
        const Eigen::Vector2d reference(0.07, -0.03);
        RobotShape given;
        given.referenceM = reference;
        std::mt19937 random(8);
        const auto filmed = form == 2 ? filmSilhouette : filmSolid;
        const std::vector<ViewTrack> views{filmed("A", cameraA(), shapes[form], eight, 0.05, random),
                                           filmed("B", cameraB(), shapes[form], eight, 0.05, random)};
        const auto solid = findSolid(views, given);
        QVERIFY(solid.has_value());
        double squares = 0, count = 0;
        for (const Sighting &sighting : solid->seen.front()) {
            const Truth truth = eight(toSeconds(sighting.time));
            const Eigen::Vector2d wanted = truth.position + Eigen::Rotation2Dd(headingOf(truth)) * reference;
            squares += sighting.seen ? (sighting.position.pointInWorld - wanted).squaredNorm() : 0;
            count += sighting.seen;
        }
        const double rmsM = std::sqrt(squares / count);
        // 0.05 rad of heading are 4 mm
        QVERIFY2(count > 100 && rmsM < (form == 0 ? 0.002 : 0.006), qPrintable(QString::number(rmsM)));
    }

    void theFrontIsWhereItMovesTo()
    {
        const SolidShape box{SolidShape::Form::Box, 0.26, 0.12, 0, 0.06};
        std::mt19937 random(6);
        const std::vector<ViewTrack> views{filmSolid("A", cameraA(), box, eight, 0.05, random)};
        const auto axes = trackAxis(views, box);
        const auto seen = positionBody(views, box, axes);
        for (const auto &directions :
             {directedAxes(views, seen, axes), directionsOfMotion(views, seen, axes)}) {
            int wrong = 0;
            for (std::size_t i = 10; i + 10 < seen.front().size(); ++i) {
                const double truth = headingOf(eight(toSeconds(views.front().observations[i].time)));
                wrong += std::abs(std::remainder(directions.front()[i].angleRad - truth,
                                                 2 * std::numbers::pi)) > 0.2;
            }
            QVERIFY2(wrong < 5, qPrintable(QString::number(wrong)));
        }
    }

    void aRobotThatStandsHasNoDirectionOfMotion()
    {
        const SolidShape box{SolidShape::Form::Box, 0.26, 0.12, 0, 0.06};
        std::mt19937 random(7);
        const Course still = [](double) { return Truth{{0.3, 0.2}, {1e-9, 0}, {0, 0}}; };
        const std::vector<ViewTrack> views{filmSolid("A", cameraA(), box, still, 0.05, random)};
        const auto axes = trackAxis(views, box);
        const auto directions = directionsOfMotion(views, positionBody(views, box, axes), axes);
        for (const BodyAxis &axis : directions.front())
            QVERIFY(axis.sigmaRad > unknownAxisSigmaRad);
    }
};

ODOGRAPH_TEST(TestSolidChoice, QCoreApplication)
#include "tst_solid_choice.moc"
