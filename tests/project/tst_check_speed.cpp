// SPDX-License-Identifier: GPL-3.0-or-later
// Thousands of trials are checked quickly, and each file is read once, however many trials it belongs to.
#include "core/base/error.h"
#include "core/project/internal/analysis_digest.h"
#include "core/project/internal/connection.h"
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "tests/project/sample_records.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

/// Ten thousand with the long tests (ODOGRAPH_CHECK_TRIALS).
int trialCount()
{
    return std::max(qEnvironmentVariableIntValue("ODOGRAPH_CHECK_TRIALS"), 40);
}
constexpr int frames = 280; // as a trial of the demo lesson
constexpr int manyTrials = 10'000;
constexpr std::int64_t firstCopy = 1'000'000;

/// Copies of the rows of a table that a condition names, one for each number in `copies`; columns by their
/// expressions of `number`.
Result<void> copyRows(ProjectConnection &connection, const QString &table, const QString &where,
                      const QMap<QString, QString> &changed)
{
    QStringList names, values;
    Statement columns(connection, QStringLiteral("SELECT name FROM pragma_table_info('%1')").arg(table));
    auto read = columns.eachRow([&](const Statement &row) -> Result<void> {
        const QString name = QString::fromStdString(row.text(0));
        names << name;
        values << changed.value(name, table + u'.' + name);
        return {};
    });
    if (!read)
        return read;
    return connection.execute(QStringLiteral("INSERT INTO %1 (%2) SELECT %3 FROM copies, %1 WHERE %4")
                                  .arg(table, names.join(u','), values.join(u','), where));
}

} // namespace

class TestCheckSpeed : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    const std::filesystem::path m_file = m_folder.filePath(QStringLiteral("year.odo")).toStdString();

    /// A trial of two views, whose recordings are one file.
    RecordId addTrial(Project &project)
    {
        const std::filesystem::path video = m_folder.filePath(QStringLiteral("clip.mkv")).toStdString();
        QFile file(QString::fromStdString(video.string()));
        if (!file.open(QIODevice::WriteOnly) || file.write(QByteArray(4 << 20, 'x')) != 4 << 20 ||
            !file.flush())
            qFatal("no video");
        RecordSource source(5);
        const auto filled = *fill(project, source);
        std::vector<RecordingRecord> recordings;
        for (const char *camera : {"A", "Б"}) {
            RecordingRecord recording = source.recording(project.cameras().find(camera)->id, frames);
            recording.path = "clip.mkv";
            recording.bytes = 4 << 20;
            recording.sha256 = *fileSha256(video, {});
            recordings.push_back(recording);
        }
        TrialRecord trial;
        trial.name = "copied";
        trial.robots = {filled.robot};
        describe(trial, recordings);
        trial = *project.trials().add(trial, recordings);
        const auto stored = project.trials().recordings(trial.id);
        for (const RecordingRecord &recording : *stored) {
            ObservationSeries series{recording.id, filled.robot, "colour 1", {}};
            for (int i = 0; i < frames; ++i)
                series.observations.push_back(source.observation(i));
            if (!project.trials().addObservations(series))
                qFatal("no observations");
        }
        AnalysisRecord analysis = source.analysis(trial.id, filled.robot, frames);
        analysis.registrations = {1, 0};
        // its metrics are invented: an older version may have computed them otherwise
        analysis.softwareVersion = "0.0.1";
        if (!project.analyses().add(analysis))
            qFatal("no analysis");
        return trial.id;
    }

    Result<void> copyTrial(RecordId trial) const
    {
        const auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadWrite);
        ProjectConnection &c = **connection;
        const auto number = [&](const char *sql) { return *c.number(QString::fromLatin1(sql).arg(trial)); };
        const QString of = QStringLiteral("trial_id=%1").arg(trial),
                      id = QStringLiteral("(%1+number)").arg(firstCopy);
        const std::int64_t analysis = number("SELECT MAX(id) FROM analysis WHERE trial_id=%1");
        return transact(c, [&]() -> Result<void> {
            std::vector<Result<void>> done;
            done.push_back(c.execute(QStringLiteral("CREATE TEMP TABLE copies AS WITH RECURSIVE n(number) AS "
                                                    "(VALUES(1) UNION ALL SELECT number+1 "
                                                    "FROM n WHERE number<%1) SELECT number FROM n")
                                         .arg(trialCount())));
            done.push_back(copyRows(
                c, QStringLiteral("trial"), QStringLiteral("id=%1").arg(trial),
                {{QStringLiteral("id"), id}, {QStringLiteral("name"), QStringLiteral("'Run '||number")}}));
            for (const int view : {0, 1}) {
                const std::int64_t recording =
                    number(view == 0 ? "SELECT MIN(id) FROM recording WHERE trial_id=%1"
                                     : "SELECT MAX(id) FROM recording WHERE trial_id=%1");
                const std::int64_t series = *c.number(
                    QStringLiteral("SELECT id FROM observation_series WHERE recording_id=%1").arg(recording));
                const QString copy = QStringLiteral("(%1+2*number+%2)").arg(firstCopy).arg(view),
                              its = QStringLiteral("recording_id=%1").arg(recording);
                done.push_back(copyRows(c, QStringLiteral("recording"),
                                        QStringLiteral("id=%1").arg(recording),
                                        {{QStringLiteral("id"), copy}, {QStringLiteral("trial_id"), id}}));
                done.push_back(copyRows(c, QStringLiteral("frame_time_chunk"), its,
                                        {{QStringLiteral("recording_id"), copy}}));
                done.push_back(
                    copyRows(c, QStringLiteral("observation_series"), its,
                             {{QStringLiteral("id"), copy}, {QStringLiteral("recording_id"), copy}}));
                done.push_back(copyRows(c, QStringLiteral("observation_chunk"),
                                        QStringLiteral("series_id=%1").arg(series),
                                        {{QStringLiteral("series_id"), copy}}));
            }
            done.push_back(
                copyRows(c, QStringLiteral("trial_robot"), of, {{QStringLiteral("trial_id"), id}}));
            done.push_back(copyRows(c, QStringLiteral("analysis"), QStringLiteral("id=%1").arg(analysis),
                                    {{QStringLiteral("id"), id}, {QStringLiteral("trial_id"), id}}));
            for (const char *table : {"analysis_view", "analysis_chunk", "metric", "spike", "gate_passage"})
                done.push_back(copyRows(c, QString::fromLatin1(table),
                                        QStringLiteral("analysis_id=%1").arg(analysis),
                                        {{QStringLiteral("analysis_id"), id}}));
            for (int copy = 1; copy <= trialCount(); ++copy)
                done.push_back(writeDigests(c, firstCopy + copy));
            for (const Result<void> &each : done)
                if (!each)
                    return each;
            return c.execute(QStringLiteral("DROP TABLE copies"));
        });
    }

