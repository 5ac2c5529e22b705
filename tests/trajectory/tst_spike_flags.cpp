// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/spike_flags.h"

#include "tests/support/registered_test.h"
#include "tests/trajectory/spiked_track.h"

#include <QTest>
#include <set>

using namespace odo;
using namespace odo::test;

namespace {

const RobotShape given{0.06, 0.26, 0.19};

/// Shifts what a view sees in some frames, as a false sighting does.
std::set<std::int64_t> injectSpikes(ViewTrack &view, int count, int longest, double leastPx,
                                    std::mt19937 &random)
{
    std::set<std::int64_t> frames;
    std::uniform_real_distribution<double> angle(0, 2 * M_PI), size(leastPx, 4 * leastPx);
    std::uniform_int_distribution<std::size_t> start(8, view.observations.size() - 20);
    std::uniform_int_distribution<int> length(1, longest);
    for (int i = 0; i < count; ++i) {
        const std::size_t first = start(random);
        const double direction = angle(random), distance = size(random);
        for (int k = length(random); k > 0; --k) {
            Observation &observation = view.observations[first + static_cast<std::size_t>(k)];
            if (!frames.insert(observation.frame).second)
                continue;
            observation.ellipse.centrePx +=
                distance * Eigen::Vector2d(std::cos(direction), std::sin(direction));
        }
    }
    return frames;
}

std::set<std::int64_t> flaggedFrames(const Profile &profile)
{
    std::set<std::int64_t> frames;
    for (const Spike &spike : profile.spikes)
        frames.insert(profile.samples[static_cast<std::size_t>(spike.sampleIndex)].frame);
    return frames;
}

std::string reasons(const Profile &profile)
{
    std::string all;
    for (const Spike &spike : profile.spikes)
        all += std::to_string(toSeconds(spike.time)) + " s: " + spike.reason.english() + "\n";
    return all;
}

struct Score
{
    int injected = 0, flagged = 0, hit = 0;
    void add(const std::set<std::int64_t> &truth, const std::set<std::int64_t> &found)
    {
        injected += static_cast<int>(truth.size());
        flagged += static_cast<int>(found.size());
        hit += static_cast<int>(std::count_if(truth.begin(), truth.end(),
                                              [&](std::int64_t frame) { return found.contains(frame); }));
    }
    double recall() const { return double(hit) / injected; }
    double precision() const { return double(hit) / flagged; }
};

} // namespace

