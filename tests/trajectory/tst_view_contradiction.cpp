// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/view_contradiction.h"

#include "core/trajectory/internal/contradiction_model.h"
#include "core/trajectory/internal/height_estimation.h"
#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr double planeM = 0.03;

/// Two views of a figure eight, registered with what a registration leaves open.
std::vector<ViewTrack> twoViews(unsigned seed)
{
    Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
    covariance.diagonal() << Eigen::Vector3d::Constant(1e-8), Eigen::Vector3d::Constant(9e-8);
    const FloorView a = cameraLookingAt({-2.2, -2.6, 2}, {0, 0, 0}, covariance),
                    b = cameraLookingAt({2.6, -2.2, 2}, {0, 0, 0}, covariance);
    std::mt19937 random(seed);
    FilmSettings settings;
    settings.noisePx = 0.1;
    const Course course = figureEight(1, 0.5, 8);
    return {film("A", a, course, settings, random), film("B", b, course, settings, random)};
}

std::vector<std::vector<Sighting>> sightingsOf(const std::vector<ViewTrack> &views)
{
    std::vector<Nanoseconds> times;
    for (const Observation &one : views.front().observations)
        times.push_back(timeOf(views.front(), one));
    return viewFromAllSides(views, times, planeM);
}

std::optional<ExplainedContradiction> explained(const std::vector<ViewTrack> &views)
{
    auto sightings = sightingsOf(views);
    return explainContradiction(views, sightings, {planeM, 0.0005, true});
}

FloorView turnedBy(const FloorView &view, double angleRad)
{
    RigidTransform pose = view.worldFromCamera();
    pose.rotation = Eigen::AngleAxisd(angleRad, Eigen::Vector3d::UnitX()) * pose.rotation;
    return {view.camera(), pose, view.poseCovariance()};
}

} // namespace

class TestViewContradiction : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void viewsThatAgreeAreLeftAlone()
    {
        for (unsigned seed = 1; seed <= 10; ++seed) {
            const std::vector<ViewTrack> views = twoViews(seed);
            QVERIFY(!explained(views));
            QVERIFY(!exchangedViews(views, sightingsOf(views), planeM));
        }
    }

    void aTurnedCameraIsNamedAndHeld()
    {
        std::vector<ViewTrack> views = twoViews(1);
        views[1].floorView = turnedBy(*views[1].floorView, 0.004);
        const auto found = explained(views);
        QVERIFY(found && !found->contradiction.causes.empty());
        const ContradictionCause &cause = found->contradiction.causes.front();
        QVERIFY(cause.kind == ContradictionCause::Kind::CameraMoved && cause.view == 1 && !cause.since);
        QVERIFY2(cause.size > 2.5 && cause.size < 4.5, qPrintable(QString::number(cause.size)));

        auto sightings = sightingsOf(views);
        const double before = sightings[0][100].position.calibrationCovariance.trace();
        QVERIFY(explainContradiction(views, sightings, {planeM, 0.0005, true}));
        QVERIFY(sightings[0][100].position.calibrationCovariance.trace() > 4 * before);
    }

    void aWrongOffsetIsNamed()
    {
        std::vector<ViewTrack> views = twoViews(1);
        views[1].startOffset += std::chrono::milliseconds(40);
        const auto found = explained(views);
        QVERIFY(found && !found->contradiction.causes.empty());
        const ContradictionCause &cause = found->contradiction.causes.front();
        QVERIFY(cause.kind == ContradictionCause::Kind::Offset);
        QVERIFY2(std::abs(cause.size - 0.04) < 0.002, qPrintable(QString::number(cause.size)));
    }

    void exchangedVideosAreFound()
    {
        std::vector<ViewTrack> views = twoViews(1);
        std::swap(views[0].floorView, views[1].floorView);
        QVERIFY(exchangedViews(views, sightingsOf(views), planeM) ==
                std::pair(std::size_t(0), std::size_t(1)));
        views[1].floorView.reset();
        QVERIFY(!exchangedViews(views, sightingsOf(views), planeM));
    }

    void withoutCommonTimesNothingIsSaid()
    {
        std::vector<ViewTrack> views = twoViews(1);
        for (Observation &one : views[1].observations)
            one.found = false;
        QVERIFY(!explained(views));
        QVERIFY(!likelyCorrection({views[0]}, {sightingsOf(views)[0]}, {planeM, 0.0005, true}, 5));
    }
};

ODOGRAPH_TEST(TestViewContradiction, QCoreApplication)
#include "tst_view_contradiction.moc"
