// SPDX-License-Identifier: GPL-3.0-or-later
// A run in axes of its own: it begins at the origin in direction X, and is the same run.
#include "core/exchange/track_frame.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace odo;

namespace {

constexpr double direction = 2.2; ///< in which the run begins, radians

/// Three points: unknown, at (1, 2) with 1 m/s, and 0.5 m further.
Profile example()
{
    const Eigen::Vector2d ahead(std::cos(direction), std::sin(direction));
    Profile profile;
    for (int i = 0; i < 3; ++i) {
        Sample sample;
        sample.time = Nanoseconds((i + 1) * 500'000'000LL);
        sample.position = Eigen::Vector2d(1, 2) + 0.5 * (i - 1) * ahead;
        sample.covariance << 4e-6, 0, 0, 1e-6;
        sample.heading = MeasuredHeading{direction + 0.1, 0.01, 0};
        ProfilePoint point;
        point.position = *sample.position;
        point.velocity = ahead;
        point.acceleration = {-ahead.y(), ahead.x()};
        point.speedMps = 1;
        point.sigmaSpeedMps = point.sigmaAccelMps2 = 0.01;
        point.sigmaXM = 0.002;
        point.sigmaYM = 0.001;
        point.valid = i > 0;
        point.body = BodyHeading{direction + 0.1, 0.01, 0, 0.01};
        profile.samples.push_back(sample);
        profile.points.push_back(point);
    }
    profile.spikes = {{2, profile.samples[2].time, 0, foreignWords("jump")}};
    profile.metrics = {{"max_speed", "m/s", 1, 0.01}};
    return profile;
}

bool near(double a, double b)
{
    return std::abs(a - b) < 1e-12;
}

} // namespace

class TestTrackFrame : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void beginsAtTheOriginInDirectionX()
    {
        const Profile run = inFrame(example(), TrackFrame::Start);
        const ProfilePoint &first = run.points[1], &last = run.points[2];
        QVERIFY(first.position.norm() < 1e-12);
        QVERIFY(near(last.position.x(), 0.5) && near(last.position.y(), 0));
        QVERIFY(near(last.velocity.x(), 1) && near(last.velocity.y(), 0));
        QVERIFY(near(last.acceleration.x(), 0) && near(last.acceleration.y(), 1)); // to the left
        QVERIFY(near(last.body->radians, 0.1));
        QVERIFY(near(run.samples[2].heading->radians, 0.1));
        QVERIFY(near(run.samples[2].position->x(), 0.5));
        QCOMPARE(run.samples[1].time.count(), std::int64_t(0));
        QCOMPARE(run.samples[0].time.count(), std::int64_t(-500'000'000)); // it is before the start
        QCOMPARE(run.spikes.front().time.count(), std::int64_t(500'000'000));
        QCOMPARE(run.metrics.front().value, 1.0);
    }

    /// σ along the new axes: that of a vector is the same in all directions together.
    void uncertaintyIsTurned()
    {
        const Profile run = inFrame(example(), TrackFrame::Start);
        const double cosine = std::cos(direction), sine = std::sin(direction);
        const double along = std::hypot(0.002 * cosine, 0.001 * sine);
        const double across = std::hypot(0.002 * sine, 0.001 * cosine);
        QVERIFY(near(run.points[2].sigmaXM, along));
        QVERIFY(near(run.points[2].sigmaYM, across));
        QVERIFY(near(std::sqrt(run.samples[2].covariance(0, 0)), along));
        QVERIFY(near(std::sqrt(run.samples[2].covariance(1, 1)), across));
    }

    void theFloorStaysAsItIs()
    {
        const Profile same = inFrame(example(), TrackFrame::Floor);
        QCOMPARE(same.points[2].position.x(), example().points[2].position.x());
        Profile unknown = example();
        for (ProfilePoint &point : unknown.points)
            point.valid = false;
        QCOMPARE(inFrame(unknown, TrackFrame::Start).samples[0].time, unknown.samples[0].time);
        QVERIFY(trackFrameFromWord("start") == TrackFrame::Start && !trackFrameFromWord("axis"));
    }
};

ODOGRAPH_TEST(TestTrackFrame, QCoreApplication)
#include "tst_track_frame.moc"
