// SPDX-License-Identifier: GPL-3.0-or-later
// The same work on many trials: progress, a failure on the way, and a cancel.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/export_job.h"
#include "core/workflow/track/reanalysis.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/internal/class_actions.h"
#include "ui/main_window/workspace.h"

#include <QApplication>
#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <thread>

using namespace odo;

namespace {

/// Works until it is cancelled.
class EndlessJob : public Job
{
public:
    Result<void> prepare(Project &) override { return {}; }
    Result<void> run(const JobControl &control) override
    {
        while (!control.isCancelled())
            std::this_thread::yield();
        return cancelled(foreignWords("endless work"));
    }
    Result<void> commit(Project &) override { return {}; }
};

/// What the end of a batch said went wrong.
QStringList lines(const QSignalSpy &ended)
{
    QStringList all;
    for (const Error &each : ended.front().at(2).value<std::vector<odo::Error>>())
        all << QString::fromStdString(each.message());
    return all;
}

} // namespace

class TestTrialBatch : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        const auto made = storeExample(m_folder->path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_workspace = std::make_unique<Workspace>();
        QVERIFY(m_workspace->open(*made));
        QTRY_VERIFY(!m_workspace->isBusy());
    }
    void cleanup() { m_workspace.reset(); }

    void goesOnAfterAFailure()
    {
        const QTemporaryDir target;
        TrialBatch batch(*m_workspace, nullptr);
        QSignalSpy ended(&batch, &TrialBatch::ended), begun(m_workspace.get(), &Workspace::jobStarted);
        const auto make = [&](const std::string &trial) {
            return std::make_shared<ExportJob>(trial, target.path().toStdString(), TrackExport());
        };
        QVERIFY(batch.start({QStringLiteral("Trial 1"), QStringLiteral("Trial 3"), QStringLiteral("Trial 2")},
                            {&ODO_TEXT("test.exporting", "Exporting %1 (%2 of %3)"), make, {}}));
        QVERIFY(batch.isRunning());
        QVERIFY(!batch.start({QStringLiteral("Trial 1")}, {nullptr, make, {}}));
        QTRY_COMPARE(ended.count(), 1);
        QCOMPARE(ended.front().at(0).toInt(), 2);
        QCOMPARE(ended.front().at(1).toInt(), 3);
        QCOMPARE(lines(ended), QStringList{QStringLiteral(
                                   "export of 'Trial 3': it has not been tracked yet; track it first")});
        QCOMPARE(begun.at(1).front().toString(), QStringLiteral("Exporting Trial 3 (2 of 3)"));
        QCOMPARE(QDir(target.path()).entryList(QDir::Files).size(), 3);
        QVERIFY(!batch.isRunning());
    }

    void whatIsMeasuredAgainIsKept()
    {
        const RecordId trial = m_workspace->project()->trials().find("Trial 1")->id;
        const RecordId before = m_workspace->project()->analyses().currentMetrics(trial)->front().id;
        TrialBatch batch(*m_workspace, nullptr);
        QSignalSpy ended(&batch, &TrialBatch::ended);
        QVERIFY(batch.start(
            {QStringLiteral("Trial 1")},
            {&ODO_TEXT("test.again", "%1 %2 %3"),
             [](const std::string &name) { return std::make_shared<ReprocessJob>(name); },
             [](Project &project, Job &job) { return static_cast<ReprocessJob &>(job).keep(project); }}));
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 60'000);
        QVERIFY2(lines(ended).isEmpty(), qPrintable(lines(ended).join(u';')));
        QVERIFY(m_workspace->project()->analyses().currentMetrics(trial)->front().id > before);
    }

    void aCancelEndsIt()
    {
        TrialBatch batch(*m_workspace, nullptr);
        QSignalSpy ended(&batch, &TrialBatch::ended);
        const auto make = [](const std::string &) { return std::make_shared<EndlessJob>(); };
        QVERIFY(batch.start({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")},
                            {&ODO_TEXT("test.endless", "%1 %2 %3"), make, {}}));
        m_workspace->cancel();
        QTRY_COMPARE(ended.count(), 1);
        QCOMPARE(ended.front().at(0).toInt(), 0);
        QVERIFY(lines(ended).isEmpty());
        QVERIFY(!m_workspace->isBusy());
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Workspace> m_workspace;
};

ODOGRAPH_TEST(TestTrialBatch, QApplication)
#include "tst_trial_batch.moc"
