// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/workflow/job.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <condition_variable>
#include <mutex>

using namespace odo;

namespace {

/// A job that waits in run() until it is let go or cancelled, and notes on which thread each step ran.
class WaitingJob : public Job
{
public:
    Result<void> prepare(Project &) override
    {
        preparedOn = QThread::currentThreadId();
        if (failsToPrepare)
            return test::saidFailure(ErrorCode::NotFound, "job", "nothing there", "look again");
        return {};
    }
    Result<void> run(const JobControl &control) override
    {
        ranOn = QThread::currentThreadId();
        control.report(0.5, foreignWords("half way"));
        std::unique_lock lock(m_mutex);
        while (!m_released && !control.isCancelled())
            m_wake.wait_for(lock, std::chrono::milliseconds(1));
        if (control.isCancelled())
            return cancelled(foreignWords("job"));
        return {};
    }
    Result<void> commit(Project &) override
    {
        committedOn = QThread::currentThreadId();
        return {};
    }
    void release()
    {
        const std::lock_guard lock(m_mutex);
        m_released = true;
        m_wake.notify_all();
    }

    bool failsToPrepare = false;
    Qt::HANDLE preparedOn = nullptr, ranOn = nullptr, committedOn = nullptr;

private:
    std::mutex m_mutex;
    std::condition_variable m_wake;
    bool m_released = false;
};

} // namespace

class TestJobRunner : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;

private Q_SLOTS:
    void initTestCase()
    {
        m_project =
            std::move(*Project::create(m_folder.filePath(QStringLiteral("p.odo")).toStdString(), "p"));
    }

    void onlyTheLongStepLeavesTheProjectsThread()
    {
        JobRunner runner(*m_project);
        QSignalSpy progress(&runner, &JobRunner::progressed), finished(&runner, &JobRunner::finished);
        const auto job = std::make_shared<WaitingJob>();
        QVERIFY(runner.start(job));
        QVERIFY(runner.isRunning());
        QVERIFY(!runner.start(std::make_shared<WaitingJob>())); // one at a time
        QTRY_COMPARE(progress.count(), 1);
        QCOMPARE(progress.first().at(1).value<odo::Message>().english(), std::string("half way"));
        job->release();
        QTRY_COMPARE(finished.count(), 1);
        QVERIFY(!finished.first().at(1).value<std::optional<Error>>().has_value());
        QCOMPARE(job->preparedOn, QThread::currentThreadId());
        QCOMPARE(job->committedOn, QThread::currentThreadId());
        QVERIFY(job->ranOn != QThread::currentThreadId());
        QVERIFY(!runner.isRunning());
    }

    void aCancelledJobIsNotCommitted()
    {
        JobRunner runner(*m_project);
        QSignalSpy finished(&runner, &JobRunner::finished);
        const auto job = std::make_shared<WaitingJob>();
        QVERIFY(runner.start(job));
        runner.cancel();
        QTRY_COMPARE(finished.count(), 1);
        const auto error = finished.first().at(1).value<std::optional<Error>>();
        QVERIFY(error.has_value());
        QCOMPARE(error->code, ErrorCode::Cancelled);
        QVERIFY(job->committedOn == nullptr);
    }

    void aJobThatCannotBePreparedFinishesWithItsError()
    {
        JobRunner runner(*m_project);
        QSignalSpy finished(&runner, &JobRunner::finished);
        const auto job = std::make_shared<WaitingJob>();
        job->failsToPrepare = true;
        QVERIFY(runner.start(job));
        QTRY_COMPARE(finished.count(), 1);
        QVERIFY(finished.first().at(1).value<std::optional<Error>>().has_value());
        QVERIFY(job->ranOn == nullptr);
    }

    void destroyingARunnerStopsItsJob()
    {
        const auto job = std::make_shared<WaitingJob>();
        {
            JobRunner runner(*m_project);
            QVERIFY(runner.start(job));
        }
        QVERIFY(job->committedOn == nullptr);
    }
};

ODOGRAPH_TEST(TestJobRunner, QCoreApplication)
#include "tst_job_runner.moc"
