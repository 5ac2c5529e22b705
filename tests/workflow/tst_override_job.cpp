// SPDX-License-Identifier: GPL-3.0-or-later
// A person's word on a sample is one change: it is taken back, and made again, as a whole.
#include "core/base/error.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track/reanalysis.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/project_content.h"
#include "tests/ui/support/stored_example.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestOverrideJob : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void isTakenBackAndMadeAgain()
    {
        const QTemporaryDir folder;
        const auto project = openStoredExample(folder.path().toStdString());
        const TrialRecord trial = project->trials().find("Trial 1").value();
        const auto words = [&] {
            return project->trials().overrides(trial.id, trial.robots.front()).value().size();
        };
        const QStringList before = contentOf(*project);
        OverrideRequest request;
        request.trial = "Trial 1";
        request.frame = 12;
        OverrideJob job(request);
        const auto done = runToEnd(job, *project, JobControl());
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(project->undoWords().english(), std::string("mark frame 12 of Trial 1 as a spike"));
        QCOMPARE(words(), std::size_t(1));
        const QStringList after = contentOf(*project);
        QVERIFY(after != before); // an analysis of its own
        QVERIFY(project->undo());
        QCOMPARE(contentOf(*project), before);
        QCOMPARE(words(), std::size_t(0));
        QVERIFY(project->redo());
        QCOMPARE(contentOf(*project), after);
        QCOMPARE(words(), std::size_t(1));
        const auto analyses = project->analyses().current(trial.id); // with its series
        QVERIFY(analyses && !analyses->front().profile.samples.empty());
    }

    /// Many samples, one step; those of a group that the word does not change are left alone.
    void aGroupIsOneChange()
    {
        const QTemporaryDir folder;
        const auto project = openStoredExample(folder.path().toStdString());
        const TrialRecord trial = project->trials().find("Trial 1").value();
        const auto words = [&] {
            return project->trials().overrides(trial.id, trial.robots.front()).value();
        };
        const QStringList before = contentOf(*project);
        OverrideRequest request;
        request.trial = "Trial 1";
        request.frames = {14, 11, 12};
        OverrideJob listed(request);
        const auto done = runToEnd(listed, *project, JobControl());
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(listed.outcome().count, std::size_t(3));
        QCOMPARE(listed.outcome().frame, std::int64_t(11));
        QCOMPARE(project->undoWords().english(), std::string("mark 3 samples of Trial 1 as spikes"));
        QVERIFY((words() == std::vector<ManualOverride>{{11, true}, {12, true}, {14, true}}));
        // of all the run, those that are marked
        const auto samples = project->analyses().current(trial.id)->front().profile.samples;
        OverrideRequest group;
        group.trial = "Trial 1";
        group.word = OverrideRequest::Word::Clear;
        group.group = SampleGroup{toSeconds(samples.front().time), toSeconds(samples.back().time), 0};
        OverrideJob cleared(group);
        QVERIFY(runToEnd(cleared, *project, JobControl()));
        QCOMPARE(cleared.outcome().count, std::size_t(3));
        QVERIFY(words().empty());
        QVERIFY(project->undo());
        QCOMPARE(words().size(), std::size_t(3));
        QVERIFY(project->undo());
        QCOMPARE(contentOf(*project), before);
        group.group->reasons = flagBit(SampleFlag::AccelerationLimit);
        OverrideJob none(group);
        const auto refused = none.prepare(*project);
        QVERIFY(!refused);
        QVERIFY(refused.error().message().find("is to be changed; choose other times or another reason") !=
                std::string::npos);
    }

    /// Two windows, or a window and a command: neither word is lost.
    void aWordSaidMeanwhileStays()
    {
        const QTemporaryDir folder;
        const auto project = openStoredExample(folder.path().toStdString());
        const auto request = [](std::int64_t frame) {
            OverrideRequest made;
            made.trial = "Trial 1";
            made.frame = frame;
            return made;
        };
        OverrideJob slow(request(12)), quick(request(14));
        QVERIFY(slow.prepare(*project) && slow.run(JobControl()));
        const auto outside = Project::openAgain(project->file(), Project::Access::ReadWrite).value();
        QVERIFY(runToEnd(quick, *outside, JobControl()));
        const QStringList before = contentOf(*project);
        const auto stored = slow.commit(*project);
        QVERIFY(!stored);
        QCOMPARE(QString::fromStdString(stored.error().message()),
                 QStringLiteral("frame 12 of trial 'Trial 1': another sample was overridden while this one "
                                "was analysed; repeat it for frame 12"));
        QCOMPARE(contentOf(*project), before);
    }

    /// Another program, or our own tracking, that analysed the robot again: what it shows would stay,
    /// whatever Undone says.
    void isNotTakenBackUnderALaterAnalysis_data()
    {
        QTest::addColumn<bool>("isRedo");
        QTest::newRow("undo") << false;
        QTest::newRow("redo") << true;
    }
    void isNotTakenBackUnderALaterAnalysis()
    {
        QFETCH(bool, isRedo);
        const QTemporaryDir folder;
        const auto project = openStoredExample(folder.path().toStdString());
        const auto mark = [](Project &in, std::int64_t frame) {
            OverrideRequest request;
            request.trial = "Trial 1";
            request.frame = frame;
            OverrideJob job(request);
            return runToEnd(job, in, JobControl());
        };
        QVERIFY(mark(*project, 12));
        if (isRedo) {
            // The number that the analysis had is used by none, so that SQLite sees no conflict.
            const auto analyses = project->analyses().current(project->trials().find("Trial 1")->id);
            AnalysisRecord other = analyses->front();
            other.trial = project->trials().find("Trial 2")->id;
            QVERIFY(project->note(foreignWords("measure another trial"),
                                  [&] { return withoutValue(project->analyses().add(other)); }));
            QVERIFY(project->undo());
        }
        const auto outside = Project::openAgain(project->file(), Project::Access::ReadWrite).value();
        QVERIFY(mark(*outside, 14));
        const QStringList before = contentOf(*project);
        const auto done = isRedo ? project->redo() : project->undo();
        QVERIFY(!done);
        QCOMPARE(done.error().code, ErrorCode::InvalidInput);
        QCOMPARE(QString::fromStdString(done.error().message()),
                 QStringLiteral("%1 'mark frame 12 of Trial 1 as a spike': something it concerns has been "
                                "changed or used since; undo the later change first, or leave this one")
                     .arg(isRedo ? QStringLiteral("redo") : QStringLiteral("undo")));
        QCOMPARE(contentOf(*project), before);
        QVERIFY(outside->undo()); // then it can be
        QVERIFY(isRedo ? project->redo() : project->undo());
    }
};

ODOGRAPH_TEST(TestOverrideJob, QCoreApplication)
#include "tst_override_job.moc"