private Q_SLOTS:
    void initTestCase()
    {
        const auto project = Project::create(m_file, "year");
        const RecordId trial = addTrial(**project);
        const auto copied = copyTrial(trial);
        QVERIFY2(copied, copied ? "" : copied.error().message().c_str());
        QCOMPARE((*project)->trials().names()->size(), std::size_t(trialCount() + 2));
    }

    void isQuickAndReadsEachFileOnce()
    {
        const auto project = Project::open(m_file, Project::Access::ReadOnly);
        QVERIFY2(project, project ? "" : project.error().message().c_str());
        for (const bool withHashes : {false, true}) {
            int read = 0;
            JobControl control;
            control.progress = [&](double fraction, const Message &text) {
                read += text.code() == "project.reading";
                QVERIFY(fraction >= 0 && fraction <= 1);
            };
            QElapsedTimer clock;
            clock.start();
            const auto problems = (*project)->check(withHashes, control);
            const double seconds = double(clock.elapsed()) / 1000;
            qInfo("%d trials, %lld bytes, %s: %.1f s", trialCount(),
                  static_cast<long long>(std::filesystem::file_size(m_file)), withHashes ? "all" : "quick",
                  seconds);
            // the pictures and videos that sample records name were never there
            for (const ProjectProblem &problem : *problems)
                QVERIFY2(problem.what.code() == "project.is_missing" ||
                             problem.where == trialSubject("run 1"),
                         problem.what.english().c_str());
            QCOMPARE(read, withHashes ? 1 : 0);
            if (!withHashes && trialCount() >= manyTrials)
                QVERIFY2(seconds < 5 * test::slowness, qPrintable(QString::number(seconds)));
        }
    }

    /// A file that is missing or changed is told of once, not for each of its trials.
    void aChangedFileIsToldOnce()
    {
        const QString video = m_folder.filePath(QStringLiteral("clip.mkv"));
        const auto project = Project::open(m_file, Project::Access::ReadOnly);
        const auto told = [&] {
            QStringList words;
            const auto problems = (*project)->check(true);
            for (const ProjectProblem &problem : *problems) {
                if (problem.where == fileSubject(video.toStdString()))
                    words << QString::fromStdString(problem.what.english());
            }
            return words;
        };
        const QStringList changed{
            QStringLiteral("the recording of view 'A' has changed since it was created"),
            QStringLiteral("the recording of view 'Б' has changed since it was created")};
        QFile file(video);
        QVERIFY(file.open(QIODevice::ReadWrite) && file.write("y") == 1);
        file.close();
        QCOMPARE(told(), changed);
        QVERIFY(file.remove());
        QCOMPARE(told().size(), 2);
    }
};

ODOGRAPH_TEST(TestCheckSpeed, QCoreApplication)
#include "tst_check_speed.moc"
