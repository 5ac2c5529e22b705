// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/workflow/project_copy.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestCopyJob : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_project = std::move(*Project::create(path("lesson.odo"), "Lesson")); }

    void theCopyHasEverything()
    {
        CopyJob job(path("copy.odo"));
        const auto copied = runToEnd(job, *m_project, {});
        QVERIFY2(copied, copied ? "" : copied.error().message().c_str());
        const auto copy = Project::open(path("copy.odo"), Project::Access::ReadWrite);
        QVERIFY(copy);
        QCOMPARE((*copy)->title().value(), std::string("Lesson"));
        QVERIFY(m_project->setTitle("Lesson")); // the project itself goes on
    }

    void aCancelledCopyGoesAgain()
    {
        JobControl control;
        control.cancel.cancel();
        CopyJob job(path("cancelled.odo"));
        QCOMPARE(runToEnd(job, *m_project, control).error().code, ErrorCode::Cancelled);
        QVERIFY(!std::filesystem::exists(path("cancelled.odo")));
    }

    void saysWhereItCannotBeWritten()
    {
        CopyJob job(path("nowhere/copy.odo"));
        const auto refused = runToEnd(job, *m_project, {});
        QVERIFY(!refused);
        QVERIFY2(refused.error().message().find("does not exist") != std::string::npos,
                 refused.error().message().c_str());
    }

    void takesNoNameThatBelongsToAnotherProject()
    {
        CopyJob job(path("lesson.odo.lock"));
        const auto refused = runToEnd(job, *m_project, {});
        QCOMPARE(refused.error().code, ErrorCode::WrongCall);
        QVERIFY(!std::filesystem::exists(path("lesson.odo.lock")));
    }

private:
    std::filesystem::path path(const char *name) const
    {
        return m_folder.filePath(QString::fromLatin1(name)).toStdString();
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestCopyJob, QCoreApplication)
#include "tst_copy_job.moc"
