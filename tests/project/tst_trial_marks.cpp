// SPDX-License-Identifier: GPL-3.0-or-later
// Stars, tags, archive and bin of trials, and removing them for good.
#include "core/project/internal/connection.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/project/sample_records.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestTrialMarks : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = m_folder->filePath(QStringLiteral("year.odo")).toStdString();
        m_project = std::move(*Project::create(m_file, "Year"));
        RecordSource source(3);
        m_filled = *fill(*m_project, source);
    }

    void marksAreKept()
    {
        TrialRepository &trials = m_project->trials();
        QVERIFY(!trial().starred && trial().tags.empty() && !trial().archived && !trial().binned);
        QVERIFY(trials.setStarred(m_filled.trial, true));
        QVERIFY(trials.setTags(m_filled.trial, {"wet floor", "été", "wet floor", "final"}));
        QVERIFY(trials.setArchived(m_filled.trial, true));
        QVERIFY(trials.setBinned(m_filled.trial, true));
        m_project = std::move(*Project::open(m_file, Project::Access::ReadWrite));
        QVERIFY(trial().starred && trial().archived && trial().binned);
        QCOMPARE(trial().tags, (std::vector<std::string>{"final", "wet floor", "été"}));
        QCOMPARE(m_project->trials().tags().value(), trial().tags);
        const Instant since = *trial().archived;
        QVERIFY(m_project->trials().setArchived(m_filled.trial, true)); // again changes nothing
        QVERIFY(trial().archived == since);
        QVERIFY(m_project->trials().setArchived(m_filled.trial, false));
        QVERIFY(m_project->trials().setBinned(m_filled.trial, false));
        QVERIFY(!trial().archived && !trial().binned);
    }

    void aTagIsAName()
    {
        QVERIFY(m_project->trials().setTags(m_filled.trial, {"good"}));
        const auto refused = m_project->trials().setTags(m_filled.trial, {"fine", "two\nlines"});
        QCOMPARE(refused.error().code, ErrorCode::InvalidInput);
        QCOMPARE(trial().tags, std::vector<std::string>{"good"});
    }

    void aTrialThatIsBeingRecordedIsNotBinned()
    {
        TrialRecord begun;
        begun.name = "now";
        const auto added = m_project->trials().begin(begun, {});
        QVERIFY(added.has_value());
        QCOMPARE(m_project->trials().setBinned(added->id, true).error().message(),
                 std::string("trial 'now': it is being recorded; end its recording first"));
    }

    void onlyWhatIsInTheBinIsRemovedForGood()
    {
        TrialRepository &trials = m_project->trials();
        const auto refused = trials.removeForGood(m_filled.trial);
        QCOMPARE(refused.error().code, ErrorCode::InvalidInput);
        QVERIFY(refused.error().message().find("it is not in the bin; move it to the bin first") !=
                std::string::npos);
        QVERIFY(trials.currentObservations(m_filled.recordings.front(), m_filled.robot)->has_value());

        std::vector<std::string> paths;
        ImportedTrack track{m_filled.trial, m_filled.robot,         {}, "run.tum", "00ff", 9,
                            "tum",          foreignWords("metres"), {}};
        track.samples.emplace_back();
        QVERIFY(trials.addImportedTrack(track));
        const auto recordings = trials.recordings(m_filled.trial).value();
        for (const RecordingRecord &recording : recordings)
            paths.push_back(recording.path);
        QVERIFY(trials.setBinned(m_filled.trial, true));
        const auto removed = trials.removeForGood(m_filled.trial);
        QVERIFY2(removed, removed ? "" : removed.error().message().c_str());
        QCOMPARE(*removed, paths);
        QVERIFY(trials.all()->empty());
        for (const ProjectProblem &problem : m_project->check(false).value_or(std::vector<ProjectProblem>()))
            QVERIFY2(problem.what.english().find("calibration image") != std::string::npos,
                     problem.what.english().c_str()); // never were
        const auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadOnly);
        for (const char *table :
             {"observation_series", "observation_chunk", "raw_time_chunk", "frame_time_chunk", "recording",
              "analysis", "analysis_chunk", "analysis_digest", "metric", "spike", "truth", "imported_track",
              "imported_track_chunk"}) {
            const QString count = QStringLiteral("SELECT COUNT(*) FROM %1").arg(QLatin1String(table));
            QVERIFY2((*connection)->number(count).value() == 0, table);
        }
    }

    /// Nobody deletes raw measurements by a statement of his own, not even of a trial in the bin.
    void rawMeasurementsOfATrialInTheBinAreKept()
    {
        ImportedTrack track{m_filled.trial, m_filled.robot,         {}, "run.tum", "00ff", 9,
                            "tum",          foreignWords("metres"), {}};
        track.samples.emplace_back();
        QVERIFY(m_project->trials().addImportedTrack(track));
        QVERIFY(m_project->trials().setBinned(m_filled.trial, true));
        const auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadWrite);
        QVERIFY(!(*connection)->execute(QStringLiteral("UPDATE imported_track SET file='other'")));
        for (const char *table : {"observation_series", "observation_chunk", "imported_track"})
            QVERIFY(!(*connection)->execute(QStringLiteral("DELETE FROM %1").arg(QLatin1String(table))));
    }

    void teamsHavePseudonyms()
    {
        QVERIFY(m_project->teams().add({0, "Anna and Ben", "9B", "Team 4"}));
        QCOMPARE(m_project->teams().find("Anna and Ben")->pseudonym, std::string("Team 4"));
    }

    void teamsAreChanged()
    {
        TeamRepository &teams = m_project->teams();
        TeamRecord team = *teams.add({0, "Falcon", "9B", ""});
        QVERIFY(teams.add({0, "Heron", "9B", ""}));
        team.className = "9C";
        team.pseudonym = "Team 4";
        team.name = "Kestrel";
        QVERIFY(teams.set(team));
        QVERIFY(!teams.find("Falcon"));
        QVERIFY(teams.find("Kestrel")->className == "9C" && teams.find("Kestrel")->pseudonym == "Team 4");
        // the first is the sample's
        QCOMPARE(teams.classes().value(), (std::vector<std::string>{"8b", "9B", "9C"}));
        team.name = "Heron";
        QCOMPARE(teams.set(team).error().code, ErrorCode::AlreadyExists);
        QCOMPARE(teams.set({99, "Owl", "", ""}).error().code, ErrorCode::NotFound);
        QCOMPARE(teams.add({0, "Owl", "", "two\nlines"}).error().code, ErrorCode::InvalidInput);
    }

    void aFileIsUsedByItsRecordings()
    {
        const std::string path = m_project->trials().recordings(m_filled.trial)->front().path;
        QVERIFY(m_project->trials().isFileUsed(path).value());
        QVERIFY(!m_project->trials().isFileUsed("other.mkv").value());
    }

private:
    TrialRecord trial() const { return *m_project->trials().get(m_filled.trial); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_file;
    std::unique_ptr<Project> m_project;
    FilledProject m_filled;
};

ODOGRAPH_TEST(TestTrialMarks, QCoreApplication)
#include "tst_trial_marks.moc"