class TestSpikeFlags : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void singleViewSpikesAreFlagged()
    {
        Score score;
        double worst = 0;
        for (unsigned seed = 0; seed < 10; ++seed) {
            std::mt19937 random(seed);
            const Course course = figureEight(1.1, 0.7, 7);
            auto a = film("A", cameraA(), course, {}, random);
            const auto truth = injectSpikes(a, 8, 3, 15, random);
            const auto profile = analyse({a}, given, {});
            QVERIFY(profile.has_value());
            score.add(truth, flaggedFrames(*profile));
            worst = std::max(worst, errorsOf(*profile, course).velocityMps);
        }
        qInfo("recall %.3f, precision %.3f, worst velocity %.1f mm/s", score.recall(), score.precision(),
              worst * 1e3);
        QVERIFY(score.recall() >= 0.98);
        QVERIFY(score.precision() >= 0.95);
        QVERIFY(worst < 0.04);
    }

    void aFalseSightingInOneViewIsToldByTheOther()
    {
        Score score;
        double worst = 0;
        int undecided = 0, all = 0;
        for (unsigned seed = 0; seed < 10; ++seed) {
            std::mt19937 random(seed);
            const Course course = figureEight(1.1, 0.7, 7);
            auto a = film("A", cameraA(), course, {}, random);
            const auto b = film("B", cameraB(), course, {}, random);
            const auto truth = injectSpikes(a, 6, 12, 15, random);
            const auto profile = analyse({a, b}, given, {});
            QVERIFY(profile.has_value());
            score.add(truth, flaggedFrames(*profile));
            worst = std::max(worst, errorsOf(*profile, course).velocityMps);
            for (const Spike &spike : profile->spikes) {
                const Sample &sample = profile->samples[static_cast<std::size_t>(spike.sampleIndex)];
                if (!truth.contains(sample.frame))
                    continue;
                QVERIFY(hasFlag(sample.flags, SampleFlag::ViewsDisagree));
                QVERIFY(spike.reason.english().find("views disagree by ") == 0);
                ++all;
                if (isRejected(sample.flags))
                    ++undecided;
                else
                    QCOMPARE(sample.views, 2u); // the other view is used, so nothing is missing
            }
        }
        qInfo("%d of %d could not be told", undecided, all);
        QVERIFY(undecided * 50 <= all);
        qInfo("recall %.3f, precision %.3f, worst velocity %.1f mm/s", score.recall(), score.precision(),
              worst * 1e3);
        QVERIFY(score.recall() >= 0.98);
        QVERIFY(score.precision() >= 0.95);
        QVERIFY(worst < 0.02);
    }

    void threeViewsOutvoteOne()
    {
        std::mt19937 random(3);
        const Course course = figureEight(1.1, 0.7, 7);
        auto a = film("A", cameraA(), course, {}, random);
        const auto b = film("B", cameraB(), course, {}, random);
        const auto c = film("C", cameraC(), course, {}, random);
        // For longer than motion could decide.
        for (std::size_t i = 50; i < 150; ++i)
            a.observations[i].ellipse.centrePx.x() += 40;
        const auto profile = analyse({a, b, c}, given, {});
        QVERIFY(profile.has_value());
        QCOMPARE(profile->samples[100].views, 6u);
        QCOMPARE(profile->samples[20].views, 7u);
        QVERIFY(errorsOf(*profile, course).positionM < 0.003);
    }

    void aHardRealStartIsNoSpike_data()
    {
        QTest::addColumn<double>("accelMps2");
        for (const double accel : {3.0, 8.0, 15.0})
            QTest::addRow("%g m/s²", accel) << accel;
    }
    void aHardRealStartIsNoSpike()
    {
        QFETCH(double, accelMps2);
        for (unsigned seed = 0; seed < 5; ++seed) {
            std::mt19937 random(seed);
            FilmSettings settings;
            settings.durationS = 6;
            const Course course = hardStart(4, accelMps2, 1.0);
            const auto a = film("A", cameraA(), course, settings, random);
            const auto b = film("B", cameraB(), course, settings, random);
            const auto both = analyse({a, b}, given, {});
            QVERIFY(both.has_value());
            QVERIFY2(both->spikes.empty(), reasons(*both).c_str());
            const auto single = analyse({a}, given, {});
            QVERIFY2(single->spikes.empty(), reasons(*single).c_str());
        }
    }

    void aCollisionIsNoSpike()
    {
        std::mt19937 random(4);
        // 2 m/s against a wall and back at 0.8 m/s, within one frame.
        const Course course = [](double t) {
            Truth truth;
            truth.velocity.x() = t < 1 ? 2 : -0.8;
            truth.position.x() = t < 1 ? -1 + 2 * t : 1 - 0.8 * (t - 1);
            return truth;
        };
        FilmSettings settings;
        settings.durationS = 3;
        const auto a = film("A", cameraA(), course, settings, random);
        const auto b = film("B", cameraB(), course, settings, random);
        const auto profile = analyse({a, b}, given, {});
        QVERIFY(profile.has_value());
        QVERIFY2(profile->spikes.size() <= 1, reasons(*profile).c_str());
    }

    void theTasksLimitOfAccelerationRefusesABlow()
    {
        // 2 m/s against a wall and back: a motion, unless the task knows that no robot brakes like that.
        std::mt19937 random(4);
        FilmSettings settings;
        settings.durationS = 3;
        const Course course = collision(1.0, 2, 0.8);
        const auto a = film("A", cameraA(), course, settings, random);
        const auto b = film("B", cameraB(), course, settings, random);
        Task task;
        task.limits.maxAccelMps2 = 10;
        const auto limited = analyse({a, b}, given, withTask({}, task));
        QVERIFY(limited.has_value());
        // From 2 m/s to −0.8 m/s within the limit takes 0.28 s: what was measured meanwhile cannot be.
        int flagged = 0;
        for (const Sample &sample : limited->samples) {
            const bool refused = hasFlag(sample.flags, SampleFlag::AccelerationLimit);
            flagged += refused;
            QVERIFY2(!refused || std::abs(toSeconds(sample.time) - 1) < 0.2, reasons(*limited).c_str());
        }
        QVERIFY2(flagged >= 3 && flagged <= 9, reasons(*limited).c_str());
        QVERIFY2(reasons(*limited).find("acceleration above the limit") != std::string::npos,
                 reasons(*limited).c_str());
        task.limits.maxAccelMps2 = 500;
        const auto free = analyse({a, b}, given, withTask({}, task));
        QVERIFY(free->spikes.size() <= 1);
    }

    void theTasksLimitOfSpeedIsNamed()
    {
        std::mt19937 random(5);
        const Course course = figureEight(1.1, 0.7, 7);
        auto a = film("A", cameraA(), course, {}, random);
        a.observations[100].ellipse.centrePx.x() += 40; // some 0.1 m in a frame: 3 m/s
        const auto usual = analyse({a}, given, {});
        QVERIFY(!hasFlag(usual->samples[100].flags, SampleFlag::SpeedLimit));
        Task task;
        task.limits.maxSpeedMps = 2;
        const auto limited = analyse({a}, given, withTask({}, task));
        QVERIFY2(hasFlag(limited->samples[100].flags, SampleFlag::SpeedLimit), reasons(*limited).c_str());
        QCOMPARE(limited->spikes.size(), std::size_t(1));
        QVERIFY(limited->spikes[0].reason.english().find("speed above the limit") != std::string::npos);
    }

    void hampelsIdentifierIsAReasonOfItsOwn()
    {
        std::mt19937 random(5);
        auto a = film("A", cameraA(), evenLine(0.4), {}, random);
        a.observations[100].ellipse.centrePx.x() += 60;
        a.observations[200].ellipse.centrePx.y() += 9;
        const auto profile = analyse({a}, given, {});
        QVERIFY(profile.has_value());
        QCOMPARE(profile->spikes.size(), std::size_t(2));
        QVERIFY2(profile->spikes[0].reason.english().find("spike in position and speed") != std::string::npos,
                 profile->spikes[0].reason.english().c_str());
        QVERIFY2(profile->spikes[1].reason.english().find("spike in ") != std::string::npos,
                 profile->spikes[1].reason.english().c_str());
        QVERIFY(flagNames(profile->spikes[1].flags).find("jump") == 0);
    }

    void reasonsCarryFigures()
    {
        std::mt19937 random(5);
        const Course course = figureEight(1.1, 0.7, 7);
        auto a = film("A", cameraA(), course, {}, random);
        a.observations[100].ellipse.centrePx.x() += 200;
        a.observations[150].score = 0.05;
        a.observations[200].touchesBorder = true;
        a.observations[250].duplicateFrame = true;
        a.observations[270].found = false;
        const auto profile = analyse({a}, given, {});
        QVERIFY(profile.has_value());
        QCOMPARE(profile->spikes.size(), std::size_t(3));
        QVERIFY2(profile->spikes[0].reason.english().find("jump of ") == 0,
                 profile->spikes[0].reason.english().c_str());
        QVERIFY(hasFlag(profile->spikes[0].flags, SampleFlag::SpeedLimit));
        QVERIFY(hasFlag(profile->spikes[0].flags, SampleFlag::AccelerationLimit));
        QCOMPARE(profile->spikes[1].reason.english(), std::string("the tracker was not sure (score 5 %)"));
        QCOMPARE(profile->spikes[2].reason.english(), std::string("cut by the frame's edge"));
        QVERIFY(hasFlag(profile->samples[250].flags, SampleFlag::DuplicateFrame));
        QVERIFY(hasFlag(profile->samples[270].flags, SampleFlag::Lost));
        for (const std::size_t i : {100u, 150u, 200u, 250u, 270u}) {
            QVERIFY(hasFlag(profile->samples[i].flags, SampleFlag::Interpolated));
            QVERIFY(profile->points[i].valid);
        }
        QVERIFY(profile->samples[100].position.has_value()); // raw is kept
    }
};

ODOGRAPH_TEST(TestSpikeFlags, QCoreApplication)
#include "tst_spike_flags.moc"
