// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/compare/trial_metrics.h"

#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;

namespace {

/// Trials of two teams of 9B and one of 9C, a day apart, with their times.
struct Term
{
    std::vector<TrialRecord> trials;
    std::vector<TrialMetric> metrics;

    TrialRecord &add(RecordId team, const char *className, std::optional<double> seconds)
    {
        TrialRecord trial;
        trial.id = static_cast<RecordId>(trials.size()) + 1;
        trial.name = "Trial " + std::to_string(trial.id);
        trial.team = team;
        trial.teamName = "Team " + std::to_string(team);
        trial.className = className;
        trial.task = "Slalom";
        trial.date = Instant(std::chrono::hours(24 * trial.id));
        if (seconds)
            metrics.push_back({trial.id, 1, {"gate_time", "s", *seconds, 0.01}});
        return trials.emplace_back(trial);
    }
    Standings standings(const StandingsChoice &choice) const
    {
        std::vector<const TrialRecord *> pointers;
        for (const TrialRecord &trial : trials)
            pointers.push_back(&trial);
        return standingsOf(pointers, metrics, choice);
    }
};

} // namespace

class TestStandings : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void teamsAreRankedOfWhatCounts()
    {
        Term term;
        for (const double seconds : {12.0, 11.0, 10.0})
            term.add(1, "9B", seconds);
        for (const double seconds : {8.2, 8.1, 8.3})
            term.add(2, "9B", seconds);
        term.add(3, "9C", 9.0);
        term.add(2, "9B", std::nullopt); // not tracked
        term.add(1, "9B", 1.0).binned = Instant();
        term.add(1, "9B", 2.0).task = "Circle";
        term.add(0, "", 3.0); // of no team
        const Standings all = term.standings({"", "Slalom", "gate_time"});
        QVERIFY(all.isLessBetter);
        QCOMPARE(all.teams.size(), std::size_t(3));
        QCOMPARE(all.teams[0].team, std::string("Team 2"));
        QCOMPARE(all.teams[0].statistics.median, 8.2);
        QCOMPARE(all.teams[0].progress.best, 8.1);
        QCOMPARE(all.teams[2].team, std::string("Team 1"));
        QCOMPARE(all.teams[2].runs.size(), std::size_t(3));
        QCOMPARE(all.teams[2].progress.change->value, -2.0); // a straight line of one second a day
        QVERIFY(all.teams[2].progress.isBeyondSpread);
        QVERIFY(!all.teams[0].progress.isBeyondSpread);
        const Standings ofClass = term.standings({"9C", "Slalom", "gate_time"});
        QCOMPARE(ofClass.teams.size(), std::size_t(1));
        QCOMPARE(ofClass.teams[0].statistics.rank, 1);
        QVERIFY(term.standings({"8A", "", "gate_time"}).teams.empty());
    }

    /// A second in the circle is not a second in the slalom.
    void runsOfDifferentTasksAreNotRanked()
    {
        Term term;
        for (const double seconds : {12.0, 11.0, 10.0})
            term.add(2, "9B", seconds);
        for (const double seconds : {2.0, 2.1})
            term.add(1, "9B", seconds).task = "Circle";
        const Standings all = term.standings({"", "", "gate_time"});
        QVERIFY(!all.isRanked());
        QCOMPARE(all.teams.size(), std::size_t(2));
        QCOMPARE(all.teams[0].team, std::string("Team 1")); // by name
        QVERIFY(all.teams[0].statistics.rank == 0 && all.teams[1].statistics.rank == 0);
        QVERIFY(term.standings({"", "Slalom", "gate_time"}).isRanked());
    }

    /// Times of ±0.01 s: 0.02 s is no difference between two runs, 0.05 s is one.
    void runsThatDoNotDifferSignificantlyShareARank()
    {
        Term term;
        term.add(1, "9B", 8.02);
        term.add(2, "9B", 8.00);
        term.add(3, "9B", 8.05);
        const Standings standings = term.standings({"", "Slalom", "gate_time"});
        QCOMPARE(standings.teams[0].team, std::string("Team 2"));
        QCOMPARE(standings.teams[0].statistics.rank, 1);
        QCOMPARE(standings.teams[1].team, std::string("Team 1"));
        QCOMPARE(standings.teams[1].statistics.rank, 1);
        QCOMPARE(standings.teams[2].statistics.rank, 3);
        QCOMPARE(standings.teams[0].statistics.sigma, 0.01);
    }

    void theBestRunIsNamed()
    {
        Term term;
        for (const double seconds : {9.0, 8.0, 8.0, 8.5})
            term.add(1, "9B", seconds);
        const TeamStanding team = term.standings({"", "Slalom", "gate_time"}).teams.front();
        QCOMPARE(team.bestRun().trial, std::string("Trial 2"));
        QCOMPARE(team.bestRun().robot, RecordId(1));
    }

    /// Of several robots the best one counts, whichever way that is.
    void theBestRobotCounts()
    {
        Term term;
        const RecordId trial = term.add(1, "9B", 5.0).id;
        term.metrics.push_back({trial, 2, {"gate_time", "s", 4.0, 0.01}});
        const TeamStanding team = term.standings({"", "", "gate_time"}).teams.at(0);
        QCOMPARE(team.progress.best, 4.0);
        QCOMPARE(team.bestRun().robot, RecordId(2));
        QCOMPARE(term.standings({"", "", "max_speed"}).teams.at(0).progress.best, 5.0);
    }
};

ODOGRAPH_TEST(TestStandings, QCoreApplication)
#include "tst_standings.moc"
