// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/imported_track.h"

#include "core/analysis/quantity_curve.h"
#include "tests/support/registered_test.h"
#include "tests/trajectory/driven_course.h"

#include <QTest>
#include <random>

using namespace odo;

/// Tracks of other programs against a known course: round a circle of 0.5 m at 1 m/s, 30 positions a second.
class TestImportedTrack : public QObject
{
    Q_OBJECT

    static std::vector<ImportedPosition> circle(double noiseM, double seconds = 20, double perSecond = 30)
    {
        std::mt19937 random(7);
        std::normal_distribution<double> noise(0, 1);
        std::vector<ImportedPosition> track;
        for (int i = 0; i <= seconds * perSecond; ++i) {
            const double t = i / perSecond;
            track.push_back({fromSeconds(t),
                             Eigen::Vector2d(0.5 * std::cos(2 * t) + noiseM * noise(random),
                                             0.5 * std::sin(2 * t) + noiseM * noise(random)),
                             {}});
        }
        return track;
    }
    static double metricOf(const Profile &profile, const char *name)
    {
        for (const Metric &metric : profile.metrics)
            if (metric.name == name)
                return metric.value;
        return -1;
    }

    /// The same for 10 s of spins and reverses, with headings.
    static std::vector<ImportedPosition> driven(const test::DrivenCourse &course, double noiseM,
                                                double noiseRad, double perSecond)
    {
        std::mt19937 random(5);
        std::normal_distribution<double> noise(0, 1);
        std::vector<ImportedPosition> track;
        for (int i = 0; i <= course.durationS() * perSecond; ++i) {
            const test::DrivenState state = course.at(i / perSecond);
            track.push_back({fromSeconds(i / perSecond),
                             state.truth.position + noiseM * Eigen::Vector2d(noise(random), noise(random)),
                             {},
                             // as a file has it
                             std::remainder(*state.truth.headingRad + noiseRad * noise(random), 2 * M_PI)});
        }
        return track;
    }
    static Profile profileOf(const std::vector<ImportedPosition> &track)
    {
        return *analyseImported(samplesOfImported(track, estimateImportedNoiseM(track)), {});
    }

private Q_SLOTS:
    void noiseIsEstimated_data()
    {
        QTest::addColumn<double>("noiseM");
        for (const double noiseM : {0.0005, 0.002, 0.01, 0.05})
            QTest::addRow("%g mm", 1e3 * noiseM) << noiseM;
    }
    /// Of 1200 coordinates a standard deviation is known to 2 %; that some of it looks like motion takes a
    /// little more.
    void noiseIsEstimated()
    {
        QFETCH(double, noiseM);
        const double estimated = estimateImportedNoiseM(circle(noiseM));
        QVERIFY2(std::abs(estimated / noiseM - 1) < 0.1, qPrintable(QString::number(estimated)));
        std::vector<ImportedPosition> spiked = circle(noiseM);
        for (std::size_t i = 20; i < spiked.size(); i += 50)
            *spiked[i].position += Eigen::Vector2d(0.6, 0);
        const double withSpikes = estimateImportedNoiseM(spiked);
        QVERIFY2(std::abs(withSpikes / noiseM - 1) < 0.15, qPrintable(QString::number(withSpikes)));
    }
    void exactPositionsHaveTheLeastNoise()
    {
        QCOMPARE(estimateImportedNoiseM(circle(0)), leastImportedNoiseM);
        std::vector<ImportedPosition> standing(50);
        for (std::size_t i = 0; i < standing.size(); ++i)
            standing[i] = {std::chrono::milliseconds(33 * i), Eigen::Vector2d(1, 2), {}};
        QCOMPARE(estimateImportedNoiseM(standing), leastImportedNoiseM);
    }
    void isAnalysedAsOurOwn()
    {
        auto track = circle(0.002);
        *track[300].position += Eigen::Vector2d(0.3, 0); // a spike
        for (std::size_t i = 400; i < 410; ++i)
            track[i].position.reset();
        const auto raw = samplesOfImported(track, estimateImportedNoiseM(track));
        const auto profile = analyseImported(raw, {});
        QVERIFY2(profile, profile ? "" : profile.error().message().c_str());
        QCOMPARE(profile->spikes.size(), std::size_t(1));
        QCOMPARE(profile->spikes[0].sampleIndex, std::int64_t(300));
        QVERIFY(profile->spikes[0].reason.english().starts_with("jump of "));
        QVERIFY(hasFlag(profile->samples[405].flags, SampleFlag::Interpolated) && profile->points[405].valid);
        // Noise of 2 mm at 30/s leaves some mm/s of speed in the middle and more at the ends.
        QVERIFY(std::abs(metricOf(*profile, "mean_speed") - 1) < 0.005);
        QVERIFY(std::abs(metricOf(*profile, "path_length") - 20) < 0.1);
        for (std::size_t i = 0; i < track.size(); ++i)
            QCOMPARE(profile->samples[i].position, track[i].position); // to the last bit
        QVERIFY(std::abs(noiseLevelM(raw) / 0.002 - 1) < 0.1);
        QCOMPARE(noiseLevelM({}), 0.0);
    }
    void aPersonsWordCounts()
    {
        const auto track = circle(0.002);
        AnalysisOptions options;
        options.overrides = {{100, true}};
        const auto profile = analyseImported(samplesOfImported(track, 0.002), options);
        QVERIFY(profile);
        QCOMPARE(profile->spikes.size(), std::size_t(1));
        QCOMPARE(profile->spikes[0].reason.english(), std::string("marked as a spike by hand"));
    }
    /// A position every two seconds is no gap in a track that has no others.
    void slowTracksAreNoGaps()
    {
        std::vector<ImportedPosition> track;
        for (int i = 0; i < 60; ++i)
            track.push_back({std::chrono::seconds(2 * i), Eigen::Vector2d(0.2 * i, 0), {}});
        const auto raw = samplesOfImported(track, 0.001);
        QVERIFY(!analyseImported(raw, {}));
        const AnalysisOptions options = optionsForImported({}, raw);
        QCOMPARE(options.longestBridgedGap, Nanoseconds(std::chrono::seconds(8)));
        const auto profile = analyseImported(raw, options);
        QVERIFY(profile);
        QVERIFY(std::abs(metricOf(*profile, "mean_speed") - 0.1) < 0.001);
        QCOMPARE(optionsForImported({}, samplesOfImported(circle(0), 0.001)).longestBridgedGap,
                 AnalysisOptions().longestBridgedGap);
    }
    /// A long track is analysed in parts: as it would be at once, its spikes where they are, and never with
    /// much of it in memory.
    void longTracksArePartedUnseen()
    {
        std::vector<ImportedPosition> track = circle(0.001, 2000, 100);
        for (ImportedPosition &one : track) // its right side ahead
            one.headingRad = std::remainder(2 * toSeconds(one.time), 2 * M_PI);
        const std::size_t spikes[] = {10, 16'383, 32'768, 65'536, 199'000}; // where parts begin too
        for (const std::size_t at : spikes)
            *track[at].position += Eigen::Vector2d(0.3, 0);
        const ImportedSeries series(track, 0.001);
        std::size_t asked = 0, most = 0;
        const SampleSource source{series.size(),
                                  [&](std::size_t first, std::size_t count) -> Result<std::vector<Sample>> {
                                      asked += count;
                                      most = std::max(most, count);
                                      std::vector<Sample> samples;
                                      for (std::size_t i = first; i < first + count; ++i)
                                          samples.push_back(series.sample(i));
                                      return samples;
                                  }};
        QVERIFY(source.count > longestAtOnce);
        const auto profile = analyseImported(source, {}, {});
        QVERIFY(profile);
        QVERIFY(profile->samples.empty());
        QCOMPARE(profile->flags.size(), source.count);
        QCOMPARE(profile->points.size(), source.count);
        // each once, beside margins and what is learnt from
        QVERIFY2(asked < source.count * 5 / 4 + 50'000, qPrintable(QString::number(asked)));
        QVERIFY2(most < 20'000, qPrintable(QString::number(most)));
        for (const std::size_t at : spikes)
            QVERIFY2(hasFlag(profile->flags[at], SampleFlag::Jump), qPrintable(QString::number(at)));
        QVERIFY(std::ranges::any_of(profile->spikes, [](const Spike &spike) {
            return spike.sampleIndex == 65'536 && spike.time == fromSeconds(655.36) &&
                   spike.reason.english().starts_with("jump of ");
        }));
        QVERIFY(std::abs(metricOf(*profile, "mean_speed") - 1) < 0.001);
        QVERIFY(std::abs(metricOf(*profile, "duration") - 2000) < 0.1);

        for (std::size_t i = 0; i < profile->points.size(); ++i) {
            const auto &body = profile->points[i].body;
            QVERIFY(body && std::abs(body->turnRateRadps - 2) < 0.01);
            QVERIFY(std::abs(std::remainder(body->radians - 2 * toSeconds(track[i].time), 2 * M_PI)) < 1e-3);
        }

        // What is around the end of a part, at once.
        constexpr std::size_t from = 60'000, count = 11'000;
        const auto around = analyseImported(*source.chunk(from, count), {});
        QVERIFY(around);
        for (std::size_t i = 4000; i < 7000; ++i) {
            const ProfilePoint &at = profile->points[from + i], &expected = around->points[i];
            // The noise was learnt from other stretches, so that the curve bends a little otherwise: by less
            // than its σ.
            QVERIFY((at.position - expected.position).norm() < expected.sigmaXM);
            QVERIFY(std::abs(at.speedMps - expected.speedMps) < expected.sigmaSpeedMps);
        }
    }
    void longTracksAreCancelled()
    {
        const ImportedSeries series(circle(0.001, 2000, 100), 0.001);
        JobControl control;
        const SampleSource source{series.size(),
                                  [&](std::size_t first, std::size_t count) -> Result<std::vector<Sample>> {
                                      return std::vector<Sample>(count, series.sample(first));
                                  }};
        control.cancel.cancel();
        const auto stopped = analyseImported(source, {}, control);
        QVERIFY(!stopped && stopped.error().code == ErrorCode::Cancelled);
    }
    void spinsAndReversesAreFollowed_data()
    {
        QTest::addColumn<double>("noiseRad");
        QTest::addColumn<double>("perSecond");
        for (const double noiseRad : {0.0, 0.001, 0.02})
            for (const double perSecond : {20.0, 100.0})
                QTest::addRow("%g rad, %g a second", noiseRad, perSecond) << noiseRad << perSecond;
    }
    void spinsAndReversesAreFollowed()
    {
        QFETCH(double, noiseRad);
        QFETCH(double, perSecond);
        const test::DrivenCourse course = test::spinsAndReverses();
        const Profile profile = profileOf(driven(course, 0.001, noiseRad, perSecond));
        const auto headings = headingsOf(profile);
        double headingHolds = 0, rateHolds = 0;
        for (std::size_t i = 0; i < headings.size(); ++i) {
            const test::DrivenState truth = course.at(toSeconds(profile.samples[i].time));
            QVERIFY(headings[i] && headings[i]->isOfBody);
            // from the first one on without whole turns
            headingHolds +=
                std::abs(headings[i]->radians - *truth.truth.headingRad) <= 2 * *headings[i]->sigmaRad;
            const auto rate = turnRateOf(profile.points[i]);
            rateHolds += std::abs(rate->value - truth.turnRateRadps) <= 2 * rate->sigma;
        }
        const auto count = static_cast<double>(headings.size());
        const auto turn = std::ranges::find(profile.metrics, "max_turn_rate", &Metric::name);
        qInfo("heading %.3f, rate %.3f; fastest %.4f ± %.4f, σ %.5f", headingHolds / count, rateHolds / count,
              turn->value, *turn->sigma, *headings[headings.size() / 2]->sigmaRad);
        QVERIFY(headingHolds > 0.9 * count);
        QVERIFY(rateHolds > 0.9 * count);
        QVERIFY(std::abs(turn->value - 4) < 2 * *turn->sigma);
    }
    /// Programs that know no orientation write the same one in every line.
    void headingsThatNeverChange()
    {
        auto track = circle(0.001, 5);
        for (ImportedPosition &one : track)
            one.headingRad = 0;
        const Profile round = profileOf(track);
        QVERIFY(
            std::ranges::none_of(round.samples, [](const Sample &one) { return one.heading.has_value(); }));
        QVERIFY(
            std::ranges::none_of(round.points, [](const ProfilePoint &one) { return one.body.has_value(); }));
        const auto turn = std::ranges::find(round.metrics, "max_turn_rate", &Metric::name);
        QVERIFY(std::abs(turn->value - 2) < 3 * *turn->sigma);

        // To and fro along a line it is that of the robot.
        for (std::size_t i = 0; i < track.size(); ++i) {
            const double along = std::sin(1.5 * toSeconds(track[i].time));
            track[i].position = Eigen::Vector2d(along * std::cos(0.3), along * std::sin(0.3));
            track[i].headingRad = 0.3;
        }
        for (const auto &heading : headingsOf(profileOf(track)))
            QVERIFY(heading && heading->isOfBody && std::abs(heading->radians - 0.3) < 1e-3);
        for (ImportedPosition &one : track)
            one.headingRad = 0.9;
        for (const auto &heading : headingsOf(profileOf(track)))
            QVERIFY(heading && !heading->isOfBody && std::abs(heading->radians - 0.3) < 0.05);
    }
    /// A wrong one among good ones, and lines without any.
    void aHeadingThatLeapsDoesNotCount()
    {
        const test::DrivenCourse course = test::spinsAndReverses();
        auto track = driven(course, 0.001, 0.005, 50);
        *track[100].headingRad += 2;
        for (std::size_t i = 200; i < 210; ++i)
            track[i].headingRad.reset();
        const Profile profile = profileOf(track);
        for (std::size_t i = 95; i < 215; ++i) {
            const double truth = *course.at(toSeconds(profile.samples[i].time)).truth.headingRad;
            QVERIFY(profile.points[i].body);
            QVERIFY(std::abs(profile.points[i].body->radians - truth) < 4 * profile.points[i].body->sigmaRad);
        }
        QVERIFY(profile.points[205].body->sigmaRad > profile.points[190].body->sigmaRad);
    }
    void aRobotThatNeverTurnsHasNoFastestTurn()
    {
        std::vector<ImportedPosition> standing(100);
        for (std::size_t i = 0; i < standing.size(); ++i)
            standing[i] = {std::chrono::milliseconds(33 * i), Eigen::Vector2d(1, 2), {}, {}};
        QVERIFY(std::ranges::none_of(profileOf(standing).metrics,
                                     [](const Metric &one) { return one.name == "max_turn_rate"; }));
    }
    void tooFew()
    {
        const auto profile = analyseImported(samplesOfImported(circle(0.001, 0.05), 0.001), {});
        QVERIFY(!profile);
        QCOMPARE(profile.error().message(), std::string("the robot's path cannot be measured: not enough "
                                                        "data: only 2 of 2 frames give a usable "
                                                        "position; choose a track with more positions"));
    }
};

ODOGRAPH_TEST(TestImportedTrack, QCoreApplication)
#include "tst_imported_track.moc"
