// SPDX-License-Identifier: GPL-3.0-or-later
// What a person puts right afterwards, in any order: raw measurements stay to the last bit, the project
// passes its check, and undoing all of it leads back to the figures of before.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/workflow/import/import_tracks_job.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/track/guidance.h"
#include "core/workflow/track/reanalysis.h"
#include "core/workflow/track/synchronise_job.h"
#include "core/workflow/track/track_job.h"
#include "core/workflow/trials/trial_changes.h"
#include "tests/support/registered_test.h"
#include "tests/support/simulated_set_up.h"

#include <QFile>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QSqlRecord>
#include <QTemporaryDir>
#include <QTest>
#include <random>

using namespace odo;
using namespace odo::test;

namespace {

/// What nothing may change.
QByteArray rawOf(const std::filesystem::path &file)
{
    QByteArray raw;
    {
        QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("raw"));
        database.setDatabaseName(QString::fromStdString(file.string()));
        database.setConnectOptions(QStringLiteral("QSQLITE_OPEN_READONLY"));
        database.open();
        for (const char *sql :
             {"SELECT series_id, position, hex(observations) FROM observation_chunk WHERE series_id<=2 ORDER "
              "BY 1, 2",
              "SELECT recording_id, position, hex(pictures), hex(readings) FROM raw_time_chunk ORDER BY 1, 2",
              "SELECT track_id, position, hex(samples) FROM imported_track_chunk ORDER BY 1, 2",
              "SELECT id, trial_id, path, sha256, bytes FROM recording WHERE trial_id<=2 ORDER BY 1"}) {
            QSqlQuery query(database);
            if (!query.exec(QString::fromLatin1(sql)))
                qFatal("%s: %s", sql, qPrintable(query.lastError().text()));
            while (query.next()) {
                for (int column = 0; column < query.record().count(); ++column)
                    raw += query.value(column).toByteArray() + '|';
            }
        }
    }
    QSqlDatabase::removeDatabase(QStringLiteral("raw"));
    return raw;
}

} // namespace

class TestCorrections : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;

    std::filesystem::path path(const char *name) const
    {
        return m_folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    TrialRecord trial(const char *name) const { return m_project->trials().find(name).value(); }
    /// The metrics of both trials in words, the ranges and the synchronisation.
    std::string figures() const
    {
        std::string words;
        const std::vector<TrialRecord> all = m_project->trials().all().value();
        for (const TrialRecord &one : all) {
            if (one.binned)
                continue;
            words += one.name + ' ' + one.teamName + ' ' + one.notes + ' ' + std::to_string(one.syncOffsetS);
            const std::vector<AnalysisRecord> current = m_project->analyses().current(one.id).value();
            for (const AnalysisRecord &analysis : current)
                for (const Metric &metric : analysis.profile.metrics)
                    words += ' ' + metric.name + '=' + std::to_string(metric.value) + "+-" +
                             std::to_string(metric.sigma.value_or(0));
            words += '\n';
        }
        return words;
    }
    std::string problems() const
    {
        const auto found = m_project->check(true).value();
        return found.empty() ? std::string() : found.front().what.english();
    }
    Result<void> run(Job &&job) const { return runToEnd(job, *m_project, {}); }
    Result<void> correct(std::mt19937 &random);

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { m_project.reset(); }
    void trackingIsUndone();
    void anImportIsUndoneIntoTheBin();
    void anyOrderLeadsBack();
};

void TestCorrections::initTestCase()
{
    SimulatedScene scene = demoTestbed(5);
    scene.durationS = 3;
    scene.cameras[1].startOffsetS = 0.013;
    scene.robots = {demoRobot("robot", {.colour = demoBlue, .heightM = 0.06},
                              makeFigureEightMotion({1.5, 1.1}, 0.9, 0.6, 6, 0.5))};
    QVERIFY(renderVideo(scene, 0, path("a.mkv"), {}, {}));
    QVERIFY(renderVideo(scene, 1, path("b.mkv"), {}, {}));
    m_project = Project::create(path("class.odo"), "Class").value();
    const RecordId layout = m_project->layouts().add(scene.floor.markers)->id;
    for (const SimulatedCamera &camera : scene.cameras)
        QVERIFY(registerSimulatedCamera(*m_project, camera, scene.floor.markers, layout));
    QVERIFY(addSimulatedRobot(*m_project, scene.robots[0]));
    ImportSettings settings;
    settings.trial = "filmed";
    settings.videos = {{"A", path("a.mkv")}, {"B", path("b.mkv")}};
    settings.steps = {{SyncBy::Given, 0.013}};
    QVERIFY(run(ImportTrialJob(settings)));
    QVERIFY(run(TrackJob("filmed", {})));
    QFile file(QString::fromStdString(path("track.csv").string()));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("t_s,x_mm,y_mm\n");
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 1);
    for (int i = 0; i < 200; ++i)
        file.write(QByteArray::number(i / 30.0, 'f', 6) + ',' +
                   QByteArray::number(600 * std::cos(i / 40.0) + noise(random), 'f', 3) + ',' +
                   QByteArray::number(600 * std::sin(i / 40.0) + noise(random), 'f', 3) + '\n');
    file.close();
    ImportTracksSettings tracks;
    tracks.trial = "loaded";
    tracks.tracks = {{"red", path("track.csv")}};
    QVERIFY(run(ImportTracksJob(tracks)));
    QCOMPARE(problems(), std::string());
}

