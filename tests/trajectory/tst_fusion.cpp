// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/fused_track.h"
#include "core/trajectory/internal/height_estimation.h"
#include "core/trajectory/internal/view_alignment.h"

#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <Eigen/Cholesky>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

FloorPosition position(double x, double y, double sx, double sy, double common = 0)
{
    FloorPosition position;
    position.pointInWorld = {x, y};
    position.pixelCovariance = Eigen::Vector2d(sx * sx, sy * sy).asDiagonal();
    position.calibrationCovariance = Eigen::Matrix2d::Identity() * common * common;
    position.displacementPerMetreHeight = {1, 0};
    return position;
}

std::vector<Sighting> sightings(const std::vector<double> &times, const std::function<double(double)> &x)
{
    std::vector<Sighting> all;
    for (const double t : times) {
        Sighting sighting;
        sighting.time = fromSeconds(t);
        sighting.seen = true;
        sighting.score = 1;
        sighting.position = position(x(t), 0, 0.002, 0.002);
        all.push_back(sighting);
    }
    return all;
}

std::vector<Nanoseconds> at(const std::vector<double> &times)
{
    std::vector<Nanoseconds> all;
    for (const double t : times)
        all.push_back(fromSeconds(t));
    return all;
}

std::vector<std::vector<Sighting>> lookAtZero(const std::vector<ViewTrack> &views)
{
    std::vector<Nanoseconds> times;
    for (const Observation &observation : views[0].observations)
        times.push_back(observation.time);
    std::vector<std::vector<Sighting>> all;
    for (const ViewTrack &view : views)
        all.push_back(sightingsAt(times, positionObservations(view, 0)));
    return all;
}

} // namespace

