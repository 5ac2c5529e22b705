// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/video/video_reader.h"
#include "core/workflow/compare/trial_metrics.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/printed_text.h"
#include "tests/ui/support/stored_example.h"
#include "ui/report/report_maker.h"
#include "ui/report/report_output.h"

#include <QApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

/// Reports out of a stored project: what is read, and what is left where one cannot be written.
class TestReportJob : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    Result<void> write(const ReportMaker &maker, const QString &file, const JobControl &control = {})
    {
        ReportJob job(maker, std::make_unique<PdfFile>(file.toStdString(), QStringLiteral("Test")));
        return runToEnd(job, *m_project, control);
    }
    QStringList filesLike(const QString &pattern) const { return QDir(m_folder.path()).entryList({pattern}); }

private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        const auto file = storeExample(m_folder.path().toStdString());
        QVERIFY2(file.has_value(), file ? "" : file.error().message().c_str());
        m_project = Project::open(*file, Project::Access::ReadWrite).value();
    }

    void trialsInTheirOrder()
    {
        const QString file = path("trials.pdf");
        QStringList told;
        JobControl control;
        control.progress = [&told](double, const Message &text) {
            told << QString::fromStdString(text.english());
        };
        const auto written = write(trialReports({"Trial 2", "Trial 1"}, {}), file, control);
        QVERIFY2(written.has_value(), written ? "" : written.error().message().c_str());
        QCOMPARE(told, (QStringList{QStringLiteral("Trial 2"), QStringLiteral("Trial 1")}));
        QCOMPARE(printedWords(file).pageSizes.size(), 3); // the first has two robots
        QVERIFY(printedText(file, 1).contains(QStringLiteral("Trial 2")));
        QVERIFY(printedText(file, 3).contains(QStringLiteral("Trial 1")));
        QVERIFY(printedText(file, 3).contains(QStringLiteral("Team: Falcon")));
    }
    void ofManyTrialsTheKeyFrameIsShown()
    {
        const auto contentOf = [this](StillMoment moment) {
            return *TrialContentReader(*m_project, moment).read("Trial 1");
        };
        const TrialContentPtr top = contentOf(StillMoment::TopSpeed), key = contentOf(StillMoment::KeyFrame);
        QVERIFY(top->isAtTopSpeed && !key->isAtTopSpeed);
        QCOMPARE(top->stillTime, tellingMoment(*top->scene));
        QVERIFY(key->stillTime <= top->stillTime);
        for (const Still &still : key->stills)
            QVERIFY(!still.image.isNull());
        const auto reader = VideoReader::open(key->scene->views.front().file);
        QCOMPARE((*reader)->keyFrameBefore(key->stills.front().frame), key->stills.front().frame);
    }
    void aTrialThatIsNotThereLeavesTheOldFile()
    {
        const QString file = path("old.pdf");
        QFile old(file);
        QVERIFY(old.open(QIODevice::WriteOnly));
        old.write("%PDF- as it was");
        old.close();
        const auto written = write(trialReports({"Trial 1", "Trial 9"}, {}), file);
        QCOMPARE(written.error().code, ErrorCode::NotFound);
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), QByteArray("%PDF- as it was"));
        QCOMPARE(filesLike(QStringLiteral("old*")), QStringList(QStringLiteral("old.pdf")));
    }
    void aCancelledReportLeavesNothing()
    {
        const QString file = path("cancelled.pdf");
        JobControl control;
        control.progress = [&control](double fraction, const Message &) {
            if (fraction > 0)
                control.cancel.cancel();
        };
        const auto written = write(trialReports({"Trial 1", "Trial 1", "Trial 1"}, {}), file, control);
        QCOMPARE(written.error().code, ErrorCode::Cancelled);
        QCOMPARE(filesLike(QStringLiteral("cancelled*")), QStringList());
    }
    void aFolderThatIsNotThereIsSaid()
    {
        const auto written = write(trialReports({"Trial 1"}, {}), path("nowhere/report.pdf"));
        QCOMPARE(written.error().code, ErrorCode::NotFound);
        const QString words = QString::fromStdString(written.error().message());
        QVERIFY2(words.contains(QStringLiteral("nowhere/report.pdf")) &&
                     words.contains(QStringLiteral("does not exist")),
                 qPrintable(words));
    }
    void aReportWithoutAPageIsNone()
    {
        const auto written = write(trialReports({}, {}), path("none.pdf"));
        QCOMPARE(written.error().code, ErrorCode::InvalidInput);
        QCOMPARE(filesLike(QStringLiteral("none*")), QStringList());
    }
    void theMedianOfAClassIsThatOfItsRuns()
    {
        AnalysisRecord analysis =
            m_project->analyses().current(m_project->trials().find("Trial 1")->id).value().front();
        const auto team = m_project->teams().find("Heron").value();
        for (const double speed : {1.0, 2.0, 5.0, 70.0}) {
            TrialRecord trial;
            trial.name = "Run at " + std::to_string(speed);
            trial.team = team.id;
            trial.task = "Line";
            trial.robots = {analysis.robot};
            trial = m_project->trials().add(trial, {}).value();
            analysis.trial = trial.id;
            analysis.profile.metrics = {{"max_speed", "m/s", speed, 0.01}};
            QVERIFY(m_project->analyses().add(analysis).has_value());
        }
        QVERIFY(m_project->trials()
                    .setBinned(m_project->trials().find("Run at 70.000000")->id, true)
                    .has_value());
        const auto metrics = classMedians(*m_project, "9B", "Line", {"max_speed", "no_such"});
        QVERIFY2(metrics.has_value(), metrics ? "" : metrics.error().message().c_str());
        QCOMPARE(metrics->count("no_such"), std::size_t(0));
        QCOMPARE(metrics->at("max_speed").runs, 3);
        QCOMPARE(metrics->at("max_speed").median, 2.0);
        QVERIFY(classMedians(*m_project, "7C", "Line", {"max_speed"}).value().empty());
    }
    void aLogoIsAPicture()
    {
        const QString file = path("logo.png");
        QImage(3000, 1000, QImage::Format_RGB32).save(file);
        QCOMPARE(readLogo(file.toStdString()).value().size(), QSize(1200, 400));
        QFile text(path("logo.txt"));
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write("no picture");
        text.close();
        for (const auto &[name, code] :
             {std::pair{"logo.txt", ErrorCode::Io}, std::pair{"missing.png", ErrorCode::NotFound}}) {
            const auto none = readLogo(path(name).toStdString());
            QCOMPARE(none.error().code, code);
            QVERIFY(QString::fromStdString(none.error().message()).contains(QLatin1String(name)));
        }
    }
};

ODOGRAPH_TEST(TestReportJob, QApplication)
#include "tst_report_job.moc"
