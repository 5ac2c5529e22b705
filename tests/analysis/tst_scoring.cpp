// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/scoring.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <limits>

using namespace odo;

namespace {

constexpr double exact = 1e-12; // sums of a few products

Score scoreOfTime(double seconds, std::optional<double> sigma = {})
{
    return scoreOf({{"gate_time", 4, 10, 30}}, {{"gate_time", "s", seconds, sigma}});
}

} // namespace

class TestScoring : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void pointsLieEvenlyBetweenTheBounds_data();
    void pointsLieEvenlyBetweenTheBounds();
    void moreCanBeBetter();
    void aPenaltyTakesPointsOff();
    void whatIsNotMeasuredGivesNothing();
    void theErrorOfAFigureIsThatOfItsPoints();
    void countsAreOfSpikesBreachesAndGates();
    void refusesWhatCannotBeComputed_data();
    void refusesWhatCannotBeComputed();
};

void TestScoring::pointsLieEvenlyBetweenTheBounds_data()
{
    QTest::addColumn<double>("seconds");
    QTest::addColumn<double>("points");
    QTest::newRow("far better") << 1.0 << 30.0;
    QTest::newRow("at the full bound") << 4.0 << 30.0;
    QTest::newRow("a third of the way") << 6.0 << 20.0;
    QTest::newRow("at the other bound") << 10.0 << 0.0;
    QTest::newRow("far worse") << 99.0 << 0.0;
}

void TestScoring::pointsLieEvenlyBetweenTheBounds()
{
    QFETCH(double, seconds);
    QFETCH(double, points);
    const Score score = scoreOfTime(seconds);
    QVERIFY(std::abs(score.points - points) < exact);
    QCOMPARE(score.most, 30.0);
    QVERIFY(std::abs(score.lines.front().share - points / 30) < exact);
}

void TestScoring::moreCanBeBetter()
{
    const Score score = scoreOf({{"path_completed", 1, 0.5, 10}}, {{"path_completed", "1", 0.75, {}}});
    QVERIFY(std::abs(score.points - 5) < exact);
}

void TestScoring::aPenaltyTakesPointsOff()
{
    // A point a spike, ten at most; it adds nothing to what can be had.
    const std::vector<Criterion> rubric{{"gate_time", 4, 10, 30}, {"spikes", 10, 0, -10}};
    const Score score = scoreOf(rubric, {{"gate_time", "s", 4, {}}, {"spikes", "1", 3, {}}});
    QVERIFY(std::abs(score.points - 27) < exact);
    QCOMPARE(score.most, 30.0);
    QVERIFY(std::abs(score.lines[1].points + 3) < exact);
}

void TestScoring::whatIsNotMeasuredGivesNothing()
{
    const Score score = scoreOf({{"best_lap", 4, 10, 30}, {"laps", 0, 3, -5}},
                                {{"best_lap", "s", std::numeric_limits<double>::quiet_NaN(), {}}});
    QCOMPARE(score.points, 0.0);
    QVERIFY(!score.lines[0].metric && !score.lines[1].metric);
    QVERIFY(scoreOf({}, {}).lines.empty());
}

void TestScoring::theErrorOfAFigureIsThatOfItsPoints()
{
    // 5 points a second.
    QVERIFY(std::abs(scoreOfTime(7, 0.2).sigma - 1) < exact);
    // At a bound half of the error still counts; far beyond it none.
    QVERIFY(std::abs(scoreOfTime(4, 0.2).sigma - 0.5) < exact);
    QCOMPARE(scoreOfTime(2, 0.2).sigma, 0.0);
    const std::vector<Metric> metrics{{"a", "s", 7, 0.6}, {"b", "s", 7, 0.8}};
    const Score both = scoreOf({{"a", 4, 10, 30}, {"b", 10, 4, -30}}, metrics);
    QVERIFY(std::abs(both.sigma - 5) < exact); // 3 and 4
}

void TestScoring::countsAreOfSpikesBreachesAndGates()
{
    std::vector<Spike> spikes(4);
    spikes[0].flags = flagBit(SampleFlag::Jump);
    spikes[1].flags = flagBit(SampleFlag::Jump) | flagBit(SampleFlag::SpeedLimit);
    spikes[2].flags = flagBit(SampleFlag::AccelerationLimit);
    spikes[3].flags = flagBit(SampleFlag::Lost);
    std::vector<GatePassage> passages(3);
    passages[0].gate = passages[2].gate = "line";
    passages[1].gate = "half-way";
    const std::vector<Metric> counts = scoringMetrics(spikes, passages);
    QCOMPARE(counts.size(), std::size_t(3));
    QCOMPARE(counts[0].name, std::string("spikes"));
    QCOMPARE(counts[0].value, 4.0);
    QCOMPARE(counts[1].name, std::string("limit_breaches"));
    QCOMPARE(counts[1].value, 2.0);
    QCOMPARE(counts[2].name, std::string("gates_passed"));
    QCOMPARE(counts[2].value, 2.0);
}

void TestScoring::refusesWhatCannotBeComputed_data()
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    QTest::addColumn<QString>("metric");
    QTest::addColumn<double>("full");
    QTest::addColumn<double>("none");
    QTest::addColumn<double>("points");
    QTest::addColumn<QString>("why");
    QTest::newRow("no figure") << "" << 1.0 << 2.0 << 3.0 << "it names no metric";
    QTest::newRow("no number") << "laps" << nan << 2.0 << 3.0 << "one of its values is not a number";
    QTest::newRow("equal bounds") << "laps" << 2.0 << 2.0 << 3.0
                                  << "full points and no points have the same value";
    QTest::newRow("no points") << "laps" << 1.0 << 2.0 << 0.0 << "its points are 0 or beyond ±1000";
    QTest::newRow("too many points") << "laps" << 1.0 << 2.0 << 1001.0 << "its points are 0 or beyond ±1000";
}

void TestScoring::refusesWhatCannotBeComputed()
{
    QFETCH(QString, metric);
    QFETCH(double, full);
    QFETCH(double, none);
    QFETCH(double, points);
    QFETCH(QString, why);
    const Criterion good{"laps", 3, 0, 10};
    QVERIFY(checkScoring({}) && checkScoring({good}));
    const auto refused = checkScoring({good, {metric.toStdString(), full, none, points}});
    QVERIFY(!refused);
    QCOMPARE(refused.error().what.english(), std::string("line 2 of the scoring"));
    QCOMPARE(QString::fromStdString(refused.error().why.english()), why);
    QCOMPARE(checkScoring(std::vector<Criterion>(31, good)).error().why.english(),
             std::string("it has more than 30 lines"));
}

ODOGRAPH_TEST(TestScoring, QCoreApplication)
#include "tst_scoring.moc"