class TestFusion : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// Once, also where nothing is used for long just there.
    void tracksAreCutAtBreaks()
    {
        std::vector<Sample> samples(12);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            samples[i].time = std::chrono::milliseconds(100 * i + (i < 8 ? 0 : 5000));
            samples[i].position = Eigen::Vector2d(0.1 * double(i), 0);
        }
        samples[4].isAfterBreak = samples[8].isAfterBreak = true; // the second one behind the gap
        const auto segments = cutIntoSegments(samples, std::chrono::seconds(1));
        QCOMPARE(segments.size(), std::size_t(3));
        for (const TrackSegment &segment : segments)
            QCOMPARE(segment.nodes.size(), std::size_t(4));
    }

    void twoGaussiansInClosedForm()
    {
        // x: σ 1 and 2 mm → weights 4:1; y: 2 and 1 mm → 1:4; variance 1/(1/1 + 1/4) = 0.8 mm².
        const std::vector<ViewPosition> both{{0, position(0, 0, 0.001, 0.002)},
                                             {2, position(0.005, 0.005, 0.002, 0.001)}};
        const FusedPosition fused = fuse(both);
        QVERIFY((fused.position - Eigen::Vector2d(0.001, 0.004)).norm() < 1e-12);
        QVERIFY((fused.covariance - Eigen::Matrix2d::Identity() * 0.8e-6).norm() < 1e-15);
        QVERIFY(fused.commonCovariance.isZero());
        QCOMPARE(fused.views, 5u);
        QVERIFY(std::abs(largestDistance(both) - std::hypot(0.005, 0.005)) < 1e-12);
    }

    void covarianceAgreesWithMonteCarlo()
    {
        // Three views with slanted covariances; noise of pixels and of calibrations drawn apart.
        std::mt19937 random(9);
        std::normal_distribution<double> noise(0, 1);
        std::vector<ViewPosition> views;
        for (std::uint32_t v = 0; v < 3; ++v) {
            const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.9 * v + 0.2).toRotationMatrix();
            FloorPosition place = position(1, 2, 0.001, 0.004, 0.002 + 0.001 * v);
            place.pixelCovariance = turn * place.pixelCovariance * turn.transpose();
            views.push_back({v, place});
        }
        const FusedPosition stated = fuse(views);
        Eigen::Matrix2d fromPixels = Eigen::Matrix2d::Zero(), fromCalibration = Eigen::Matrix2d::Zero();
        constexpr int draws = 20000;
        for (int i = 0; i < draws; ++i) {
            for (const bool pixels : {true, false}) {
                auto drawn = views;
                for (ViewPosition &view : drawn) {
                    const Eigen::Matrix2d covariance =
                        pixels ? view.position.pixelCovariance : view.position.calibrationCovariance;
                    view.position.pointInWorld +=
                        covariance.llt().matrixL() * Eigen::Vector2d(noise(random), noise(random));
                }
                const Eigen::Vector2d error = fuse(drawn).position - stated.position;
                (pixels ? fromPixels : fromCalibration) += error * error.transpose() / draws;
            }
        }
        // 20000 draws leave 1 % on a variance.
        QVERIFY((fromPixels - stated.covariance).norm() < 0.04 * fromPixels.norm());
        QVERIFY((fromCalibration - stated.commonCovariance).norm() < 0.04 * fromCalibration.norm());
    }

    void theCommonPartIsKeptApart()
    {
        // Equal views: each part is halved, and neither leaks into the other.
        const std::vector<ViewPosition> both{{0, position(0, 0, 0.001, 0.001, 0.003)},
                                             {1, position(0, 0, 0.001, 0.001, 0.003)}};
        const FusedPosition fused = fuse(both);
        QVERIFY((fused.covariance - Eigen::Matrix2d::Identity() * 0.5e-6).norm() < 1e-15);
        QVERIFY((fused.commonCovariance - Eigen::Matrix2d::Identity() * 4.5e-6).norm() < 1e-15);
        QVERIFY((fused.displacementPerMetreHeight - Eigen::Vector2d(1, 0)).norm() < 1e-12);
    }

    void whatAllOutlinesShareIsCommon()
    {
        // Straight down from 2 m, 1000 px: a pixel is 2 mm. Of the outline 0.05 px last through the run.
        Intrinsics lens{1280, 720, 1000, 1000, 640, 360, LensModel::Standard, {0, 0, 0, 0, 0}, {}};
        ViewTrack view;
        view.floorView =
            FloorView(*CameraModel::create(lens), {Eigen::Quaterniond(0, 1, 0, 0), Eigen::Vector3d(0, 0, 2)},
                      Eigen::Matrix<double, 6, 6>::Zero());
        Observation observation;
        observation.found = true;
        observation.ellipse.centrePx = {700, 300};
        observation.centreCovariancePx2 = Eigen::Matrix2d::Identity() * 0.04 * 0.04;
        view.observations = {observation};
        const Sighting sighting = positionObservations(view, 0).front();
        QVERIFY(sighting.seen);
        const double expected = std::pow(0.05 * 0.002, 2);
        QVERIFY((sighting.position.calibrationCovariance - Eigen::Matrix2d::Identity() * expected).norm() <
                1e-6 * expected);
        // And two pixels along x where a shadow may be a part of it.
        view.observations.front().lastingCovariancePx2(0, 0) = 4;
        const Sighting ambiguous = positionObservations(view, 0).front();
        const double variance = std::pow(2 * 0.002, 2);
        QVERIFY(std::abs(ambiguous.lastingCovariance(0, 0) - variance) < 1e-6 * variance);
        QVERIFY(std::abs(ambiguous.lastingCovariance(1, 1)) < 1e-6 * variance);
        QVERIFY(ambiguous.position.calibrationCovariance == sighting.position.calibrationCovariance);
    }
    void anOffsetIsLedOnAsFarAsItsCauseReaches()
    {
        // A camera whose turn about the vertical is all that is not known: at a place it errs across the ray,
        // by as much as the place is far.
        Intrinsics lens{1280, 720, 1000, 1000, 640, 360, LensModel::Standard, {0, 0, 0, 0, 0}, {}};
        Eigen::Matrix<double, 6, 6> pose = 1e-12 * Eigen::Matrix<double, 6, 6>::Identity();
        pose(2, 2) = 1e-6;
        ViewTrack known, other;
        known.floorView = FloorView(*CameraModel::create(lens),
                                    {Eigen::Quaterniond(0, 1, 0, 0), Eigen::Vector3d(0, 0, 2)}, pose);
        const Eigen::Vector2d near(1, 0), far(2, 0), offset(0, 0.003);
        FusedTrack track;
        std::vector<std::vector<Sighting>> views(2);
        for (int i = 0; i < 30; ++i) {
            const bool joined = i < 20;
            Sample sample;
            sample.time = fromSeconds(i / 30.0);
            sample.position = joined ? near : Eigen::Vector2d((i < 25 ? near : far) + offset);
            sample.views = joined ? 3 : 1;
            track.samples.push_back(sample);
            Sighting sighting;
            sighting.seen = true;
            sighting.position.pointInWorld = near + offset;
            views[0].push_back(sighting);
            views[1].emplace_back();
        }
        alignSingleViews(track, views, {known, other});
        QVERIFY((*track.samples[22].position - near).norm() < 1e-4);
        QVERIFY((*track.samples[28].position - (far + offset - 2 * offset)).norm() < 2e-4);
    }
    void theGateStandsASteadyDisagreement()
    {
        // 20 mm apart all the time is bad calibration; 120 mm once is a false sighting.
        auto a = sightings({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, [](double) { return 0; });
        auto b = sightings({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, [](double) { return 0.02; });
        const AgreementGate gate({a, b});
        QVERIFY(gate.agree({0, a[3].position}, {1, b[3].position}));
        QVERIFY(!gate.agree({0, a[3].position}, {1, position(0.12, 0, 0.002, 0.002)}));
        // Without such a history 20 mm are too much already.
        QVERIFY(!AgreementGate({a, a}).agree({0, a[3].position}, {1, b[3].position}));
        const std::vector<ViewPosition> three{
            {0, a[3].position}, {1, position(0.12, 0, 0.002, 0.002)}, {2, a[3].position}};
        const auto group = gate.largestAgreeingGroup(three);
        QCOMPARE(group.size(), std::size_t(2));
        QCOMPARE(group[1].view, 2u);
    }

    void interpolationIsExactForACubic()
    {
        const auto cubic = [](double t) { return 1 + t - 2 * t * t + 5 * t * t * t; };
        const auto view = sightings({0, 0.03, 0.07, 0.1, 0.13, 0.17}, cubic);
        for (const Sighting &sighting : sightingsAt(at({0.04, 0.05, 0.09, 0.12}), view)) {
            QVERIFY(sighting.seen);
            QVERIFY(std::abs(sighting.position.pointInWorld.x() - cubic(toSeconds(sighting.time))) < 1e-9);
            QVERIFY(std::abs(sighting.position.pixelCovariance(0, 0) - 4e-6) < 1e-12);
        }
    }

    void interpolationEndsAtGapsAndEnds()
    {
        const auto line = [](double t) { return t; };
        auto view = sightings({0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}, line);
        view[2].seen = false;
        view[5].seen = view[6].seen = false;
        const auto found = sightingsAt(at({-0.05, 0.0, 0.05, 0.15, 0.2, 0.45, 0.55, 0.65, 0.75, 0.85}), view);
        const std::vector<bool> expected{false, true, true, true, false, false, false, false, true, false};
        for (std::size_t i = 0; i < found.size(); ++i)
            QVERIFY2(found[i].seen == expected[i], qPrintable(QString::number(i)));
        QVERIFY(std::abs(found[3].position.pointInWorld.x() - 0.15) < 1e-9);
        QVERIFY(sightingsAt(at({1.0}), {}).front().seen == false);
    }

    void aSlowerViewIsWidened()
    {
        // Ten frames a second asked for thirty times a second: a third of the information each.
        std::vector<double> slow, fast;
        for (int i = 0; i < 20; ++i)
            slow.push_back(i * 0.1);
        for (int i = 1; i < 55; ++i)
            fast.push_back(i / 30.0);
        const auto found = sightingsAt(at(fast), sightings(slow, [](double t) { return t; }));
        QVERIFY(std::abs(found[20].position.pixelCovariance(0, 0) - 3 * 4e-6) < 1e-7);
    }

    void heightFromTwoViews()
    {
        std::mt19937 random(1);
        for (const double plane : {0.0, 0.03, 0.11}) {
            FilmSettings settings;
            settings.planeM = plane;
            const Course course = figureEight(1, 0.7, 8);
            auto a = film("A", cameraA(), course, settings, random);
            const auto b = film("B", cameraB(), course, settings, random);
            for (std::size_t i = 10; i < 40; ++i) // false sightings must not move it
                a.observations[i].ellipse.centrePx.x() += 100;
            const auto estimate = estimatePlane(lookAtZero({a, b}));
            QVERIFY(estimate.has_value());
            QVERIFY2(std::abs(estimate->planeM - plane) < std::max(4 * estimate->sigmaM, 2e-4),
                     qPrintable(QString::number(estimate->planeM)));
            QVERIFY(estimate->sigmaM < 0.001);
        }
    }

    void heightNeedsParallax()
    {
        std::mt19937 random(2);
        const Course course = figureEight(1, 0.7, 8);
        const auto a = film("A", cameraA(), course, {}, random);
        const auto same = film("B", cameraA(), course, {}, random);
        QVERIFY(!estimatePlane(lookAtZero({a, same})));
        QVERIFY(!estimatePlane(lookAtZero({a})));
        QVERIFY(!estimatePlane({}));
    }
};

ODOGRAPH_TEST(TestFusion, QCoreApplication)
#include "tst_fusion.moc"
