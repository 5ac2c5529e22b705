// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/clip_evidence.h"
#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr double offsetS = 0.321;

/// At about half a metre a second, never twice alike.
Course wandering()
{
    return [](double t) {
        Truth truth;
        truth.position = {0.5 * std::sin(0.61 * t) + 0.25 * std::sin(1.1 * t + 1),
                          0.4 * std::cos(0.53 * t) + 0.2 * std::sin(0.9 * t)};
        return truth;
    };
}

std::vector<ViewTrack> filmed(double durationS, double driftPpm, unsigned seed)
{
    std::mt19937 random(seed);
    FilmSettings first, second;
    first.durationS = second.durationS = durationS;
    second.startS = offsetS;
    second.driftPpm = driftPpm;
    return {film("A", cameraA(), wandering(), first, random),
            film("B", cameraB(), wandering(), second, random)};
}

/// As import does it.
Result<FoundOffset> found(const std::vector<ViewTrack> &tracks)
{
    std::vector<NamedView> views;
    for (const ViewTrack &track : tracks)
        views.push_back({track.floorView, Nanoseconds(0), {track.observations}});
    const auto motion = motionTracks(views, {{RgbColour{215, 35, 40}, 0.06}}, {"red"});
    std::vector<ClipEvidence> evidence(2);
    for (std::size_t v = 0; v < 2; ++v)
        evidence[v].tracks = motion[v];
    return findClipOffset(evidence[0], evidence[1], {0, 10});
}

/// RMS error of the positions from a time on.
double errorAfter(double timeS, const Profile &profile)
{
    double squares = 0;
    int count = 0;
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        const double t = toSeconds(profile.samples[i].time);
        if (t < timeS || !profile.points[i].valid)
            continue;
        squares += (profile.points[i].position - wandering()(t).position).squaredNorm();
        ++count;
    }
    return std::sqrt(squares / count);
}

} // namespace

/// Clocks that run at different rates: found from the motion, and used by the analysis.
class TestClockRates : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void statesTheErrorOfTheRate();
    void tenMinutesNeedTheRate_data();
    void tenMinutesNeedTheRate();
};

void TestClockRates::statesTheErrorOfTheRate()
{
    // A minute at 200 ppm: 12 ms from its begin to its end.
    double squares = 0, sigma = 0;
    constexpr int draws = 8;
    for (unsigned seed = 1; seed <= draws; ++seed) {
        const auto offset = found(filmed(60, 200, seed));
        QVERIFY2(offset, offset ? "" : offset.error().message().c_str());
        QVERIFY2(offset->clock.rate > 0, "the rate was not significant");
        const double error = offset->clock.rate - 200e-6;
        squares += error * error / draws;
        sigma += offset->clock.rateSigma / draws;
        QVERIFY(std::abs(offset->clock.offsetS - offsetS) < 4 * offset->clock.sigmaS);
    }
    qInfo("rate: RMS error %.1f ppm, stated %.1f ppm", 1e6 * std::sqrt(squares), 1e6 * sigma);
    // Stated as if neighbouring errors were alike for half a second; here they are not, which costs a factor
    // of four.
    QVERIFY(std::sqrt(squares) < 1.3 * sigma);
    QVERIFY(sigma < 40e-6);
}

void TestClockRates::tenMinutesNeedTheRate_data()
{
    QTest::addColumn<double>("ppm");
    QTest::newRow("50 ppm, 30 ms at the end") << 50.0;
    QTest::newRow("-500 ppm, 300 ms at the end") << -500.0;
}

void TestClockRates::tenMinutesNeedTheRate()
{
    QFETCH(double, ppm);
    std::vector<ViewTrack> tracks = filmed(600, ppm, 11);
    const auto offset = found(tracks);
    QVERIFY2(offset, offset ? "" : offset.error().message().c_str());
    QVERIFY2(std::abs(offset->clock.rate - ppm * 1e-6) < 3 * offset->clock.rateSigma,
             qPrintable(QString::number(1e6 * offset->clock.rate)));
    QVERIFY(offset->clock.rateSigma < 10e-6);
    QVERIFY(std::abs(offset->clock.offsetS - offsetS) < 0.001);

    tracks[1].startOffset = fromSeconds(offset->clock.offsetS);
    tracks[1].clockRate = offset->clock.rate;
    const RobotShape shape{0.06, 0.26, 0.19};
    const auto right = analyse(tracks, shape, {});
    QVERIFY2(right, right ? "" : right.error().message().c_str());
    tracks[1].clockRate = 0;
    const auto wrong = analyse(tracks, shape, {});
    QVERIFY2(wrong, wrong ? "" : wrong.error().message().c_str());
    const double rightM = errorAfter(540, *right), wrongM = errorAfter(540, *wrong);
    qInfo("last minute: %.2f mm, without the rate %.2f mm", 1e3 * rightM, 1e3 * wrongM);
    QVERIFY(rightM < 0.002);
    QVERIFY(wrongM > 2 * rightM); // half of 30 ms at 0.4 m/s is 6 mm
}

ODOGRAPH_TEST(TestClockRates, QCoreApplication)
#include "tst_clock_rates.moc"
