// SPDX-License-Identifier: GPL-3.0-or-later
// What is changed by hand in a project is found: by the digests of its analyses, and by computing its metrics
// again.
#include "core/base/error.h"
#include "core/project/internal/connection.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/trajectory/imported_track.h"
#include "tests/project/sample_records.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using Access = Project::Access;
using Proof = AnalysisRecord::Proof;

class TestAnalysisDigest : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::filesystem::path m_file;
    std::unique_ptr<Project> m_project;
    FilledProject m_filled;

    /// As somebody with a database program would; what the project's triggers forbid too.
    void byHand(const QString &sql) const
    {
        const auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadWrite);
        for (const char *trigger :
             {"observation_chunk_kept_on_update", "imported_track_chunk_kept_on_update"})
            QVERIFY((*connection)
                        ->execute(QStringLiteral("DROP TRIGGER IF EXISTS %1").arg(QLatin1String(trigger))));
        const auto done = (*connection)->execute(sql);
        QVERIFY2(done, done ? "" : done.error().message().c_str());
    }
    /// What is found in the trial, without its place and advice.
    QStringList found(bool withHashes) const
    {
        QStringList problems;
        const auto all = m_project->check(withHashes);
        for (const ProjectProblem &problem : *all) {
            if (problem.where.code() == "base.trial" || problem.what.code() == "project.marker_errors_differ")
                problems << QString::fromStdString(problem.what.english());
        }
        return problems;
    }
    Proof proof(RecordId trial) const { return m_project->analyses().current(trial)->at(0).proof; }

    /// A trial with an imported track round a circle and its real analysis.
    RecordId imported(const std::string &name, std::size_t positions)
    {
        std::vector<ImportedPosition> track;
        for (std::size_t i = 0; i < positions; ++i) {
            const double t = double(i) / 50;
            track.push_back(
                {fromSeconds(t), Eigen::Vector2d(0.5 * std::cos(2 * t), 0.5 * std::sin(2 * t)), {}});
        }
        ImportedTrack source{0,
                             m_filled.robot,
                             {},
                             "lap.csv",
                             "00ff",
                             9,
                             "csv",
                             foreignWords("metres"),
                             samplesOfImported(track, 0.001)};
        AnalysisRecord analysis;
        analysis.robot = m_filled.robot;
        analysis.softwareVersion = ODOGRAPH_VERSION;
        analysis.profile = *analyseImported(source.samples, {});
        TrialRecord trial;
        trial.name = name;
        trial.robots = {m_filled.robot};
        trial.durationS = toSeconds(track.back().time);
        trial.syncMethod = "none";
        source.trial = analysis.trial = m_project->trials().add(trial, {})->id;
        if (!m_project->trials().addImportedTrack(source) || !m_project->analyses().add(analysis))
            qFatal("the track is not stored");
        return analysis.trial;
    }