void TestCorrections::trackingIsUndone()
{
    const std::string before = figures();
    const QByteArray raw = rawOf(path("class.odo"));
    QVERIFY(run(TrackJob("filmed", {})));
    QCOMPARE(m_project->undoWords().english(), std::string("track filmed"));
    QVERIFY(m_project->undo());
    QCOMPARE(figures(), before);
    QCOMPARE(problems(), std::string());
    QVERIFY(m_project->redo());
    QCOMPARE(figures(), before); // the same video by the same program
    QCOMPARE(problems(), std::string());
    // A range, what is tracked within it, and both undone: trial and analysis agree.
    QVERIFY(editTrial(*m_project, trial("filmed").id, {.range = RangeSeconds{1, 2}}));
    QVERIFY(run(TrackJob("filmed", {})));
    QVERIFY(m_project->undo());
    QVERIFY(m_project->undo());
    QVERIFY(!trial("filmed").range);
    QCOMPARE(figures(), before);
    QCOMPARE(problems(), std::string());
    QVERIFY(rawOf(path("class.odo")) == raw);
}

void TestCorrections::anImportIsUndoneIntoTheBin()
{
    ImportTracksSettings tracks;
    tracks.trial = "again";
    tracks.tracks = {{"red", path("track.csv")}};
    QVERIFY(run(ImportTracksJob(tracks)));
    QVERIFY(!trial("again").binned);
    QVERIFY(m_project->undo());
    QVERIFY(trial("again").binned);
    QVERIFY(m_project->redo());
    QVERIFY(!trial("again").binned);
    QVERIFY(m_project->undo());
    QCOMPARE(problems(), std::string());
}

/// One correction of any kind; of those that are refused nothing may stay.
Result<void> TestCorrections::correct(std::mt19937 &random)
{
    const auto upTo = [&](int most) { return std::uniform_int_distribution(0, most)(random); };
    const char *name = upTo(1) == 0 ? "filmed" : "loaded";
    const std::string robot = name == std::string("filmed") ? "robot" : "red";
    const auto edit = [&](const TrialEdit &what) {
        return withoutValue(editTrial(*m_project, trial(name).id, what));
    };
    switch (upTo(13)) {
    case 0:
        return edit({.team = "team " + std::to_string(upTo(2))});
    case 1:
        return edit({.notes = "note " + std::to_string(upTo(99)), .variables = {{"floor", "carpet"}}});
    case 2:
        return edit({.range = RangeSeconds{0.1 * upTo(10), 1.5 + 0.1 * upTo(20)}});
    case 3:
        return edit({.range = RangeOfMotion()});
    case 4:
        return edit({.range = WholeRun()});
    case 5:
        return run(SynchroniseJob("filmed", {{SyncBy::Given, 0.001 * upTo(40)}}));
    case 6:
    case 7:
        return run(OverrideJob({name, robot, std::nullopt, upTo(80),
                                upTo(1) == 0 ? OverrideRequest::Word::Spike : OverrideRequest::Word::Clear}));
    case 8: {
        ReprocessJob job(name);
        ODO_TRY(runToEnd(job, *m_project, {}));
        return job.keep(*m_project);
    }
    case 10: {
        GuidanceEdit guidance;
        guidance.clearsAll = upTo(2) == 0;
        const double x = 100.0 * upTo(8);
        guidance.added.push_back({GuidanceItem::Kind::Ignore, "A", {{x, 0}, {x + 80, 0}, {x, 700}}});
        return changeGuidance(*m_project, "filmed", guidance);
    }
    case 11: {
        TrackSettings settings;
        settings.again = true;
        const double from = 0.1 * upTo(20);
        if (upTo(1) == 0)
            settings.guidance.added.push_back(
                {GuidanceItem::Kind::Hidden, "A", {}, "robot", from, from + 0.2});
        else
            settings.guidance.added.push_back(
                {GuidanceItem::Kind::Point, "B", {{500.0 + upTo(99), 400}}, "robot", from, from, 30});
        return run(TrackJob("filmed", settings));
    }
    case 9:
        return setInBin(*m_project, {trial(name)}, upTo(1) == 0);
    default:
        return upTo(3) > 0 ? Result<void>() : run(TrackJob("filmed", {}));
    }
}

void TestCorrections::anyOrderLeadsBack()
{
    const int corrections = std::max(40, qEnvironmentVariableIntValue("ODOGRAPH_CORRECTIONS"));
    std::mt19937 random(9);
    m_project.reset(); // what was done so far is not undone
    m_project = Project::open(path("class.odo"), Project::Access::ReadWrite).value();
    const std::string before = figures();
    const QByteArray raw = rawOf(path("class.odo"));
    int refused = 0;
    for (int i = 0; i < corrections; ++i) {
        const int choice = std::uniform_int_distribution(0, 9)(random);
        if (choice == 0 && !m_project->undoWords().isEmpty())
            QVERIFY(m_project->undo());
        else if (choice == 1 && !m_project->redoWords().isEmpty())
            QVERIFY(m_project->redo());
        else if (const auto done = correct(random); !done)
            ++refused;
        if (i % 20 == 0)
            QCOMPARE(problems(), std::string());
    }
    QVERIFY2(refused < corrections / 2, qPrintable(QString::number(refused)));
    QCOMPARE(problems(), std::string());
    while (!m_project->undoWords().isEmpty()) {
        const auto undone = m_project->undo();
        QVERIFY2(undone, undone ? "" : undone.error().message().c_str());
    }
    QCOMPARE(figures(), before);
    QCOMPARE(problems(), std::string());
    QVERIFY(rawOf(path("class.odo")) == raw);
}

ODOGRAPH_TEST(TestCorrections, QCoreApplication)
#include "tst_corrections.moc"
