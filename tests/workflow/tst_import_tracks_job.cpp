// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/track_export.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/trajectory/imported_track.h"
#include "core/workflow/compare/compare_trials.h"
#include "core/workflow/export_job.h"
#include "core/workflow/import/import_tracks_job.h"
#include "core/workflow/track/reanalysis.h"
#include "core/workflow/track/track_job.h"
#include "core/workflow/track/trial_verdict.h"
#include "core/workflow/trial_sources.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"
#include "tests/ui/support/project_content.h"

#include <QCryptographicHash>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

using namespace odo;

/// Finished tracks become runs of a project like those that were tracked in videos.
class TestImportTracksJob : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;

    std::filesystem::path write(const char *name, const QByteArray &text) const
    {
        QFile file(m_folder->filePath(QString::fromUtf8(name)));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("no test file");
        return file.fileName().toStdString();
    }
    /// A lap of a circle, 0.5 m at 1 m/s, from `begin` on, with a jump of 0.3 m at the hundredth position.
    static QByteArray circle(double begin = 0, bool hasJump = true)
    {
        QByteArray text = "t_s,x_mm,y_mm\n";
        for (int i = 0; i < 200; ++i) {
            const double t = i / 50.0, wobble = 0.4 * std::sin(i * 2.3); // mm
            text +=
                QByteArray::number(begin + t, 'f', 6) + ',' +
                QByteArray::number(500 * std::cos(2 * t) + wobble + (hasJump && i == 100 ? 300 : 0), 'f', 3) +
                ',' + QByteArray::number(500 * std::sin(2 * t) - wobble, 'f', 3) + '\n';
        }
        return text;
    }
    static ImportTracksSettings settingsOf(const char *trial, const std::filesystem::path &file)
    {
        ImportTracksSettings settings;
        settings.trial = trial;
        settings.tracks = {{"red", file}};
        return settings;
    }
    Result<void> import(const ImportTracksSettings &settings)
    {
        ImportTracksJob job(settings);
        return runToEnd(job, *m_project, JobControl());
    }
    AnalysisRecord analysisOf(const char *trial)
    {
        return m_project->analyses().current(m_project->trials().find(trial)->id)->at(0);
    }
    std::string precisionOf(const char *trial)
    {
        const auto found = m_project->trials().find(trial);
        const auto verdict = verdictOn(*m_project, *found, {}, *m_project->analyses().current(found->id));
        const auto check = std::ranges::find(verdict->checks, "positions_precise", &TrialCheck::code);
        return check->text.english();
    }
    std::string errorOf(const ImportTracksSettings &settings)
    {
        const QStringList before = contentOf(*m_project);
        const auto done = import(settings);
        if (done)
            return "it was imported";
        return contentOf(*m_project) == before ? done.error().message() : "the project was changed";
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = std::move(
            *Project::create(m_folder->filePath(QStringLiteral("class.odo")).toStdString(), "class"));
    }

    void becomesARun()
    {
        const QByteArray text = circle();
        ImportTracksSettings settings = settingsOf("lap", write("lap.csv", text));
        settings.team = "Falcon";
        ImportTracksJob job(settings);
        const auto done = runToEnd(job, *m_project, JobControl());
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(test::english(job.warnings()),
                 std::vector<std::string>{"robot 'red' is new: it was added with the colour #0072b2"});

        const TrialRecord trial = m_project->trials().find("lap").value();
        QCOMPARE(trial.teamName, std::string("Falcon"));
        QCOMPARE(trial.viewCount, 0);
        QCOMPARE(trial.durationS, 3.98);
        QCOMPARE(trial.robotNames, std::vector<std::string>{"red"});
        const AnalysisRecord analysis = analysisOf("lap");
        QVERIFY(analysis.views.empty());
        QCOMPARE(analysis.profile.samples.size(), std::size_t(200));
        QCOMPARE(analysis.profile.spikes.size(), std::size_t(1));
        QCOMPARE(analysis.profile.spikes[0].sampleIndex, std::int64_t(100));
        QVERIFY(!analysis.profile.metrics.empty());

        const auto sources = importedTracksOf(*m_project, trial);
        QVERIFY(sources && sources->size() == 1);
        const ImportedTrack &source = sources->front();
        QCOMPARE(source.file, std::string("lap.csv"));
        QCOMPARE(source.sha256,
                 QCryptographicHash::hash(text, QCryptographicHash::Sha256).toHex().toStdString());
        QCOMPARE(source.bytes, std::int64_t(text.size()));
        QCOMPARE(source.format, std::string("csv"));
        const double noiseM = source.noiseM;
        QVERIFY2(noiseM > 0.0001 && noiseM < 0.001, qPrintable(QString::number(noiseM)));
        QCOMPARE(source.reading.english(),
                 "positions to " + formatNumber(1e3 * noiseM, 2) +
                     " mm, estimated from the track; errors that change slowly are not "
                     "included");
        QCOMPARE(m_project->changes()->front().words.english(), std::string("import trial lap"));
        QVERIFY(m_project->check(true)->empty());
    }
    /// A slow robot in coarse numbers: what they are rounded to is an error, though nothing scatters.
    void roundingCounts()
    {
        for (const auto &[name, stepMm] : {std::pair{"1 mm", 1.0}, {"10 mm", 10.0}, {"100 mm", 100.0}}) {
            QByteArray text = "t_s,x_mm,y_mm\n";
            for (int i = 0; i < 600; ++i)
                text += QByteArray::number(i / 30.0, 'f', 4) + ',' +
                        QByteArray::number(std::round(0.06 * i) * stepMm, 'f', 1) + ",500.0\n";
            QVERIFY(import(settingsOf(name, write("slow.csv", text))));
            const auto source = importedTracksOf(*m_project, *m_project->trials().find(name))->front();
            QVERIFY2(source.reading.english().find("rounded to") != std::string::npos,
                     source.reading.english().c_str());
            QVERIFY(analysisOf(name).profile.points[300].sigmaXM >= stepMm / 1000 / std::sqrt(12.0));
        }
    }
    /// What scatter does not show can be given, and stays when the track is reanalysed.
    void theAccuracyOfASourceCounts()
    {
        ImportTracksSettings settings = settingsOf("lap", write("lap.csv", circle()));
        QVERIFY(import(settings));
        QVERIFY(analysisOf("lap").profile.points[50].sigmaXM < 0.002);
        settings.trial = "known";
        settings.sigmaM = 0.005;
        QVERIFY(import(settings));
        QVERIFY(analysisOf("known").profile.points[50].sigmaXM >= 0.005);
        QVERIFY(precisionOf("lap").find("errors that change slowly do not show") != std::string::npos);
        QCOMPARE(precisionOf("known"), std::string("positions are precise for the run's extent"));
        const auto source = importedTracksOf(*m_project, *m_project->trials().find("known"))->front();
        QVERIFY2(source.reading.english().ends_with("; accurate to 5.00 mm, as given"),
                 source.reading.english().c_str());
        TrackSettings again;
        again.again = true;
        TrackJob track("known", again);
        QVERIFY(runToEnd(track, *m_project, JobControl()));
        QVERIFY(analysisOf("known").profile.points[50].sigmaXM >= 0.005);
    }
    /// To the last bit, whatever is made of them.
    void positionsAreNeverAltered()
    {
        QVERIFY(import(settingsOf("lap", write("lap.csv", circle()))));
        const auto before = analysisOf("lap").profile.samples;
        OverrideRequest word;
        word.trial = "lap";
        word.frame = 50;
        OverrideJob manualOverride(word);
        QVERIFY(runToEnd(manualOverride, *m_project, JobControl()));
        QCOMPARE(analysisOf("lap").profile.spikes.size(), std::size_t(2));
        TrackSettings again;
        again.again = true;
        again.smoother = Smoother::SavGol;
        TrackJob track("lap", again);
        QVERIFY(runToEnd(track, *m_project, JobControl()));
        const AnalysisRecord after = analysisOf("lap");
        QCOMPARE(after.options.smoother, Smoother::SavGol);
        QCOMPARE(after.profile.spikes.size(), std::size_t(2)); // the word stays in force
        for (std::size_t i = 0; i < before.size(); ++i) {
            QCOMPARE(after.profile.samples[i].position, before[i].position);
            QCOMPARE(after.profile.samples[i].time, before[i].time);
            QCOMPARE(after.profile.samples[i].covariance, before[i].covariance);
        }
        ReprocessJob reprocess("lap");
        QVERIFY(runToEnd(reprocess, *m_project, JobControl()));
        QCOMPARE(reprocess.robots().front().change.largestShiftM, 0.0);
    }
    void cannotBeTracked()
    {
        QVERIFY(import(settingsOf("lap", write("lap.csv", circle()))));
        TrackJob track("lap", {});
        const auto done = runToEnd(track, *m_project, JobControl());
        QVERIFY(!done);
        QCOMPARE(done.error().message(),
                 std::string("trial 'lap': its tracks were imported, so it has no video to track; reanalyse "
                             "them with: odograph track PROJECT TRIAL --again"));
    }
    void isMeasuredByATask()
    {
        TaskRecord task;
        task.name = "lap";
        task.task.gates = {{"line", GateRole::StartFinish, {0.7, 0.02}, {0.3, 0.02}}};
        QVERIFY(m_project->tasks().add(task));
        ImportTracksSettings settings = settingsOf("lap", write("lap.csv", circle()));
        settings.task = "lap";
        QVERIFY(import(settings));
        QCOMPARE(analysisOf("lap").profile.passages.size() + (analysisOf("lap").task != 0 ? 0 : 100),
                 std::size_t(2));
        settings.trial = "other";
        settings.task = "none";
        QVERIFY(errorOf(settings).starts_with("task 'none': "));
    }
    void isComparedAndExported()
    {
        QVERIFY(import(settingsOf("one", write("one.csv", circle(0, false)))));
        QVERIFY(import(settingsOf("two", write("two.csv", circle(0, true)))));
        CompareSettings compare;
        compare.runs = {{"one", ""}, {"two", ""}};
        const auto read = readComparedTrials(*m_project, compare);
        QVERIFY(read);
        const auto compared = compareTrials(*read, compare);
        QVERIFY2(compared, compared ? "" : compared.error().message().c_str());
        const QString out = m_folder->filePath(QStringLiteral("out"));
        QVERIFY(QDir().mkpath(out));
        ExportJob job("one", out.toStdString(), TrackExport());
        QVERIFY(runToEnd(job, *m_project, JobControl()));
        QCOMPARE(job.files().size(), std::size_t(1));
    }
    /// What was exported is read back: the same samples, whatever the layout.
    void roundTripsLoseNothing()
    {
        QVERIFY(import(settingsOf("lap", write("lap.csv", circle(0.4, false)))));
        const AnalysisRecord first = analysisOf("lap");
        const std::vector<std::pair<const char *, std::string>> files = {
            {"a.csv", trackCsv(first, CsvStyle::Analysis)},
            {"i.csv", trackCsv(first, CsvStyle::International)},
            {"c.csv", trackCsv(first, CsvStyle::Continental)},
            {"t.txt", trackTracker(first)},
            {"t.tum", trackTum(first)}};
        for (const auto &[name, text] : files) {
            QVERIFY2(import(settingsOf(name, write(name, QByteArray::fromStdString(text)))), name);
            const AnalysisRecord second = analysisOf(name);
            QCOMPARE(second.profile.samples.size(), first.profile.samples.size());
            const bool isMetres = std::string_view(name).starts_with("t.");
            for (std::size_t i = 0; i < first.profile.samples.size(); ++i) {
                QCOMPARE(second.profile.samples[i].time, first.profile.samples[i].time);
                const Eigen::Vector2d &was = first.profile.points[i].position,
                                      &is = *second.profile.samples[i].position;
                // TUM and Tracker's text say metres with all digits. Millimetres are 1000 times as much and
                // back: a unit of the last place or so.
                QVERIFY(isMetres ? is == was : (is - was).norm() <= 4e-16 * was.norm());
            }
            const ImportedTrack source = importedTracksOf(*m_project, *m_project->trials().find(name))->at(0);
            QCOMPARE(source.reading.english().ends_with("as stated in the file"), !isMetres);
        }
    }
    void severalRobotsShareAClock()
    {
        const auto both =
            write("both.txt", "#multi:\n\tred\t\tblue_1\t\t\nt\tx\ty\tx\ty\t\n5000\t0\t0\t\t\t\n5000.1\t0."
                              "1\t0\t1\t1\t\n5000.2\t0.2\t0\t1\t1.1\t\n"
                              "5000.3\t0.3\t0\t1\t1.2\t\n5000.4\t0.4\t0\t1\t1.3\t\n");
        ImportTracksSettings settings = settingsOf("two", both);
        settings.tracks.emplace_back("blue 1", both);
        QVERIFY2(import(settings), "two tracks of one file");
        const auto analyses = m_project->analyses().current(m_project->trials().find("two")->id);
        QCOMPARE(analyses->size(), std::size_t(2));
        QCOMPARE(analyses->at(1).profile.samples[1].time, Nanoseconds(100000000));
        QVERIFY(!analyses->at(1).profile.samples[0].position);
        const auto source = importedTracksOf(*m_project, *m_project->trials().find("two"))->at(1);
        QVERIFY2(
            source.reading.english().ends_with("; the file's track 'blue_1'; its times start at 5000.000 s"),
            source.reading.english().c_str());
        settings.trial = "third";
        settings.tracks[0].first = "green";
        QCOMPARE(errorOf(settings), "file '" + both.string() +
                                        "': none of its tracks is called 'green'; it has 'red', 'blue_1'; "
                                        "give the robot the name of one of them");
    }
    void removedForGood()
    {
        QVERIFY(import(settingsOf("lap", write("lap.csv", circle()))));
        const TrialRecord trial = m_project->trials().find("lap").value();
        QVERIFY(m_project->trials().setBinned(trial.id, true));
        QVERIFY(m_project->trials().removeForGood(trial.id));
        QVERIFY(importedTracksOf(*m_project, trial)->empty());
    }
    void mistakesLeaveTheProjectAlone()
    {
        QVERIFY(import(settingsOf("lap", write("lap.csv", circle()))));
        QCOMPARE(
            errorOf(settingsOf("lap", write("lap.csv", circle()))),
            std::string(
                "import of trial 'lap': the project already has a trial of that name; choose another name"));
        QCOMPARE(errorOf(settingsOf("new", "nowhere.csv")),
                 std::string("'nowhere.csv': the file does not exist; check the name and the folder"));
        const auto bad = write("bad.csv", "t_s,x_mm,y_mm\n0,0,0\n0,0,0\n");
        QCOMPARE(errorOf(settingsOf("new", bad)),
                 bad.string() + ":3: its time is the same as in the line before; sort the lines by time, "
                                "with each time only once");
        ImportTracksSettings twice = settingsOf("new", write("lap.csv", circle()));
        twice.tracks.push_back(twice.tracks.front());
        QCOMPARE(errorOf(twice),
                 std::string("import of trial 'new': robot 'red' was given two tracks; give each robot one"));
        QVERIFY(
            errorOf(settingsOf("new\nline", write("lap.csv", circle()))).starts_with("name of a trial: "));
        ImportTracksSettings unknown = settingsOf("new", write("lap.csv", circle()));
        unknown.tracks[0].first = std::string(10000, 'x');
        QVERIFY(errorOf(unknown).find("at most 200") != std::string::npos);
        JobControl control;
        control.cancel.cancel();
        ImportTracksJob job(settingsOf("new", write("lap.csv", circle())));
        const auto stopped = runToEnd(job, *m_project, control);
        QVERIFY(!stopped && stopped.error().code == ErrorCode::Cancelled);
        QVERIFY(!m_project->trials().find("new"));
    }
};

ODOGRAPH_TEST(TestImportTracksJob, QCoreApplication)
#include "tst_import_tracks_job.moc"
