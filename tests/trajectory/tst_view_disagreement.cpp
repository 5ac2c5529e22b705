// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/view_disagreement.h"

#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <QTest>
#include <cmath>

using namespace odo;
using namespace odo::test;

namespace {

/// On the floor itself, so that the height has no say.
const RobotShape flat{0.0, std::nullopt, std::nullopt};

struct Filmed
{
    std::vector<ViewTrack> views;
    Profile profile;
};

/// A figure eight seen by two cameras, the second of which believes to stand `shift` beside where it stands.
std::optional<Filmed> filmed(double noisePx, const Eigen::Vector2d &shift, double startS = 0)
{
    std::mt19937 random(5);
    FilmSettings settings;
    settings.noisePx = noisePx;
    settings.planeM = 0;
    const Course course = figureEight(0.8, 0.5, 8);
    Filmed result;
    result.views.push_back(film("A", cameraA(), course, settings, random));
    settings.startS = startS;
    result.views.push_back(film("B", cameraB(), course, settings, random));
    result.views[1].startOffset = Nanoseconds(0);
    RigidTransform moved = cameraB().worldFromCamera();
    moved.translation += Eigen::Vector3d(shift.x(), shift.y(), 0);
    result.views[1].floorView = FloorView(cameraB().camera(), moved, cameraB().poseCovariance());
    const auto profile = analyse(result.views, flat, {});
    if (!profile)
        return std::nullopt;
    result.profile = *profile;
    return result;
}

} // namespace

class TestViewDisagreement : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void noiseIsAsExpected()
    {
        const auto run = filmed(0.3, {0, 0});
        QVERIFY(run);
        const ViewDisagreement found = disagreementOf(run->profile, run->views, 0);
        // Of 300 frames a few at the ends are not seen by both at once.
        QVERIFY(found.positions.size() > 280);
        // √(1/2·300) = 4 %; interpolating the second view between frames takes nothing off here.
        QVERIFY2(std::abs(found.ratio() - 1) < 0.12, qPrintable(QString::number(found.ratio())));
        QVERIFY(found.medianM < found.rmsM && found.rmsM < found.largestM);
    }
    void aMovedCameraIsSeen()
    {
        const auto run = filmed(0.01, {0.010, 0});
        QVERIFY(run);
        const ViewDisagreement found = disagreementOf(run->profile, run->views, 0);
        QVERIFY2(std::abs(found.rmsM - 0.010) < 1e-4, qPrintable(QString::number(found.rmsM)));
        QVERIFY(std::abs(found.medianM - 0.010) < 1e-4);
        QVERIFY(found.ratio() > 5); // 0.1 px of an outline is stated at least: 1.5 mm
    }
    void aStepThatIsKnownBadlyIsExpected()
    {
        const auto run = filmed(0.01, {0, 0}, 0.03); // the second view is 30 ms late, and nobody knows
        QVERIFY(run);
        QVERIFY(disagreementOf(run->profile, run->views, 0).ratio() > 5);
        const double ratio = disagreementOf(run->profile, run->views, 0.03).ratio();
        QVERIFY2(std::abs(ratio - 1) < 0.05, qPrintable(QString::number(ratio)));
    }
    void oneViewDoesNotDisagree()
    {
        auto run = filmed(0.3, {0, 0});
        QVERIFY(run);
        run->views[1].floorView.reset();
        QVERIFY(disagreementOf(run->profile, run->views, 0).positions.empty());
        QCOMPARE(disagreementOf(run->profile, run->views, 0).ratio(), 0.0);
        QVERIFY(disagreementOf(Profile(), {}, 0).positions.empty());
    }
    void rejectedSamplesAreLeftOut()
    {
        auto run = filmed(0.3, {0, 0});
        QVERIFY(run);
        const std::size_t before = disagreementOf(run->profile, run->views, 0).positions.size();
        run->profile.samples[100].flags |= flagBit(SampleFlag::Jump);
        QCOMPARE(disagreementOf(run->profile, run->views, 0).positions.size(), before - 1);
    }
};

ODOGRAPH_TEST(TestViewDisagreement, QCoreApplication)
#include "tst_view_disagreement.moc"
