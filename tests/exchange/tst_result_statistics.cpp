// SPDX-License-Identifier: GPL-3.0-or-later
// Means and spreads of runs in groups, against numbers computed by hand and by definition.
#include "core/exchange/result_statistics.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <numeric>
#include <random>

using namespace odo;

namespace {

TrialTableRow run(const std::string &team, std::vector<std::optional<Metric>> metrics)
{
    TrialTableRow row;
    row.trial.teamName = team;
    row.robot = "Red";
    row.metrics = std::move(metrics);
    return row;
}

Metric speed(double value, std::optional<double> sigma = 0.02)
{
    return {"max_speed", "m/s", value, sigma};
}

/// Falcon 2, 4, 4, 4, 5, 5, 7, 9 (mean 5, deviation √(32/7)), Heron 1.5 alone.
ResultTable example()
{
    ResultTable table;
    table.columns = {{"max_speed", "m/s"}, {"gate_time", "s"}};
    for (const double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0})
        table.rows.push_back(run("Falcon", {speed(value), std::nullopt}));
    table.rows.push_back(run("Heron", {speed(1.5), std::nullopt}));
    return table;
}

std::vector<std::size_t> allRows(const ResultTable &table)
{
    std::vector<std::size_t> rows(table.rows.size());
    std::iota(rows.begin(), rows.end(), std::size_t(0));
    return rows;
}

std::vector<ResultStatistics> byTeam(const ResultTable &table, std::vector<std::size_t> columns = {0, 1})
{
    return resultStatistics(table, allRows(table), columns, {ResultGrouping::By::Team, {}});
}

} // namespace

class TestResultStatistics : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void ofATeam()
    {
        const auto found = byTeam(example());
        QCOMPARE(found.size(), std::size_t(2)); // nobody has the other metric
        const ResultStatistics &falcon = found.front();
        QCOMPARE(falcon.group, std::string("Falcon"));
        QCOMPARE(falcon.count, std::size_t(8));
        QCOMPARE(falcon.mean, 5.0);
        QCOMPARE(falcon.median, 4.5);
        QCOMPARE(*falcon.deviation, std::sqrt(32.0 / 7));
        QCOMPARE(*falcon.meanSigma, std::sqrt(32.0 / 7 / 8));
        QCOMPARE(*falcon.variation, std::sqrt(32.0 / 7) / 5);
        QCOMPARE(falcon.least, 2.0);
        QCOMPARE(falcon.most, 9.0);
        const ResultStatistics &heron = found.back();
        QCOMPARE(heron.mean, 1.5);
        QCOMPARE(heron.median, 1.5);
        QCOMPARE(*heron.meanSigma, 0.02); // of the run itself
        QVERIFY(!heron.deviation && !heron.variation);
    }

    void ofAll()
    {
        const ResultTable table = example();
        const std::vector<std::size_t> column{0};
        const auto found = resultStatistics(table, allRows(table), column, {});
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found.front().count, std::size_t(9));
        QCOMPARE(found.front().median, 4.0);
        const std::vector<std::size_t> two{0, 7};
        QCOMPARE(resultStatistics(table, two, column, {}).front().mean, 5.5);
    }

    void byAVariable()
    {
        ResultTable table = example();
        for (std::size_t row : {0U, 1U})
            table.rows[row].trial.variables["surface"] = "carpet";
        const std::vector<std::size_t> column{0};
        const auto found =
            resultStatistics(table, allRows(table), column, {ResultGrouping::By::Variable, "surface"});
        QCOMPARE(found.size(), std::size_t(2));
        QCOMPARE(found.front().group, std::string()); // the runs without one
        QCOMPARE(found.front().count, std::size_t(7));
        QCOMPARE(found.back().group, std::string("carpet"));
        QCOMPARE(found.back().mean, 3.0);
    }

    /// Bad runs, lower bounds and what was measured by another course are in the table, but not in its means.
    void whatDoesNotCount()
    {
        ResultTable table = example();
        table.rows[7].metrics[0]->isAtLeast = true;
        table.rows[6].verdict =
            TrialVerdict{{{"views_agree", CheckLevel::Bad, foreignWords("They differ.")}}};
        table.rows[5].verdict = TrialVerdict{{{"few_gaps", CheckLevel::Doubtful, foreignWords("Gaps.")}}};
        table.rows[4].metrics[0]->value = std::nan("");
        QCOMPARE(byTeam(table).front().count, std::size_t(5)); // a doubtful one counts
        for (TrialTableRow &row : table.rows) {
            row.isMeasuredOtherwise = true;
            row.metrics[1] = Metric{"gate_time", "s", 3, 0.1};
        }
        QVERIFY(metricIsOfTask("gate_time"));
        const auto found = byTeam(table);
        QCOMPARE(found.size(), std::size_t(2)); // of the top speed alone
        QCOMPARE(found.front().column, std::size_t(0));
    }

    /// The stated error of the mean is how far means of so many runs scatter.
    void errorOfTheMean()
    {
        std::mt19937 random(7);
        std::normal_distribution<double> noise(2, 0.3);
        double squares = 0, stated = 0;
        constexpr int draws = 2000, runs = 6;
        for (int i = 0; i < draws; ++i) {
            ResultTable table;
            table.columns = {{"max_speed", "m/s"}};
            for (int j = 0; j < runs; ++j)
                table.rows.push_back(run("", {speed(noise(random))}));
            const ResultStatistics found = byTeam(table, {0}).front();
            squares += (found.mean - 2) * (found.mean - 2);
            stated += *found.meanSigma * *found.meanSigma;
        }
        const double ratio = std::sqrt(squares / stated);
        QVERIFY2(ratio > 0.93 && ratio < 1.07, qPrintable(QString::number(ratio)));
    }

private:
    static bool metricIsOfTask(const char *name)
    {
        ResultTable table;
        table.columns = {{name, "s"}};
        table.rows = {run("", {Metric{name, "s", 3, {}}})};
        const bool before = isUsed(table, 0, 0);
        table.rows.front().isMeasuredOtherwise = true;
        return before && !isUsed(table, 0, 0);
    }
};

ODOGRAPH_TEST(TestResultStatistics, QCoreApplication)
#include "tst_result_statistics.moc"
