// SPDX-License-Identifier: GPL-3.0-or-later
// What long work tells in the list of changes.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/register_job.h"
#include "core/workflow/job.h"
#include "core/workflow/track/reanalysis.h"
#include "core/workflow/track/track_job.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestAuditTrail : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_project = openStoredExample(m_folder.path().toStdString()); }
    void measuringAgainIsToldOnceItIsKept()
    {
        ReprocessJob job("Trial 1");
        const auto done = runToEnd(job, *m_project, {});
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QVERIFY(told().empty()); // nothing is stored yet
        QVERIFY(job.keep(*m_project));
        QCOMPARE(told(), std::vector<std::string>{"reanalyse Trial 1"});
        QCOMPARE(m_project->undoWords().english(), std::string("reanalyse Trial 1"));
    }
    void registeringIsTold()
    {
        const std::size_t before = told().size();
        const auto made = registerWithCurrentIntrinsics(*m_project, "A");
        if (made) {
            QCOMPARE(told().size(), before + 1);
            QCOMPARE(told().front(), std::string("register camera A again"));
        } else {
            QCOMPARE(told().size(), before); // what was refused left no trace
        }
    }
    /// A task that is changed while a trial is measured by it takes its row away.
    void whatIsMeasuredByATaskThatIsGoneIsRefused()
    {
        const TaskRecord task = *m_project->tasks().find("Figure eight, 2 laps");
        Task line;
        line.path.points = {{0, 0}, {1, 0}};
        const auto first = m_project->tasks().change({task.id, task.name, line});
        QVERIFY(first.has_value()); // nothing was measured by this one yet
        TrackSettings settings;
        settings.again = true;
        settings.robots = {"Red 2"};
        TrackJob job("Trial 1", settings);
        QVERIFY(job.prepare(*m_project));
        QVERIFY(job.run({}));
        line.path.points.emplace_back(1, 1);
        QVERIFY(m_project->tasks().change({first->id, task.name, line}));
        const auto refused = job.commit(*m_project);
        QVERIFY(!refused);
        QCOMPARE(
            QString::fromStdString(refused.error().message()),
            QStringLiteral("trial 'Trial 1': its task changed during the analysis; repeat the analysis"));
    }

private:
    std::vector<std::string> told() const
    {
        std::vector<std::string> words;
        const auto changes = m_project->changes().value();
        for (const ChangeEntry &entry : changes)
            words.push_back(entry.words.english());
        return words;
    }
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestAuditTrail, QCoreApplication)
#include "tst_audit_trail.moc"
