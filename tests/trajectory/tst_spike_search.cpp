// SPDX-License-Identifier: GPL-3.0-or-later
// Recall and precision of the flags on tracks whose faults are known: many motions, rates and kinds of fault.
#include "core/trajectory/internal/spike_flags.h"

#include "tests/support/registered_test.h"
#include "tests/trajectory/spiked_track.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

struct Motion
{
    const char *name;
    Course course;
    /// Without abrupt changes and hard turns of its own, among which small faults and slow ones would not
    /// show.
    bool calm;
};

const std::vector<Motion> &motions()
{
    static const std::vector<Motion> all{
        {"rest", evenLine(0), true},
        {"even line", evenLine(0.5), true},
        {"fast line", evenLine(1.5), true},
        {"figure eight", figureEight(1.1, 0.7, 7), true},
        {"fast turns", circle(0.25, 1.2), false},
        {"stop and go", hardStopAndGo(0.8, 3, 0.4), false},
        {"hard stop and go", hardStopAndGo(0.6, 9, 0.25), false},
        {"collision", collision(4.013, 1.5, 0.5), false},
        {"hard start", hardStart(4, 12, 1.2), false},
        {"billiard", billiard({0.9, 0.6}, {0.8, 0.45}), false},
    };
    return all;
}

struct Fault
{
    const char *name;
    std::function<void(SpikedTrack &, std::mt19937 &)> add;
    bool calmOnly; ///< looked for in calm motions only
    double leastRecall;
};

const std::vector<Fault> &faults()
{
    static const std::vector<Fault> all{
        {"isolated",
         [](auto &t, auto &r) {
             addBursts(t, 12, {1, 1}, {0.05, 0.4}, r);
         },
         false, 0.98},
        {"small",
         [](auto &t, auto &r) {
             addBursts(t, 12, {1, 1}, {0.02, 0.03}, r);
         },
         true, 0.98},
        {"bursts",
         [](auto &t, auto &r) {
             addBursts(t, 8, {2, 8}, {0.06, 0.4}, r);
         },
         false, 0.98},
        {"small bursts",
         [](auto &t, auto &r) {
             addBursts(t, 8, {2, 8}, {0.025, 0.04}, r);
         },
         true, 0.98},
        {"ends", [](auto &t, auto &r) { addAtEnds(t, 3, r); }, false, 0.98},
        // A drift begins inside the noise, and some of it can be a motion.
        {"drift and snap", [](auto &t, auto &r) { addDrifts(t, 4, true, r); }, true, 0.9},
        {"drift and back", [](auto &t, auto &r) { addDrifts(t, 4, false, r); }, true, 0.95},
        {"capture", [](auto &t, auto &r) { addCaptures(t, 4, r); }, true, 0.98},
        {"gaps",
         [](auto &t, auto &r) {
             addBursts(t, 8, {1, 5}, {0.05, 0.4}, r);
             addGaps(t, 0.15, 10, r);
         },
         false, 0.98},
    };
    return all;
}

struct Camera
{
    double framesPerSecond, sigmaM;
};

struct Score
{
    std::size_t injected = 0, hit = 0, falseFlags = 0, frames = 0;
    std::string misses;

    void add(const SpikedTrack &track, unsigned seed)
    {
        frames += track.samples.size();
        injected += track.spikes.size();
        for (std::size_t i = 0; i < track.samples.size(); ++i) {
            const bool flagged = hasFlag(track.samples[i].flags, SampleFlag::Jump);
            const bool spike = track.spikes.contains(i);
            hit += flagged && spike;
            falseFlags += flagged && !spike && !track.uncertain.contains(i);
            if (flagged != spike && !track.uncertain.contains(i))
                misses += (spike ? " missed " : " false ") + std::to_string(seed) + ":" + std::to_string(i);
        }
    }
    double recall() const { return injected ? double(hit) / double(injected) : 1; }
    double precision() const { return hit + falseFlags ? double(hit) / double(hit + falseFlags) : 1; }
};

unsigned seeds(double framesPerSecond)
{
    return framesPerSecond > 100 ? 1 : framesPerSecond > 50 ? 3 : 5;
}

void run(const Course &course, const Camera &camera, const Fault *fault, unsigned seeds, Score &score)
{
    for (unsigned seed = 0; seed < seeds; ++seed) {
        std::mt19937 random(1000 + seed);
        SpikedTrack track = sampled(course, camera.framesPerSecond, camera.framesPerSecond > 100 ? 6 : 9,
                                    camera.sigmaM, random);
        if (fault)
            fault->add(track, random);
        flagSpikes(track.samples, {});
        score.add(track, seed);
    }
}

} // namespace

class TestSpikeSearch : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void faultsAreFound_data()
    {
        QTest::addColumn<int>("fault");
        QTest::addColumn<double>("framesPerSecond");
        QTest::addColumn<double>("sigmaM");
        for (const Camera &camera : {Camera{30, 0.002}, Camera{60, 0.0015}, Camera{240, 0.0004}}) {
            for (std::size_t f = 0; f < faults().size(); ++f)
                QTest::addRow("%s, %g frames/s", faults()[f].name, camera.framesPerSecond)
                    << int(f) << camera.framesPerSecond << camera.sigmaM;
        }
    }
    void faultsAreFound()
    {
        QFETCH(int, fault);
        QFETCH(double, framesPerSecond);
        QFETCH(double, sigmaM);
        const Fault &added = faults()[std::size_t(fault)];
        Score score;
        for (const Motion &motion : motions()) {
            if (motion.calm || !added.calmOnly)
                run(motion.course, {framesPerSecond, sigmaM}, &added, seeds(framesPerSecond), score);
        }
        qInfo("%zu spikes: recall %.3f, precision %.3f", score.injected, score.recall(), score.precision());
        QVERIFY(score.injected > 0);
        QVERIFY2(score.recall() >= added.leastRecall, score.misses.c_str());
        QVERIFY2(score.precision() >= 0.95, score.misses.c_str());
    }

    void whatIsRealIsNotFlagged_data()
    {
        QTest::addColumn<int>("motion");
        QTest::addColumn<double>("framesPerSecond");
        QTest::addColumn<double>("sigmaM");
        for (const Camera &camera : {Camera{30, 0.002}, Camera{30, 0.0003}, Camera{60, 0.0015},
                                     Camera{240, 0.0004}, Camera{240, 0.002}}) {
            for (std::size_t m = 0; m < motions().size(); ++m)
                QTest::addRow("%s, %g frames/s, %g mm", motions()[m].name, camera.framesPerSecond,
                              camera.sigmaM * 1e3)
                    << int(m) << camera.framesPerSecond << camera.sigmaM;
        }
    }
    void whatIsRealIsNotFlagged()
    {
        QFETCH(int, motion);
        QFETCH(double, framesPerSecond);
        QFETCH(double, sigmaM);
        Score score;
        run(motions()[std::size_t(motion)].course, {framesPerSecond, sigmaM}, nullptr, seeds(framesPerSecond),
            score);
        QVERIFY2(double(score.falseFlags) <= 0.001 * double(score.frames), score.misses.c_str());
    }
};

ODOGRAPH_TEST(TestSpikeSearch, QCoreApplication)
#include "tst_spike_search.moc"
