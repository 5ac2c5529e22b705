// SPDX-License-Identifier: GPL-3.0-or-later
// Times at gates against closed forms, and their stated σ against the scatter over many noisy runs.
#include "core/analysis/gate_passages.h"

#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_run.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

/// Passed by a robot that goes towards +x.
const Gate start{"start", GateRole::Start, {0, -0.2}, {0, 0.2}};
const Gate finish{"finish", GateRole::Finish, {2, -0.2}, {2, 0.2}};

Gate startFinish()
{
    return {"line", GateRole::StartFinish, {0.7, 0}, {0.3, 0}}; // passed towards +y
}

std::vector<GatePassage> passagesOf(const std::vector<Gate> &gates, const Run &run)
{
    return findPassages(gates, run.samples, run.points);
}

Course evenly(Eigen::Vector2d from, Eigen::Vector2d velocity)
{
    return [=](double t) { return Truth{from + t * velocity, velocity, {0, 0}}; };
}

Course exactCircle(double radiusM, double periodS)
{
    return [=](double t) {
        const double w = 2 * M_PI / periodS;
        const Eigen::Vector2d out(std::cos(w * t - 1), std::sin(w * t - 1)), aside(-out.y(), out.x());
        return Truth{radiusM * out, radiusM * w * aside, -radiusM * w * w * out};
    };
}

} // namespace

