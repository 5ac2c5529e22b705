// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/quantity_curve.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>

using namespace odo;

namespace {

constexpr int hourSamples = 216'000; // at 60 frames/s

/// A sine against seconds, with a band of ±1.96 · sigma.
CurveRun sine(int samples, double sigma = 0)
{
    CurveRun run;
    for (int i = 0; i < samples; ++i)
        run.points.emplace_back(i / 60.0, CurveValue{std::sin(i * 0.01), sigma});
    return run;
}

std::vector<CurveRun> only(const CurveRun &run)
{
    return {run};
}

double lowest(const std::vector<CurveColumn> &columns)
{
    return std::ranges::min_element(columns, {}, &CurveColumn::low)->low;
}

double highest(const std::vector<CurveColumn> &columns)
{
    return std::ranges::max_element(columns, {}, &CurveColumn::high)->high;
}

} // namespace

class TestCurveColumns : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void noPeakIsLost()
    {
        CurveRun run = sine(hourSamples);
        run.points[54'321].value = 99; // one frame alone
        run.points[177'777].value = -99;
        constexpr int count = 1000;
        const auto columns = curveColumns(only(run), 0, 3600, count);
        QCOMPARE(columns.size(), std::size_t(count)); // 216 points each
        QCOMPARE(columns[std::size_t(54'321 / 216)].high, 99.0);
        QCOMPARE(columns[std::size_t(177'777 / 216)].low, -99.0);
        QCOMPARE(std::ranges::count_if(columns, [](const CurveColumn &each) { return each.high > 1; }), 1);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            QCOMPARE(columns[i].index, int(i));
            QCOMPARE(columns[i].isJoined, i > 0);
        }
    }
    void aColumnReachesToTheOneBeforeAsALineDoes()
    {
        CurveRun steps; // from 0 to 5 between two columns
        for (int i = 0; i < 40; ++i)
            steps.points.emplace_back(i, CurveValue{i < 20 ? 0.0 : 5.0, 0});
        const auto line = curveColumns(only(steps), 0, 40, 4);
        QCOMPARE(line[1].high, 0.0);
        QCOMPARE(line[2].low, 0.0);
        QCOMPARE(line[2].high, 5.0);
        const auto points = curveColumns(only(steps), 0, 40, 4, ColumnReach::Points);
        QCOMPARE(points[2].low, 5.0);
        QVERIFY(!points[2].isJoined);
    }
    void theBandHasItsOwnExtremes()
    {
        const auto columns = curveColumns(only(sine(hourSamples, 0.5)), 0, 3600, 300);
        // The sine goes through a whole wave in each column: ±1, and its band beyond it by 1.96 · 0.5.
        QVERIFY(std::abs(columns[7].bandHigh - (1 + 0.98)) < 1e-3);
        QVERIFY(std::abs(columns[7].bandLow - (-1 - 0.98)) < 1e-3);
    }
    void gapsPartColumns()
    {
        CurveRun early = sine(6000), late = sine(6000);
        for (BandPoint &point : late.points)
            point.x += 200; // from 100 s to 200 s there is nothing
        const std::vector<CurveRun> runs{early, late};
        const auto columns = curveColumns(runs, 0, 300, 300);
        QCOMPARE(columns.size(), std::size_t(200));
        QCOMPARE(columns[99].index, 99);
        QCOMPARE(columns[100].index, 200);
        QVERIFY(!columns[100].isJoined && columns[101].isJoined);
    }
    void runsOfOneColumnBecomeOne()
    {
        std::vector<CurveRun> runs(3);
        for (int i = 0; i < 3; ++i)
            runs[std::size_t(i)].points = {BandPoint(0.1 * i, {double(i), 0}),
                                           BandPoint(0.1 * i + 0.05, {double(-i), 0})};
        const auto columns = curveColumns(runs, 0, 10, 10);
        QCOMPARE(columns.size(), std::size_t(1));
        QCOMPARE(columns[0].low, -2.0);
        QCOMPARE(columns[0].high, 2.0);
    }
    void aPartHasItsNeighbours()
    {
        const CurveRun run = sine(hourSamples);
        const auto visible = visiblePoints(run.points, 10, 10.1);
        QCOMPARE(visible.size(), std::size_t(9)); // 7 inside, one beyond either end
        QVERIFY(visible.front().x < 10 && visible.back().x > 10.1);
        QCOMPARE(visibleCount(only(run), 10, 10.1), std::size_t(9));
        QVERIFY(visiblePoints(run.points, 5000, 6000).empty());
        QVERIFY(visiblePoints(run.points, -7, -1).empty());
        const auto columns = curveColumns(only(run), 1600, 1700, 500);
        QVERIFY(lowest(columns) >= -1 && highest(columns) <= 1);
        QCOMPARE(columns.front().index, 0);
        QCOMPARE(columns.back().index, 499); // what stands beyond is in no column
    }
    void nothingHasNoColumns()
    {
        QVERIFY(curveColumns({}, 0, 1, 100).empty());
        const CurveRun run = sine(100);
        QVERIFY(curveColumns(only(run), 1, 1, 100).empty());
        QVERIFY(curveColumns(only(run), 0, 1, 0).empty());
        QVERIFY(curveColumns(only(run), 50, 60, 100).empty());
    }
    void gapsSplitValuesIntoRuns()
    {
        std::vector<std::optional<CurveValue>> values(10, CurveValue{2, 0.25});
        values[0].reset();
        values[4].reset();
        values[5].reset();
        std::vector<double> positions;
        for (int i = 0; i < 10; ++i)
            positions.push_back(3 * i);
        const auto runs = curveRuns(values, positions, {{0, 9}});
        QCOMPARE(runs.size(), std::size_t(2));
        QCOMPARE(runs[0].firstSample, std::size_t(1));
        QCOMPARE(runs[1].points.front().x, 18.0);
        QCOMPARE(runs[1].points.size(), std::size_t(4));
        QVERIFY(std::abs(runs[0].points[0].high() - (2 + 1.96 * 0.25)) < 1e-4);
        QVERIFY(std::abs(runs[0].points[0].curveValue().sigma - 0.25) < 1e-6); // single precision
    }
    /// 30 positions a second: ten rows without one, then none for half a second, then a gap of two seconds.
    void bridgedStretchesAndGapsSplitAProfile()
    {
        Profile profile;
        profile.points.resize(60);
        profile.samples.resize(60);
        std::vector<std::optional<CurveValue>> values(60, CurveValue{1, 0.1});
        std::vector<double> positions;
        for (std::size_t i = 0; i < 60; ++i) {
            positions.push_back(double(i) / 30 + (i >= 40 ? 0.5 : 0) + (i >= 50 ? 2 : 0));
            profile.points[i].position = profile.points[i].velocity = {0, 0};
            profile.points[i].valid = true;
            profile.samples[i].time = fromSeconds(positions.back());
            if (i <= 20 || i > 30)
                profile.samples[i].position = Eigen::Vector2d(0, 0);
        }
        const std::vector<ProfilePiece> pieces = piecesOf(profile);
        const std::vector<std::array<std::size_t, 3>> expected{{0, 20, 0},  {20, 31, 1}, {31, 39, 0},
                                                               {39, 40, 1}, {40, 49, 0}, {50, 59, 0}};
        QCOMPARE(pieces.size(), expected.size());
        for (std::size_t i = 0; i < pieces.size(); ++i)
            QCOMPARE((std::array<std::size_t, 3>{pieces[i].first, pieces[i].last, pieces[i].isBridged}),
                     expected[i]);
        QCOMPARE(curveRuns(values, positions, pieces).size(), std::size_t(4));
        const auto bridged = curveRuns(values, positions, pieces, true);
        QCOMPARE(bridged.size(), std::size_t(2));
        QCOMPARE(bridged[0].firstSample, std::size_t(20));
        QCOMPARE(bridged[0].points.size(), std::size_t(12));
        QVERIFY(piecesOf(Profile()).empty());
    }
};

ODOGRAPH_TEST(TestCurveColumns, QCoreApplication)
#include "tst_curve_columns.moc"
