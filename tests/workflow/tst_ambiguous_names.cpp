// SPDX-License-Identifier: GPL-3.0-or-later
// When robots of one look could not be told apart is kept with the analysis: made again it keeps them,
// tracked again it has new ones.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track/settled_views.h"
#include "core/workflow/track/track_job.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace std::chrono_literals;

class TestAmbiguousNames : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theyAreStoredByTheRobotsNames()
    {
        std::vector<RobotRecord> robots(3);
        for (std::size_t r = 0; r < robots.size(); ++r) {
            robots[r].id = RecordId(10 + r);
            robots[r].name = "Blue " + std::to_string(r);
        }
        const auto stored =
            ambiguousNamesOf({{0, 1, 1.5, {2}}, {0, 4, 4.25, {1, 2}}, {2, 1, 1.5, {}}}, robots);
        QCOMPARE(stored.size(), std::size_t(3));
        QCOMPARE(stored[0].size(), std::size_t(2));
        QVERIFY(stored[0][1].from == 4s && stored[0][1].to == 4250ms);
        QVERIFY((stored[0][1].others == std::vector<RecordId>{11, 12}));
        QVERIFY((stored[0][1].otherNames == std::vector<std::string>{"Blue 1", "Blue 2"}));
        QVERIFY(stored[1].empty() && stored[2].front().others.empty());
        QCOMPARE(ambiguousSeconds(stored[0]), 0.75);
        QCOMPARE(ambiguousSeconds({}), 0.0);
    }

    void analysedAgainTheyStayAndTrackedAgainTheyAreNew()
    {
        const QTemporaryDir folder;
        const auto project = openStoredExample(folder.path().toStdString());
        const TrialRecord trial = project->trials().find("Trial 1").value();
        AnalysisRecord analysis = project->analyses().current(trial.id)->front();
        QVERIFY(analysis.ambiguousNames.empty());
        const RecordId other = project->robots().find("Blue 1")->id;
        analysis.ambiguousNames = {{500ms, 700ms, {other}, {}}};
        QVERIFY(project->analyses().add(analysis));
        const auto track = [&](bool again) {
            TrackSettings settings;
            settings.again = again;
            TrackJob job("Trial 1", settings);
            const auto done = runToEnd(job, *project, JobControl());
            if (!done)
                qWarning("%s", done.error().message().c_str());
            return job.outcome();
        };
        const TrackOutcome again = track(true);
        QCOMPARE(again.robots.size(), std::size_t(1));
        QCOMPARE(again.robots.front().ambiguousS.value_or(-1), 0.2);
        const auto kept = project->analyses().current(trial.id)->front().ambiguousNames;
        QCOMPARE(kept.size(), std::size_t(1));
        QVERIFY(kept.front().from == 500ms && kept.front().to == 700ms);
        QVERIFY((kept.front().otherNames == std::vector<std::string>{"Blue 1"}));
        QVERIFY(std::ranges::any_of(again.warnings, [](const Message &warning) {
            return warning.english().find("this may be Red 2 or Blue 1") != std::string::npos;
        }));

        const TrackOutcome anew = track(false);
        QCOMPARE(anew.robots.size(), std::size_t(1));
        QCOMPARE(anew.robots.front().ambiguousS.value_or(-1), 0.0);
        QVERIFY(project->analyses().current(trial.id)->front().ambiguousNames.empty());
        const TrackOutcome last = track(true);
        QVERIFY(!last.robots.front().ambiguousS); // none is stored, which may be as none was noted
    }
};

ODOGRAPH_TEST(TestAmbiguousNames, QCoreApplication)
#include "tst_ambiguous_names.moc"
