// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/export_job.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestExportJob : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        const auto made = storeExample(m_folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_project = std::move(*Project::open(*made, Project::Access::ReadOnly));
    }

    void eachRobotBecomesAFile()
    {
        const QTemporaryDir folder;
        QVERIFY(run("Trial 1", folder));
        QVERIFY(run("Trial 2", folder));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files),
                 (QStringList{QStringLiteral("Trial 1.csv"), QStringLiteral("Trial 2 Blue 1.csv"),
                              QStringLiteral("Trial 2 Red 2.csv")}));
        QFile file(folder.filePath(QStringLiteral("Trial 1.csv")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const auto trial = m_project->trials().find("Trial 1");
        const auto analyses = m_project->analyses().current(trial->id);
        QCOMPARE(file.readAll().toStdString(), trackCsv(analyses->front(), CsvStyle::Analysis));
    }

    /// Of a part, with columns, a unit and axes that were chosen.
    void whatWasChosenIsWritten()
    {
        const QTemporaryDir folder;
        const auto trial = m_project->trials().find("Trial 1");
        const AnalysisRecord analysis = m_project->analyses().current(trial->id)->front();
        TrackExport how;
        how.columns = *parseCsvColumns({"t_s", "x_mm", "y_mm", "speed_mm_s"});
        how.unit = CsvLength::Metres;
        how.frame = TrackFrame::Start;
        how.span = TimeSpan{analysis.profile.samples[5].time, analysis.profile.samples[9].time};
        ExportJob job("Trial 1", folder.path().toStdString(), how);
        QVERIFY(runToEnd(job, *m_project, JobControl()));
        QFile file(folder.filePath(QStringLiteral("Trial 1.csv")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArrayList lines = file.readAll().split('\n');
        QCOMPARE(lines.size(), qsizetype(1 + 5 + 1));
        QCOMPARE(lines.at(0), QByteArray("t_s,x_m,y_m,speed_m_s"));
        QVERIFY2(lines.at(1).startsWith("0,0,0,"), lines.at(1).constData());
        const QByteArrayList last = lines.at(5).split(',');
        const auto &points = analysis.profile.points;
        QVERIFY(std::abs(std::hypot(last.at(1).toDouble(), last.at(2).toDouble()) -
                         (points[9].position - points[5].position).norm()) < 1e-9);
        QCOMPARE(last.at(3).toDouble(), points[9].speedMps);
        how.format = ExportedFormat::Tum;
        ExportJob tum("Trial 1", folder.path().toStdString(), how);
        QVERIFY(runToEnd(tum, *m_project, JobControl()));
        QVERIFY(QFile::exists(folder.filePath(QStringLiteral("Trial 1.tum"))));
    }

    void nothingIsOverwritten()
    {
        const QTemporaryDir folder;
        QVERIFY(run("Trial 1", folder));
        const auto again = run("Trial 1", folder);
        QCOMPARE(again.error().code, ErrorCode::AlreadyExists);
        QVERIFY(again.error().message().find("it already exists; choose another name or folder") !=
                std::string::npos);
    }

    void whatWasNotTrackedIsTold()
    {
        const QTemporaryDir folder;
        QCOMPARE(run("Trial 3", folder).error().message(),
                 std::string("export of 'Trial 3': it has not been tracked yet; track it first"));
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void cancelledBeforeItBegan()
    {
        const QTemporaryDir folder;
        JobControl control;
        control.cancel.cancel();
        ExportJob job("Trial 1", folder.path().toStdString(), {});
        QCOMPARE(runToEnd(job, *m_project, control).error().code, ErrorCode::Cancelled);
        QVERIFY(QDir(folder.path()).isEmpty());
    }

private:
    Result<void> run(const std::string &trial, const QTemporaryDir &folder)
    {
        ExportJob job(trial, folder.path().toStdString(), {});
        return runToEnd(job, *m_project, JobControl());
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestExportJob, QCoreApplication)
#include "tst_export_job.moc"
