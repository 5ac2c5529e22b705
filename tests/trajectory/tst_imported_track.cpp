// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/imported_track.h"

#include "tests/support/registered_test.h"

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
