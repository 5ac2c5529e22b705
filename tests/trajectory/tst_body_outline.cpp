// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/trajectory/filmed_solid.h"

#include "core/trajectory/internal/body_direction.h"
#include "core/trajectory/internal/floor_positions.h"
#include "core/trajectory/solid_choice.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <numbers>

using namespace odo;
using namespace odo::test;

namespace {

double turnBetween(double a, double b)
{
    const double turn = std::remainder(a - b, std::numbers::pi);
    return std::abs(turn);
}

const Course eight = figureEight(0.9, 0.6, 7);

} // namespace

class TestBodyOutline : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theAxisIsThatOfTheSolid()
    {
        const SolidShape box{SolidShape::Form::Box, 0.26, 0.19, 0, 0.06};
        std::mt19937 random(1);
        const ViewTrack track = filmSolid("A", cameraA(), box, eight, 0.02, random);
        for (std::size_t i = 0; i < track.observations.size(); i += 10) {
            const double truth = headingOf(eight(toSeconds(track.observations[i].time)));
            const auto misfit =
                OutlineMisfit::create(*track.floorView, box, outlineMoments(track.observations[i]));
            const auto axis = axisNear(*misfit, truth + 0.04);
            QVERIFY(axis.has_value());
            QVERIFY2(turnBetween(axis->angleRad, truth) < 0.02, qPrintable(QString::number(int(i))));
            QVERIFY(axis->sigmaRad < 0.4); // seen face on, the form hardly changes with a turn
        }
    }

    void aCylinderHasNoAxisAndOddOutlinesNone()
    {
        const SolidShape round{SolidShape::Form::Cylinder, 0.2, 0.2, 0, 0.1};
        const SolidShape box{SolidShape::Form::Box, 0.26, 0.19, 0, 0.06};
        std::mt19937 random(2);
        ViewTrack track = filmSolid("A", cameraA(), box, eight, 0.02, random);
        const auto none = trackAxis({track}, round);
        QVERIFY(none.front()[0].sigmaRad > unknownAxisSigmaRad);
        track.observations[0].ellipse.semiMajorPx *= 1.5; // merged with something
        const auto misfit =
            OutlineMisfit::create(*track.floorView, box, outlineMoments(track.observations[0]));
        QVERIFY(!axisNear(*misfit, headingOf(eight(0))));
    }

    void aMirroredFitIsOverruledByWhatLiesAround()
    {
        // Each time fits 0.3 and its mirror 0.9 alike, but for the first and the last.
        std::vector<AxisEvidence> evidence;
        for (int i = 0; i < 20; ++i) {
            AxisCosts costs;
            for (std::size_t bin = 0; bin < axisBins; ++bin) {
                const double a = (angleOfBin(bin) - 0.3) / 0.05, b = (angleOfBin(bin) - 0.9) / 0.05;
                const bool sure = i == 0 || i == 19;
                costs[bin] = static_cast<float>(sure ? a * a : std::min(a * a + 0.5, b * b));
            }
            evidence.push_back({i / 30.0, costs});
        }
        evidence[10].costs.reset();
        for (const std::size_t bin :
             likeliestPath(evidence.size(), [&](std::size_t i) { return evidence[i]; }))
            QVERIFY(std::abs(angleOfBin(bin) - 0.3) < 0.1);
    }

    void theAxisIsBridgedWhereOutlinesTellNothing()
    {
        const SolidShape box{SolidShape::Form::Box, 0.26, 0.19, 0, 0.06};
        std::mt19937 random(3);
        ViewTrack track = filmSolid("A", cameraA(), box, eight, 0.05, random);
        for (std::size_t i = 100; i < 110; ++i)
            track.observations[i].found = false;
        const auto axes = trackAxis({track}, box);
        QCOMPARE(axes.front().size(), track.observations.size());
        for (std::size_t i = 0; i < track.observations.size(); ++i) {
            const double truth = headingOf(eight(toSeconds(track.observations[i].time)));
            const double error = turnBetween(axes.front()[i].angleRad, truth);
            QVERIFY2(error < 0.08, qPrintable(QStringLiteral("frame %1: %2 rad").arg(i).arg(error)));
        }
    }

    void withoutASightingNothingIsKnownOfTheAxis()
    {
        const SolidShape box{SolidShape::Form::Box, 0.26, 0.19, 0, 0.06};
        std::mt19937 random(4);
        ViewTrack track = filmSolid("A", cameraA(), box, eight, 0.05, random);
        for (Observation &observation : track.observations)
            observation.found = false;
        const auto axes = trackAxis({track}, box);
        for (const BodyAxis &axis : axes.front())
            QVERIFY(axis.sigmaRad > unknownAxisSigmaRad);
    }

    void theFootprintsCentreIsFound()
    {
        const SolidShape box{SolidShape::Form::Box, 0.26, 0.19, 0, 0.2};
        std::mt19937 random(5);
        const ViewTrack track = filmSolid("A", cameraA(), box, eight, 1e-6, random);
        const auto axes = trackAxis({track}, box);
        const auto sightings = positionBody({track}, box, axes).front();
        double squares = 0, worst = 0;
        for (std::size_t i = 0; i < sightings.size(); ++i) {
            const double error =
                (sightings[i].position.pointInWorld - eight(toSeconds(sightings[i].time)).position).norm();
            squares += error * error / static_cast<double>(sightings.size());
            worst = std::max(worst, error);
        }
        QVERIFY2(std::sqrt(squares) < 0.0005, qPrintable(QString::number(std::sqrt(squares))));
        // Seen face on, a turn by a few degrees to either side looks alike for a frame.
        QVERIFY2(worst < 0.005, qPrintable(QString::number(worst)));
        // Half the height alone leaves millimetres.
        double plain = 0;
        for (const Sighting &sighting : positionObservations(track, 0.1))
            plain = std::max(
                plain, (sighting.position.pointInWorld - eight(toSeconds(sighting.time)).position).norm());
        QVERIFY(plain > 0.004);
    }

    void anOutlineOfOddSizeLosesItsScore()
    {
        const SolidShape box{SolidShape::Form::Box, 0.26, 0.19, 0, 0.06};
        std::mt19937 random(6);
        ViewTrack track = filmSolid("A", cameraA(), box, eight, 0.05, random);
        track.observations[50].areaPx *= 0.8;
        const auto sightings = positionBody({track}, box, trackAxis({track}, box)).front();
        QCOMPARE(sightings[50].score, 0.0);
        QVERIFY(sightings[49].score > 0.5);
        QVERIFY(sightings[51].score > 0.5);
    }

    void aViewThatMostlySeesAPartIsNotTheRule()
    {
        const SolidShape box{SolidShape::Form::Box, 0.26, 0.19, 0, 0.06};
        std::mt19937 random(6);
        const ViewTrack whole = filmSolid("A", cameraA(), box, eight, 0.05, random);
        ViewTrack covered = filmSolid("B", cameraB(), box, eight, 0.05, random);
        for (std::size_t i = 0; i < 200; ++i)
            covered.observations[i].areaPx *= 0.7;
        const std::vector<ViewTrack> views{whole, covered};
        const auto sightings = positionBody(views, box, trackAxis(views, box));
        QCOMPARE(sightings[1][100].score, 0.0);
        QVERIFY(sightings[1][250].score > 0.5);
        QVERIFY(sightings[0][100].score > 0.5);
    }

    void theShapeIsEstimated_data()
    {
        QTest::addColumn<bool>("round");
        QTest::addColumn<double>("base");
        QTest::addColumn<bool>("givesHeight");
        QTest::addColumn<bool>("hasGivenSize");
        QTest::addColumn<bool>("oneView");
        QTest::newRow("box, all told") << false << 0.0 << true << true << false;
        QTest::newRow("box, size told") << false << 0.0 << false << true << false;
        QTest::newRow("box, height told") << false << 0.0 << true << false << false;
        QTest::newRow("box, nothing told") << false << 0.0 << false << false << false;
        QTest::newRow("box, nothing told, one view") << false << 0.0 << false << false << true;
        QTest::newRow("plate, all told") << false << 0.12 << true << true << false;
        QTest::newRow("plate, nothing told") << false << 0.12 << false << false << false;
        QTest::newRow("box on low wheels, all told") << false << 0.004 << true << true << false;
        QTest::newRow("box on low wheels, nothing told") << false << 0.004 << false << false << false;
        QTest::newRow("box on wheels, height told, one view") << false << 0.008 << true << false << true;
        QTest::newRow("cylinder on wheels, nothing told") << true << 0.008 << false << false << false;
        QTest::newRow("cylinder, nothing told") << true << 0.0 << false << false << false;
    }

    void theShapeIsEstimated()
    {
        QFETCH(bool, round);
        QFETCH(double, base);
        QFETCH(bool, givesHeight);
        QFETCH(bool, hasGivenSize);
        QFETCH(bool, oneView);
        const SolidShape shape{round ? SolidShape::Form::Cylinder : SolidShape::Form::Box, 0.24,
                               round ? 0.24 : 0.16, base, 0.12};
        std::mt19937 random(7);
        std::vector<ViewTrack> views{filmSolid("A", cameraA(), shape, eight, 0.05, random)};
        if (!oneView)
            views.push_back(filmSolid("B", cameraB(), shape, eight, 0.05, random));
        RobotShape given;
        if (givesHeight)
            given.heightM = 0.12;
        if (hasGivenSize) {
            given.lengthM = 0.24;
            given.widthM = shape.widthM;
        }
        const auto estimate = estimateShape(views, given);
        QVERIFY(estimate.has_value());
        QCOMPARE(estimate->heightEstimated, !givesHeight);
        QCOMPARE(int(estimate->shape.form), int(shape.form));
        // 0.05 px of noise on axes of 30 px, over 30 times: tenths of a millimetre; one view is weaker.
        const double bound = oneView ? 0.006 : 0.003;
        QVERIFY2(std::abs(estimate->shape.topM - 0.12) < bound,
                 qPrintable(QString::number(estimate->shape.topM)));
        QVERIFY(std::abs(estimate->shape.lengthM - 0.24) < bound);
        QVERIFY(std::abs(estimate->shape.baseM - base) < bound);
        QVERIFY(estimate->misfit < 1);
        if (!givesHeight)
            QVERIFY(std::abs(estimate->shape.topM - 0.12) < 4 * estimate->sigmaTopM);
    }

    /// One view cannot tell a low robot from a higher one whose body begins above the floor: what it leaves
    /// open is doubt.
    void whatOneViewLeavesOpenIsDoubted_data()
    {
        QTest::addColumn<double>("base");
        for (const double base : {0.0, 0.008, 0.02})
            QTest::addRow("%g m", base) << base;
    }
    void whatOneViewLeavesOpenIsDoubted()
    {
        QFETCH(double, base);
        const SolidShape shape{SolidShape::Form::Box, 0.24, 0.16, base, 0.12};
        std::mt19937 random(9);
        const auto estimate = estimateShape({filmSolid("A", cameraA(), shape, eight, 0.05, random)}, {});
        QVERIFY(estimate.has_value());
        const double off = std::abs(middleHeightM(estimate->shape) - middleHeightM(shape));
        QVERIFY2(off < 3 * estimate->sigmaMiddleM,
                 qPrintable(QStringLiteral("%1 at %2").arg(off).arg(estimate->sigmaMiddleM)));
        QVERIFY2(estimate->sigmaMiddleM < 0.03, qPrintable(QString::number(estimate->sigmaMiddleM)));
    }

    void tooFewOrImpossibleOutlinesGiveNoShape()
    {
        const SolidShape box{SolidShape::Form::Box, 0.26, 0.19, 0, 0.06};
        std::mt19937 random(8);
        ViewTrack track = filmSolid("A", cameraA(), box, eight, 0.05, random);
        ViewTrack few = track;
        few.observations.resize(4);
        QVERIFY(!estimateShape({few}, {}));
        for (std::size_t i = 0; i < track.observations.size(); ++i)
            track.observations[i].ellipse.semiMajorPx *= i % 2 == 0 ? 1.6 : 0.8; // no solid does that
        const auto estimate = estimateShape({track}, {});
        QVERIFY(!estimate || estimate->misfit > worstShapeMisfit);
    }
};

ODOGRAPH_TEST(TestBodyOutline, QCoreApplication)
#include "tst_body_outline.moc"