class TestGatePassages : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aStraightRunAtKnownSpeed()
    {
        // 0.83 m/s from −0.5 m: at 0 after 0.5/0.83 s, 2 m later after 2/0.83 s more.
        const Run run = exactly(evenly({-0.5, 0.05}, {0.83, 0}), 4, 0.002);
        const auto passages = passagesOf({start, finish}, run);
        QCOMPARE(passages.size(), std::size_t(2));
        QCOMPARE(passages[0].gate, std::string("start"));
        QVERIFY(std::abs(toSeconds(passages[0].time) - 0.5 / 0.83) < 1e-8);
        QVERIFY(std::abs(toSeconds(passages[1].time) - 2.5 / 0.83) < 1e-8);
        QVERIFY(std::abs(passages[0].sigmaS - 0.002 / 0.83) < 1e-6);
        const auto laps = lapsOf(passages);
        QCOMPARE(laps.size(), std::size_t(1));
        QVERIFY(std::abs(laps[0].timeS - 2 / 0.83) < 1e-8);
        QVERIFY(std::abs(laps[0].sigmaS - std::sqrt(2.0) * 0.002 / 0.83) < 1e-6);
    }
    void itIsAcrossTheGateThatCounts()
    {
        // At 60° to the gate: only the part of speed across it carries the robot over.
        const double v = 0.9, slant = M_PI / 6;
        const Run run = exactly(evenly({-0.3, -0.17}, {v * std::cos(slant), v * std::sin(slant)}), 2, 0.001);
        const auto passages = passagesOf({start}, run);
        QCOMPARE(passages.size(), std::size_t(1));
        QVERIFY(std::abs(toSeconds(passages[0].time) - 0.3 / (v * std::cos(slant))) < 1e-8);
        QVERIFY(std::abs(passages[0].sigmaS - 0.001 / (v * std::cos(slant))) < 1e-6);
    }
    void acceleratingBetweenTwoFrames()
    {
        // x = −0.2 + 2t²: linear interpolation at 10 frames/s would err by up to 10 ms.
        const Course course = [](double t) { return Truth{{-0.2 + 2 * t * t, 0}, {4 * t, 0}, {4, 0}}; };
        const auto passages = passagesOf({start}, exactly(course, 1, 0, Eigen::Matrix2d::Zero(), 10));
        QCOMPARE(passages.size(), std::size_t(1));
        QVERIFY(std::abs(toSeconds(passages[0].time) - std::sqrt(0.1)) < 1e-8);
    }
    void onlyInTheGatesDirection()
    {
        const Run back = exactly(evenly({0.5, 0}, {-0.8, 0}), 2);
        QVERIFY(passagesOf({start}, back).empty());
        const Gate turned{"turned", GateRole::Split, start.to, start.from};
        QCOMPARE(passagesOf({turned}, back).size(), std::size_t(1));
        const Gate across = gateAcross("across", GateRole::Split, {0.1, 0}, {-2, 0}, 0.3);
        QCOMPARE(passagesOf({across}, back).size(), std::size_t(1));
        QVERIFY(std::abs((across.to - across.from).norm() - 0.3) < 1e-12);
    }
    void theEndsBelongToTheGate()
    {
        QCOMPARE(passagesOf({start}, exactly(evenly({-0.5, 0.2}, {1, 0}), 1)).size(), std::size_t(1));
        QCOMPARE(passagesOf({start}, exactly(evenly({-0.5, -0.2}, {1, 0}), 1)).size(), std::size_t(1));
        QVERIFY(passagesOf({start}, exactly(evenly({-0.5, 0.2001}, {1, 0}), 1)).empty());
        QVERIFY(passagesOf({start}, exactly(evenly({-0.5, -0.2001}, {1, 0}), 1)).empty());
    }
    void lapsOfACircle()
    {
        // Period 3.7 s, phase −1 rad at the start: at the gate after 3.7/2π s, then every period.
        const Run run = exactly(exactCircle(0.5, 3.7), 16, 0.001);
        const auto passages = passagesOf({startFinish()}, run);
        QCOMPARE(passages.size(), std::size_t(5));
        QVERIFY(std::abs(toSeconds(passages[0].time) - 3.7 / (2 * M_PI)) < 1e-5);
        const auto laps = lapsOf(passages);
        QCOMPARE(laps.size(), std::size_t(4));
        for (const Lap &lap : laps) {
            QVERIFY(std::abs(lap.timeS - 3.7) < 1e-5);
            QVERIFY(std::abs(lap.sigmaS - std::sqrt(2.0) * 0.001 / (M_PI / 3.7)) < 2e-5);
            QCOMPARE(lap.sectors.size(), std::size_t(1));
        }
    }
    void sectorsBetweenSplits()
    {
        const Gate half{"half", GateRole::Split, {-0.7, 0}, {-0.3, 0}}; // passed towards −y
        const auto laps = lapsOf(passagesOf({startFinish(), half}, exactly(exactCircle(0.5, 4), 10)));
        QCOMPARE(laps.size(), std::size_t(2));
        QCOMPARE(laps[0].sectors.size(), std::size_t(2));
        QCOMPARE(laps[0].sectors[0].gate, std::string("half"));
        QVERIFY(std::abs(laps[0].sectors[0].timeS - 2) < 1e-5);
        QCOMPARE(laps[0].sectors[1].gate, std::string("line"));
    }
    void aSplitMissedOrPassedTwiceMakesNoSectorOfItsOwn()
    {
        const auto at = [](const char *gate, GateRole role, double s) {
            return GatePassage{gate, role, fromSeconds(s), 0.01, 0};
        };
        const auto laps = lapsOf({at("early", GateRole::Split, 0.5), at("start", GateRole::Start, 1),
                                  at("start", GateRole::Start, 1.2), at("half", GateRole::Split, 2),
                                  at("half", GateRole::Split, 3), at("finish", GateRole::Finish, 5),
                                  at("finish", GateRole::Finish, 6), at("start", GateRole::Start, 7)});
        QCOMPARE(laps.size(), std::size_t(1));
        QCOMPARE(laps[0].timeS, 4.0);
        QCOMPARE(laps[0].sectors.size(), std::size_t(2));
        QCOMPARE(laps[0].sectors[1].timeS, 3.0);
        QVERIFY(lapsOf({}).empty());
    }
    void theCalibrationsShiftIsTheSameAtOneGate()
    {
        const GatePassage first{"line", GateRole::StartFinish, fromSeconds(1), 0.005, 0.004};
        const GatePassage second{"line", GateRole::StartFinish, fromSeconds(3), 0.005, 0.004};
        QVERIFY(std::abs(lapsOf({first, second})[0].sigmaS - std::sqrt(2.0) * 0.003) < 1e-12);
        GatePassage other = second;
        other.gate = "finish";
        other.role = GateRole::Finish;
        GatePassage begin = first;
        begin.role = GateRole::Start;
        QVERIFY(std::abs(lapsOf({begin, other})[0].sigmaS - std::sqrt(2.0) * 0.005) < 1e-12);
    }
    void aRobotThatStandsInTheGateHasNotPassedIt()
    {
        QVERIFY(passagesOf({start}, exactly(evenly({0.001, 0}, {0, 0}), 3, 0.002)).empty());
        // It was put there, so nobody knows when it came; driving on is no passage.
        QVERIFY(passagesOf({start}, exactly(evenly({0, 0}, {0.5, 0}), 3, 0.002)).empty());
    }
    void aRobotThatStopsInTheGateIsCountedOnceWithAWideSigma()
    {
        // Brakes evenly at 0.5 m/s² so as to stand on the line from 2 s to 4 s, then goes on as it came;
        // noise takes it to and fro over the line.
        const Course course = [](double t) {
            const double u = t < 2 ? t - 2 : t > 4 ? t - 4 : 0;
            return Truth{{u * std::abs(u) / 4, 0}, {std::abs(u) / 2, 0}, {u < 0 ? -0.5 : u > 0 ? 0.5 : 0, 0}};
        };
        // At ±2 mm of it: from 2 − √(4·0.002) s to 4 + √(4·0.002) s.
        const auto standing = passagesOf({start}, exactly(course, 6, 0.002));
        QCOMPARE(standing.size(), std::size_t(1));
        QVERIFY(std::abs(standing[0].sigmaS - (1 + std::sqrt(0.008))) < 0.005);
        for (unsigned seed = 0; seed < 100; ++seed) {
            std::mt19937 random(seed);
            const auto passages = passagesOf({start}, smoothed(course, 6, 0.002, random));
            QCOMPARE(passages.size(), std::size_t(1));
            const double time = toSeconds(passages[0].time), sigma = passages[0].sigmaS;
            QVERIFY2(time + 3 * sigma > 2 && time - 3 * sigma < 4, qPrintable(QString::number(time)));
        }
    }
    void noiseAtTheGateNeverCountsTwice()
    {
        // Creeps over the line at 20 mm/s with noise of 3 mm: raw positions cross it many times.
        for (unsigned seed = 0; seed < 50; ++seed) {
            std::mt19937 random(seed);
            QCOMPARE(passagesOf({start}, smoothed(evenly({-0.1, 0}, {0.02, 0}), 10, 0.003, random)).size(),
                     std::size_t(1));
        }
    }
    /// Just at the gate less is known of the place than the whole way to its ends is long.
    void aPlaceHardlyKnownAtTheGateMakesAWideSigma()
    {
        Run run = exactly(evenly({-0.1, 0}, {0.5, 0}), 0.4);
        for (std::size_t i = 4; i < 9; ++i) {
            run.points[i].sigmaXM = 1;
        }
        const auto passages = passagesOf({start}, run);
        QCOMPARE(passages.size(), std::size_t(1));
        QVERIFY2(passages.front().sigmaS > 0.15 && passages.front().sigmaS <= 0.2,
                 qPrintable(QString::number(passages.front().sigmaS)));
    }
    void whatHappensInAGapIsNotKnown()
    {
        Run run = exactly(evenly({-0.5, 0}, {0.5, 0}), 2);
        for (std::size_t i = 25; i < 36; ++i)
            run.points[i].valid = false;
        QVERIFY(passagesOf({start}, run).empty());
        QVERIFY(passagesOf({start}, {}).empty());
    }
    void theStatedSigmaIsTheScatter_data()
    {
        QTest::addColumn<double>("speedMps");
        QTest::addColumn<double>("sigmaM");
        QTest::newRow("fast") << 1.2 << 0.002;
        QTest::newRow("slow") << 0.2 << 0.002;
        QTest::newRow("noisy") << 0.6 << 0.006;
    }
    void theStatedSigmaIsTheScatter()
    {
        QFETCH(double, speedMps);
        QFETCH(double, sigmaM);
        constexpr int runs = 300;
        double squares = 0, stated = 0, lapSquares = 0, lapStated = 0;
        for (unsigned seed = 0; seed < runs; ++seed) {
            std::mt19937 random(seed);
            // Between frames at another place each time.
            const double offset = 0.5 + 0.03 * std::uniform_real_distribution<double>(0, 1)(random);
            const Gate near{"finish", GateRole::Finish, {0.5, -0.2}, {0.5, 0.2}};
            const Run run = smoothed(evenly({-offset, 0}, {speedMps, 0}), 1.6 / speedMps, sigmaM, random);
            const auto passages = passagesOf({start, near}, run);
            QCOMPARE(passages.size(), std::size_t(2));
            squares += std::pow(toSeconds(passages[0].time) - offset / speedMps, 2);
            stated += std::pow(passages[0].sigmaS, 2);
            const Lap lap = lapsOf(passages).at(0);
            lapSquares += std::pow(lap.timeS - 0.5 / speedMps, 2);
            lapStated += lap.sigmaS * lap.sigmaS;
        }
        const double ratio = std::sqrt(squares / stated), lapRatio = std::sqrt(lapSquares / lapStated);
        qInfo("scatter %.3f ms, scatter over stated %.3f; of the time between two gates %.3f",
              1e3 * std::sqrt(squares / runs), ratio, lapRatio);
        QVERIFY(ratio > 0.8 && ratio < 1.2);
        // Errors that are less than half a second apart go together, which the stated σ leaves out.
        QVERIFY(lapRatio > 0.6 && lapRatio < 1.2);
    }
};

ODOGRAPH_TEST(TestGatePassages, QCoreApplication)
#include "tst_gate_passages.moc"
