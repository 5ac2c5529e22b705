// SPDX-License-Identifier: GPL-3.0-or-later
// A person's word on a sample is one change: it is taken back, and made again, as a whole.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/overrule_job.h"
#include "tests/ui/support/project_content.h"
#include "tests/ui/support/stored_example.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestOverruleJob : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void isTakenBackAndMadeAgain()
    {
        const QTemporaryDir folder;
        const auto project = openStoredExample(folder.path().toStdString());
        const TrialRecord trial = project->trials().find("Trial 1").value();
        const auto words = [&] {
            return project->trials().overrules(trial.id, trial.robots.front()).value().size();
        };
        const QStringList before = contentOf(*project);
        OverruleRequest request;
        request.trial = "Trial 1";
        request.frame = 12;
        OverruleJob job(request);
        const auto done = runToEnd(job, *project, JobControl());
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(project->undoWords(), std::string("mark frame 12 of Trial 1 as a spike"));
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
};

QTEST_GUILESS_MAIN(TestOverruleJob)
#include "tst_overrule_job.moc"
