// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/term_progress.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <numbers>
#include <random>

using namespace odo;

class TestTermProgress : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// By hand: days 0 1 2 3, values 1 2 2 3. Mean 1.5 and 2; slope Σ(−1.5·−1 − 0.5·0 + 0.5·0 + 1.5·1)/5 =
    /// 0.6; left over −0.1, 0.3, −0.3, 0.1, squares 0.2; spread √(0.2/2); σ of the slope √(0.1/5).
    void lineByHand()
    {
        const TermProgress progress = termProgress({{0, 1}, {1, 2}, {2, 2}, {3, 3}}, false);
        QCOMPARE(progress.count, 4);
        QCOMPARE(progress.best, 3.0);
        QCOMPARE(progress.median, 2.0);
        QCOMPARE(*progress.spread, std::sqrt(0.1));
        QCOMPARE(progress.change->value, 1.8);
        QCOMPARE(progress.change->sigma, 3 * std::sqrt(0.02));
        QCOMPARE(progress.atStart, 1.1);
        QVERIFY(!progress.isBeyondSpread == (1.8 <= 4.3027 * 3 * std::sqrt(0.02))); // 1.825: only just not
        QVERIFY(!progress.isBeyondSpread);
        QCOMPARE(termProgress({{0, 1}, {1, 2}, {2, 2}, {3, 3}}, true).best, 1.0);
    }

    void fewRuns()
    {
        const TermProgress one = termProgress({{5, 7}}, false);
        QVERIFY(one.count == 1 && one.best == 7 && one.median == 7 && !one.spread && !one.change &&
                !one.isBeyondSpread);
        const TermProgress two = termProgress({{5, 7}, {9, 9}}, false);
        QVERIFY(!two.change && !two.isBeyondSpread);
        QCOMPARE(*two.spread, std::sqrt(2.0));
        const TermProgress sameDay = termProgress({{5, 7}, {5, 9}, {5, 8}}, false);
        QVERIFY(!sameDay.change);
        QCOMPARE(*sameDay.spread, 1.0);
    }

    /// Without progress the test says there is some in 5 of 100 terms. Of 4000 terms the share is known to
    /// 0.35 %.
    void isRightInNineteenOfTwenty_data()
    {
        QTest::addColumn<int>("runs");
        for (const int runs : {3, 4, 10, 40})
            QTest::addRow("%d runs", runs) << runs;
    }
    void isRightInNineteenOfTwenty()
    {
        QFETCH(const int, runs);
        std::mt19937 random(7);
        std::normal_distribution<double> noise(9.8, 0.3);
        std::uniform_real_distribution<double> day(0, 90);
        int wrong = 0;
        constexpr int terms = 4000;
        for (int term = 0; term < terms; ++term) {
            std::vector<TermValue> termValues;
            for (int run = 0; run < runs; ++run)
                termValues.push_back({day(random), noise(random)});
            wrong += termProgress(termValues, true).isBeyondSpread ? 1 : 0;
        }
        QVERIFY2(std::abs(wrong / double(terms) - 0.05) < 4 * 0.0035, qPrintable(QString::number(wrong)));
    }

    /// Pooled by hand: squares 2 (about 10) and 2 (about 13), degrees 2 and 2: spread 1.
    void ranksByWhatIsBeyondDoubt()
    {
        std::vector<TeamStatistics> teams(4);
        teams[0].values = {9, 10, 11};
        teams[1].values = {12, 13, 14};
        teams[2].values = {10.5};
        rankTeams(teams, true);
        const double ofThree = std::sqrt(std::numbers::pi / 2 / 3);
        QCOMPARE(teams[0].sigma, ofThree);
        QCOMPARE(teams[2].sigma, 1.0);
        QCOMPARE(teams[0].rank, 1);
        QCOMPARE(teams[1].rank, 3); // 3 of 1.96·√2·0.72 = 2.0 behind the first; 2.5 of 2.4 behind the third
        QCOMPARE(teams[2].rank, 1); // 0.5 is nothing
        QCOMPARE(teams[3].rank, 0); // no run
        QCOMPARE(teams[1].median, 13.0);
        rankTeams(teams, false);
        QCOMPARE(teams[1].rank, 1);
        QCOMPARE(teams[0].rank, 2);
    }

    /// One run each, ±0.05: 0.07 is within 1.96·√2·0.05 = 0.139, 0.8 is not. Where repeated runs spread more
    /// than that, their spread counts, which contains it.
    void theMeasurementsOwnUncertaintyCounts()
    {
        std::vector<TeamStatistics> teams(3);
        teams[0].values = {8.20};
        teams[1].values = {8.27};
        teams[2].values = {9.00};
        for (TeamStatistics &team : teams)
            team.runSigma = 0.05;
        rankTeams(teams, true);
        QCOMPARE(teams[0].sigma, 0.05);
        QCOMPARE(teams[0].rank, 1);
        QCOMPARE(teams[1].rank, 1);
        QCOMPARE(teams[2].rank, 3);
        teams[0].runSigma = 0; // of a track that came without one
        rankTeams(teams, true);
        QCOMPARE(teams[1].rank, 1); // 0.07 of 0.098
        teams[2].values = {9.00, 7.00};
        rankTeams(teams, true);
        QCOMPARE(teams[0].sigma, std::numbers::sqrt2);
        QCOMPARE(teams[2].sigma, 1.0);
    }

    void withoutASpreadEveryDifferenceCounts()
    {
        std::vector<TeamStatistics> teams(3);
        teams[0].values = {2};
        teams[1].values = {1};
        teams[2].values = {1};
        rankTeams(teams, true);
        QCOMPARE(teams[0].rank, 3);
        QCOMPARE(teams[1].rank, 1);
        QCOMPARE(teams[2].rank, 1);
    }
};

ODOGRAPH_TEST(TestTermProgress, QCoreApplication)
#include "tst_term_progress.moc"
