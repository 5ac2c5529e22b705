// SPDX-License-Identifier: GPL-3.0-or-later
// Copies of trials: what belongs to the recordings is copied, what was computed from them is not.
#include "core/workflow/trials/trial_copy.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/project/verdict_repository.h"
#include "tests/project/sample_records.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestTrialCopy : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        m_project =
            std::move(*Project::create(m_folder.filePath(QStringLiteral("a.odo")).toStdString(), "A"));
        RecordSource source(3);
        m_filled = *fill(*m_project, source);
        QVERIFY(trials().setTags(m_filled.trial, {"final", "wet"}));
        QVERIFY(trials().setVariables(m_filled.trial, {{"surface", "carpet"}}));
        QVERIFY(trials().setStarred(m_filled.trial, true));
        QVERIFY(trials().setManualOverrides(m_filled.trial, m_filled.robot, {{2, true}}));
        QVERIFY(trials().setPointedOut(m_filled.trial,
                                       {{m_filled.robot, m_filled.recordings.back(), 1, {3, 4}}}));
        ImportedTrack track{m_filled.trial, m_filled.robot,         {}, "run.tum", "00ff", 9,
                            "tum",          foreignWords("metres"), {}};
        track.samples.emplace_back();
        QVERIFY(trials().addImportedTrack(track));
        QVERIFY(trials().setBinned(m_filled.trial, true)); // a copy of it is not in the bin
        const auto copied = copyTrial(*m_project, trials().get(m_filled.trial)->name);
        QVERIFY2(copied, copied ? "" : copied.error().message().c_str());
        m_copy = *copied;
    }

    void itHasTheTrialsFields()
    {
        const TrialRecord original = *trials().get(m_filled.trial);
        QVERIFY(m_copy.id != original.id);
        QCOMPARE(m_copy.name, original.name + " copy");
        QCOMPARE(m_copy.team, original.team);
        QCOMPARE(m_copy.task, original.task);
        QVERIFY(m_copy.date == original.date);
        QCOMPARE(m_copy.notes, original.notes);
        QCOMPARE(m_copy.tags, original.tags);
        QVERIFY(!original.variables.empty() && m_copy.variables == original.variables);
        QCOMPARE(m_copy.robots, original.robots);
        QCOMPARE(m_copy.syncMethod, original.syncMethod);
        QCOMPARE(m_copy.syncOffsetS, original.syncOffsetS);
        QCOMPARE(m_copy.syncRate, original.syncRate);
        QCOMPARE(m_copy.durationS, original.durationS);
        QVERIFY(!m_copy.starred && !m_copy.binned && !m_copy.archived && !m_copy.unfinished);
    }

    void itSharesTheRecordings()
    {
        const auto originals = *trials().recordings(m_filled.trial), copies = *trials().recordings(m_copy.id);
        QCOMPARE(copies.size(), originals.size());
        for (std::size_t i = 0; i < copies.size(); ++i) {
            QVERIFY(copies[i].id != originals[i].id);
            QCOMPARE(copies[i].path, originals[i].path);
            QCOMPARE(copies[i].sha256, originals[i].sha256);
            QCOMPARE(copies[i].orientation, originals[i].orientation);
            QCOMPARE(copies[i].startOffsetS, originals[i].startOffsetS);
            QCOMPARE(copies[i].clockRate, originals[i].clockRate);
            QVERIFY(copies[i].frameTimes == originals[i].frameTimes);
        }
    }

    void itHasWhatWasMeasuredAndMarked()
    {
        const auto copies = *trials().recordings(m_copy.id);
        for (std::size_t i = 0; i < copies.size(); ++i) {
            const auto original = *trials().currentObservations(m_filled.recordings[i], m_filled.robot);
            const auto copy = *trials().currentObservations(copies[i].id, m_filled.robot);
            QCOMPARE(copy.has_value(), original.has_value());
            if (copy) {
                QCOMPARE(copy->algorithm, original->algorithm);
                QCOMPARE(copy->observations.size(), original->observations.size());
            }
        }
        QCOMPARE(trials().overrides(m_copy.id, m_filled.robot)->size(), std::size_t(1));
        const auto pointed = *trials().pointedOut(m_copy.id);
        QCOMPARE(pointed.size(), std::size_t(1));
        QCOMPARE(pointed.front().recording, copies.back().id);
        const auto track = *trials().currentImportedTrack(m_copy.id, m_filled.robot);
        QVERIFY(track && track->file == "run.tum" && track->samples.size() == 1);
        const auto truth = *trials().truth(m_copy.id, m_filled.robot);
        const auto itsTruth = *trials().truth(m_filled.trial, m_filled.robot);
        QCOMPARE(truth.has_value(), itsTruth.has_value());
        QVERIFY(truth && truth->positions == itsTruth->positions);
    }

    /// So no run counts twice.
    void itHasNoResults()
    {
        QVERIFY(!m_project->analyses().currentMetrics(m_filled.trial)->empty());
        QVERIFY(m_project->analyses().currentMetrics(m_copy.id)->empty());
        QVERIFY(!m_project->verdicts().acceptance(m_copy.id)->has_value());
    }

    void undoneItIsInTheBin()
    {
        QVERIFY(m_project->changes()->front().words.english().starts_with("copy trial "));
        QVERIFY(m_project->undo());
        QVERIFY(trials().get(m_copy.id)->binned);
        QVERIFY(m_project->redo());
        QVERIFY(!trials().get(m_copy.id)->binned);
    }

    void namesAreFreeOrRefused()
    {
        const std::string name = trials().get(m_filled.trial)->name;
        QCOMPARE(copyTrial(*m_project, name)->name, name + " copy 2");
        QCOMPARE(copyTrial(*m_project, name, "Again")->name, std::string("Again"));
        const std::size_t count = trials().names()->size();
        QCOMPARE(copyTrial(*m_project, name, "Again").error().message(),
                 std::string("trial 'Again': the project already has a trial of that name; choose another "
                             "name"));
        QCOMPARE(copyTrial(*m_project, "nobody").error().code, ErrorCode::NotFound);
        QCOMPARE(trials().names()->size(), count);
        QVERIFY(trials().setName(m_copy.id, std::string(200, 'x')));
        QCOMPARE(copyTrial(*m_project, std::string(200, 'x'))->name, std::string(180, 'x') + " copy");
    }

    void whatIsBeingRecordedIsNotCopied()
    {
        TrialRecord begun;
        begun.name = "now";
        QVERIFY(trials().begin(begun, {}));
        QCOMPARE(copyTrial(*m_project, "now").error().message(),
                 std::string("trial 'now': its recording has not ended; end its recording first"));
    }

private:
    TrialRepository &trials() { return m_project->trials(); }

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
    FilledProject m_filled;
    TrialRecord m_copy;
};

ODOGRAPH_TEST(TestTrialCopy, QCoreApplication)
#include "tst_trial_copy.moc"