private Q_SLOTS:
    void init()
    {
        m_file = m_folder.filePath(QStringLiteral("%1.odo").arg(QLatin1String(QTest::currentTestFunction())))
                     .toStdString();
        std::filesystem::remove(m_file);
        m_project = *Project::create(m_file, "digests");
        RecordSource source(7);
        m_filled = *fill(*m_project, source);
    }
    void cleanup() { m_project.reset(); }

    void whatIsStoredHolds()
    {
        QCOMPARE(found(false), QStringList());
        QCOMPARE(proof(m_filled.trial), Proof::Holds);
        QCOMPARE(m_project->analyses().countWithoutDigest().value(), 0);
        m_project = *Project::open(m_file, Access::ReadOnly);
        QCOMPARE(proof(m_filled.trial), Proof::Holds);
    }

    void whatIsChangedByHandIsNamed_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<QString>("problem");
        QTest::addColumn<bool>("isShown"); // wherever the analysis is
        const QString results = QStringLiteral(
            "the stored metrics, spikes or settings of robot 'red' differ from those of its analysis");
        const QString positions =
            QStringLiteral("the stored positions of robot 'red' differ from those of its analysis");
        const QString since = QStringLiteral(" changed since robot 'red' was analysed");
        const QString byte = QStringLiteral("=CAST(substr(%1,1,40)||x'5a'||substr(%1,42) AS BLOB)");
        const auto row = [](const char *name, const QString &sql, const QString &problem, bool isShown) {
            QTest::newRow(name) << sql << problem << isShown;
        };
        row("metric", QStringLiteral("UPDATE metric SET value=value*0.5 WHERE name='duration'"), results,
            true);
        row("its sigma", QStringLiteral("UPDATE metric SET sigma=0.001 WHERE name='max_speed'"), results,
            true);
        row("metric removed", QStringLiteral("DELETE FROM metric WHERE name='duration'"), results, true);
        row("spike", QStringLiteral("DELETE FROM spike"), results, true);
        row("passage", QStringLiteral("UPDATE gate_passage SET time_ns=time_ns-1"), results, true);
        row("doubt of a name", QStringLiteral("UPDATE doubtful_name SET to_ns=to_ns+1"), results, true);
        row("whom it may be", QStringLiteral("DELETE FROM doubtful_name_robot"), results, true);
        row("all doubts", QStringLiteral("DELETE FROM doubtful_name"), results, true);
        row("setting", QStringLiteral("UPDATE analysis SET max_speed_m_s=1"), results, true);
        row("sample",
            QStringLiteral("UPDATE analysis_chunk SET samples") + byte.arg(QStringLiteral("samples")),
            positions, true);
        row("point", QStringLiteral("UPDATE analysis_chunk SET points") + byte.arg(QStringLiteral("points")),
            positions, true);
        row("observation",
            QStringLiteral("UPDATE observation_chunk SET observations") +
                byte.arg(QStringLiteral("observations")),
            QStringLiteral("the measurements have") + since, false);
        row("hash of a recording", QStringLiteral("UPDATE recording SET sha256='00aa' WHERE position=1"),
            QStringLiteral("the recordings or their synchronisation have") + since, false);
        row("synchronisation",
            QStringLiteral("UPDATE recording SET start_offset_s=start_offset_s+0.01 WHERE position=1"),
            QStringLiteral("the recordings or their synchronisation have") + since, false);
        row("registration", QStringLiteral("UPDATE registration SET x_m=x_m+0.01"),
            QStringLiteral("the registrations have") + since, false);
        row("lens", QStringLiteral("UPDATE lens SET fx_px=fx_px+1"),
            QStringLiteral("the registrations have") + since, false);
        row("manual override",
            QStringLiteral("INSERT INTO overrule SELECT DISTINCT trial_id, robot_id, 3, 1 FROM analysis"),
            QStringLiteral("the manual overrides have") + since, false);
        row("manual override of the analysis",
            QStringLiteral("INSERT INTO analysis_overrule SELECT MAX(id), 3, 1 FROM analysis"),
            QStringLiteral("the manual overrides have") + since, true);
        row("synchronisation of the trial",
            QStringLiteral("UPDATE trial SET sync_offset_s=0.5, sync_method='motion'"),
            QStringLiteral("its stored synchronisation differs from that of its second view"), false);
        const QString markers =
            QStringLiteral("the stored marker errors of registration 1 differ from those of its markers");
        row("errors of markers in m", QStringLiteral("UPDATE registration_error SET error_m=0"), markers,
            false);
        row("errors of markers in px", QStringLiteral("UPDATE registration_error SET error_px=0"), markers,
            false);
        row("gate", QStringLiteral("UPDATE gate SET to_x_m=to_x_m+0.01"),
            QStringLiteral("the task has") + since, false);
    }
    void whatIsChangedByHandIsNamed()
    {
        QFETCH(QString, sql);
        QFETCH(QString, problem);
        QFETCH(bool, isShown);
        RecordSource source(8);
        AnalysisRecord analysis = source.analysis(m_filled.trial, m_filled.robot, 50);
        analysis.registrations = {1, 0};
        analysis.task = 1;
        QVERIFY(m_project->analyses().add(analysis));
        QCOMPARE(found(false), QStringList());
        byHand(sql);
        for (const bool withHashes : {false, true})
            QVERIFY2(found(withHashes).contains(problem), qPrintable(found(withHashes).join(u'\n')));
        if (!QByteArrayView(QTest::currentDataTag()).startsWith("sample") &&
            !QByteArrayView(QTest::currentDataTag()).startsWith("point"))
            QCOMPARE(proof(m_filled.trial), isShown ? Proof::Broken : Proof::Holds);
    }

    /// It would give positions on another floor. It is not used, and named.
    void anotherCamerasRevisionIsNeverInForce()
    {
        const RecordId other = m_project->cameras().find("Б")->id;
        byHand(QStringLiteral("UPDATE camera SET registration_id=1, intrinsics_id=1 WHERE id=%1").arg(other));
        QVERIFY(!m_project->cameras().currentRegistration(other).value());
        QVERIFY(!m_project->cameras().currentIntrinsics(other).value());
        QStringList problems;
        const auto all = m_project->check(false);
        for (const ProjectProblem &problem : *all) {
            if (problem.where == cameraSubject("Б"))
                problems << QString::fromStdString(problem.what.english());
        }
        QCOMPARE(
            problems,
            QStringList(
                {QStringLiteral(
                     "calibration 1 was chosen for it but belongs to camera 'A'; its own newest one is used"),
                 QStringLiteral("registration 1 was chosen for it but belongs to camera 'A'; its own newest "
                                "one is used")}));
    }

    void aChangedDurationIsNamed()
    {
        imported("lap", 200);
        QCOMPARE(found(false), QStringList());
        byHand(QStringLiteral("UPDATE trial SET duration_s=1"));
        const QString end = QString::number(
            toSeconds(m_project->trials().recordings(m_filled.trial)->front().frameTimes.back()), 'f', 3);
        const QStringList expected{
            QStringLiteral("its duration is stored as 1.000 s, its recordings last %1 s").arg(end),
            QStringLiteral("its duration is stored as 1.000 s, its imported tracks last 3.980 s")};
        QCOMPARE(found(false), expected);
    }

    void aForgedMetricIsToldWithTheRightOne()
    {
        imported("lap", 200);
        QCOMPARE(found(false), QStringList());
        byHand(QStringLiteral("UPDATE metric SET value=value*0.5 WHERE name='duration' AND "
                              "analysis_id=(SELECT MAX(id) FROM analysis)"));
        const QString told = QStringLiteral(
            "metric 'duration' of robot 'red' is stored as 1.990000 s, its positions give 3.980000 s");
        QVERIFY2(found(false).contains(told), qPrintable(found(false).join(u'\n')));
        QVERIFY(found(true).contains(told));
        byHand(QStringLiteral("UPDATE metric SET value=value*2 WHERE name='duration' AND analysis_id=(SELECT "
                              "MAX(id) FROM analysis)"));
        QCOMPARE(found(false), QStringList());
        byHand(QStringLiteral("UPDATE metric SET sigma=0 WHERE name='path_length' AND analysis_id=(SELECT "
                              "MAX(id) FROM analysis)"));
        QVERIFY2(
            found(false).join(u'\n').contains(QStringLiteral("the standard deviation of metric 'path_length' "
                                                             "of robot 'red' is stored as 0.000000 m, its")),
            qPrintable(found(false).join(u'\n')));
    }

    /// Who forges the digest as well is found by the metrics, in a check of everything.
    void aForgedDigestProvesNothing()
    {
        const RecordId trial = imported("lap", 200);
        AnalysisRecord forged = m_project->analyses().current(trial)->at(0);
        forged.profile.metrics.front().value /= 2;
        QVERIFY(m_project->analyses().add(forged));
        QCOMPARE(found(false), QStringList());
        QVERIFY(found(true).contains(QStringLiteral(
            "metric 'duration' of robot 'red' is stored as 1.990000 s, its positions give 3.980000 s")));
    }

    /// Analyses of older formats: nothing proves them, but their metrics are compared with their positions.
    void withoutDigestsMetricsAreComputedAgain()
    {
        const RecordId trial = imported("lap", 200);
        byHand(
            QStringLiteral("DELETE FROM analysis_digest WHERE analysis_id=(SELECT MAX(id) FROM analysis)"));
        QCOMPARE(found(false), QStringList());
        QCOMPARE(proof(trial), Proof::NotKept);
        QCOMPARE(m_project->analyses().countWithoutDigest().value(), 1);
        byHand(QStringLiteral("UPDATE metric SET value=2 WHERE name='duration' AND analysis_id=(SELECT "
                              "MAX(id) FROM analysis)"));
        QCOMPARE(
            found(false),
            QStringList(QStringLiteral(
                "metric 'duration' of robot 'red' is stored as 2.000000 s, its positions give 3.980000 s")));
    }

    void aLostDigestIsNoProof()
    {
        byHand(QStringLiteral("DELETE FROM analysis_digest WHERE part='results'"));
        QCOMPARE(proof(m_filled.trial), Proof::Broken);
    }

    /// The hash of a recording is made after its trial was analysed, and nothing else may be slipped in with
    /// it.
    void aHashThatComesLaterIsRight()
    {
        QVERIFY(m_project->trials().setHash(m_filled.recordings[0], "00bb"));
        QCOMPARE(found(false), QStringList());
        byHand(QStringLiteral("UPDATE recording SET clock_rate=0.5"));
        QVERIFY(m_project->trials().setHash(m_filled.recordings[0], "00cc"));
        QVERIFY(found(false).contains(QStringLiteral(
            "the recordings or their synchronisation have changed since robot 'red' was analysed")));
    }

    /// Long series lie in chunks of less than a megabyte, and come back as they were.
    void longSeriesLieInChunks()
    {
        const RecordId trial = imported("long", 20'000);
        const auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadOnly);
        for (const char *sql : {"SELECT MAX(LENGTH(samples)) FROM analysis_chunk",
                                "SELECT MAX(LENGTH(points)) FROM analysis_chunk",
                                "SELECT MAX(LENGTH(samples)) FROM imported_track_chunk"})
            QVERIFY2((*connection)->number(QString::fromLatin1(sql)).value() < 1 << 20, sql);
        QCOMPARE(
            (*connection)
                ->number(QStringLiteral(
                    "SELECT COUNT(*) FROM analysis_chunk WHERE analysis_id=(SELECT MAX(id) FROM analysis)"))
                .value(),
            3);
        const AnalysisRecord read = m_project->analyses().current(trial)->at(0);
        QCOMPARE(read.profile.samples.size(), std::size_t(20'000));
        QCOMPARE(read.profile.points.size(), std::size_t(20'000));
        QCOMPARE(read.profile.samples[19'999].time, fromSeconds(399.98));
        QCOMPARE(m_project->trials().currentImportedTrack(trial, m_filled.robot)->value().samples.size(),
                 std::size_t(20'000));
        const auto source = m_project->trials().currentImportedTrack(trial, m_filled.robot, false).value();
        QVERIFY(source->samples.empty());
        QVERIFY(std::abs(source->noiseM - 0.001) < 1e-12);
    }

    /// An error of the source of samples ends the storing, and nothing is left of it.
    void storingStopsWithItsSource()
    {
        const RecordId trial = imported("lap", 200);
        AnalysisRecord analysis = m_project->analyses().current(trial)->at(0);
        const SampleSource ending{analysis.profile.points.size(),
                                  [](std::size_t, std::size_t) -> Result<std::vector<Sample>> {
                                      return cancelled(foreignWords("import"));
                                  }};
        QCOMPARE(m_project->analyses().add(analysis, ending).error().code, ErrorCode::Cancelled);
        QCOMPARE(m_project->analyses().current(trial)->at(0).id, analysis.id);
    }

    void isCancelled()
    {
        JobControl control;
        control.cancel.cancel();
        QCOMPARE(m_project->check(false, control).error().code, ErrorCode::Cancelled);
        QCOMPARE(m_project->check(true, control).error().code, ErrorCode::Cancelled);
    }
};

ODOGRAPH_TEST(TestAnalysisDigest, QCoreApplication)
#include "tst_analysis_digest.moc"
