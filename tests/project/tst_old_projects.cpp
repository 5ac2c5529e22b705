// SPDX-License-Identifier: GPL-3.0-or-later
// Projects of every older format, as tests/data keeps them: opened, brought to the newest format, and nothing
// lost.
#include "core/project/internal/analysis_digest.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/opening_check.h"
#include "core/project/internal/schema.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <sqlite3.h>

using namespace odo;
using Access = Project::Access;

class TestOldProjects : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::filesystem::path file(const QString &name) const
    {
        return std::filesystem::path(m_folder.filePath(name).toStdString());
    }

    /// A file of an old format, with the statements of its dump.
    std::filesystem::path stored(int format, const QString &name) const
    {
        QFile dump(QDir(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR"))
                       .filePath(QStringLiteral("tests/data/project_format_%1.sql").arg(format)));
        if (!dump.open(QIODevice::ReadOnly))
            qFatal("no dump of format %d", format);
        const std::filesystem::path made = file(name);
        sqlite3 *database = nullptr;
        char *why = nullptr;
        if (sqlite3_open(made.c_str(), &database) != SQLITE_OK ||
            sqlite3_exec(database, dump.readAll().constData(), nullptr, nullptr, &why) != SQLITE_OK)
            qFatal("format %d: %s", format, why);
        sqlite3_close(database);
        return made;
    }

    static std::int64_t number(const std::filesystem::path &of, const char *sql)
    {
        const auto connection = ProjectConnection::open(of, DatabaseAccess::Immutable);
        return connection ? (*connection)->number(QString::fromLatin1(sql)).value_or(-1) : -1;
    }

    static void formats()
    {
        QTest::addColumn<int>("format");
        for (int format = 1; format < projectMigrator().newestVersion(); ++format)
            QTest::addRow("format %d", format) << format;
    }

private Q_SLOTS:
    void openingKeepsEverything_data() { formats(); }
    void openingKeepsEverything()
    {
        QFETCH(int, format);
        const auto old = stored(format, QStringLiteral("keeps %1.odo").arg(format));
        const auto opened = Project::open(old, Access::ReadWrite);
        QVERIFY2(opened.has_value(), opened ? "" : opened.error().message().c_str());
        Project &project = **opened;
        QCOMPARE(project.title().value(), std::string("Year 9, autumn – Übung"));
        testbedIsKept(project);
        trialIsKept(project, format);
        analysisIsKept(project, format);
    }

    void theOldFileIsKeptBeside_data() { formats(); }
    void theOldFileIsKeptBeside()
    {
        QFETCH(int, format);
        const auto old = stored(format, QStringLiteral("beside %1.odo").arg(format));
        QVERIFY(Project::open(old, Access::ReadWrite).has_value());
        const auto backup = old.string() + ".bak-" + std::to_string(format);
        QCOMPARE(number(backup, "PRAGMA user_version"), std::int64_t(format));
        QCOMPARE(number(backup, "SELECT COUNT(*) FROM trial"), std::int64_t(2));
        QCOMPARE(number(old, "PRAGMA user_version"), std::int64_t(projectMigrator().newestVersion()));
        // Once brought up it is an ordinary project: no second backup, and it may be read alone.
        QVERIFY(Project::open(old, Access::ReadWrite).has_value());
        QVERIFY(Project::open(old, Access::ReadOnly).has_value());
        QCOMPARE(
            QDir(m_folder.path()).entryList({QStringLiteral("beside %1*").arg(format)}, QDir::Files).size(),
            2);
    }

    void readingBringsItUpToDate_data() { formats(); }
    void readingBringsItUpToDate()
    {
        QFETCH(int, format);
        const auto old = stored(format, QStringLiteral("reads %1.odo").arg(format));
        const auto opened = Project::open(old, Access::ReadOnly);
        QVERIFY2(opened.has_value(), opened ? "" : opened.error().message().c_str());
        QCOMPARE((*opened)->title().value(), std::string("Year 9, autumn – Übung"));
        QCOMPARE((*opened)->setTitle("x").error().code, ErrorCode::ReadOnly);
        QCOMPARE(number(old, "PRAGMA user_version"), std::int64_t(projectMigrator().newestVersion()));
        QCOMPARE(number(old.string() + ".bak-" + std::to_string(format), "PRAGMA user_version"),
                 std::int64_t(format));
    }

    void whereItCannotBeWrittenReadingSaysWhy()
    {
        const auto old = stored(8, QStringLiteral("locked.odo"));
        // Permissions do not bind root; the immutable attribute does, where the file system knows it.
        const QString file = QString::fromStdString(old.string());
        if (QProcess::execute(QStringLiteral("chattr"), {QStringLiteral("+i"), file}) != 0)
            QSKIP("the file system knows no immutable files");
        const auto opened = Project::open(old, Access::ReadOnly);
        QProcess::execute(QStringLiteral("chattr"), {QStringLiteral("-i"), file});
        QVERIFY(!opened.has_value());
        QCOMPARE(opened.error().code, ErrorCode::ReadOnly);
        QCOMPARE(opened.error().message(),
                 std::string("project 'locked.odo': it has the older format 8 and must be updated before "
                             "Odograph can read it, but it cannot be written to; copy it with its videos to "
                             "a folder that you may write to, and open the copy"));
        QCOMPARE(number(old, "PRAGMA user_version"), std::int64_t(8));
        QVERIFY(!std::filesystem::exists(old.string() + ".bak-8"));
    }

    /// Each published step, stopped after its last statement: the file keeps the format and the rows it had.
    void aStepThatFailsLeavesTheFormatBeforeIt_data() { formats(); }
    void aStepThatFailsLeavesTheFormatBeforeIt()
    {
        QFETCH(int, format);
        auto steps = projectMigrations();
        const auto published = steps[std::size_t(format)].apply;
        steps[std::size_t(format)].apply = [published](ProjectConnection &connection) -> Result<void> {
            if (auto done = published(connection); !done)
                return done;
            return fail(ErrorCode::Io, foreignWords("disk"), foreignWords("the disk is full"),
                        foreignWords("make room"));
        };
        const auto old = stored(format, QStringLiteral("fails %1.odo").arg(format));
        {
            const auto connection = ProjectConnection::open(old, DatabaseAccess::ReadWrite);
            const auto migrated = Migrator(steps).migrate(**connection);
            QVERIFY(!migrated.has_value());
            QVERIFY2(migrated.error().message().find("the disk is full; make room") != std::string::npos,
                     migrated.error().message().c_str());
        }
        QCOMPARE(number(old, "PRAGMA user_version"), std::int64_t(format));
        const auto again = Project::open(old, Access::ReadWrite); // its tables are those of its format
        QVERIFY2(again.has_value(), again ? "" : again.error().message().c_str());
        QCOMPARE((*again)->trials().all()->size(), std::size_t(2));
    }

    void aDamagedTaskIsFoundByTheCheck()
    {
        const auto old = stored(3, QStringLiteral("damaged.odo"));
        const auto project = Project::open(old, Access::ReadWrite);
        const auto sound = (*project)->check(false).value().size(); // the dump's recordings are not there
        const auto connection = ProjectConnection::open(old, DatabaseAccess::ReadWrite);
        QVERIFY((*connection)->execute(QStringLiteral("UPDATE task SET template='spiral'")).has_value());
        const auto problems = (*project)->check(false).value();
        QCOMPARE(problems.size(), sound + 1);
        QCOMPARE(problems.front().what.english(),
                 std::string("task 'Figure eight': its stored setting 'spiral' is unknown"));
    }

    /// Sentences as format 15 had them, and the digests that go over them.
    void sentencesBecomeMessages()
    {
        const auto old = stored(15, QStringLiteral("sentences.odo"));
        const auto project = Project::open(old, Access::ReadWrite);
        QVERIFY2(project, project ? "" : project.error().message().c_str());
        const RecordId camera = (*project)->cameras().find("A")->id;
        const auto lens = (*project)->cameras().currentIntrinsics(camera).value();
        QVERIFY(lens->origin == said("workflow.calibrated_from_pictures", {14}));
        QCOMPARE(lens->calibration.modelReason.code(), std::string_view("calibration.foretells_as_well"));
        QCOMPARE(lens->calibration.verdict.code(), std::string_view("base.space"));
        QCOMPARE(lens->calibration.rejected[1].reason.code(), std::string_view("base.colon"));
        const auto registration = (*project)->cameras().currentRegistration(camera).value();
        QCOMPARE(registration->registration.verdict.code(), std::string_view("base.space"));
        QCOMPARE(registration->lastCheck->words.code(), std::string_view("base.space"));
        const RecordId seen = (*project)->trials().find("run 1")->id,
                       imported = (*project)->trials().find("run 2")->id;
        QCOMPARE((*project)->trials().currentImportedTrack(imported, 1).value()->reading.code(),
                 std::string_view("base.semicolon"));
        const auto changes = (*project)->changes().value();
        QVERIFY(changes[0].words == foreignWords("Stern an Lauf 1")); // in the language of the windows then
        QVERIFY(changes[2].words == said("ui.rename_team", {Named::team("Falcon"), Named::team("Heron")}));

        QVERIFY((*project)->analyses().current(seen)->front().proof == AnalysisRecord::Proof::Holds);
        QVERIFY((*project)->analyses().current(imported)->front().proof == AnalysisRecord::Proof::Broken);
        const auto connection = ProjectConnection::open(old, DatabaseAccess::QueryOnly);
        AnalysisDigests digests(**connection);
        QVERIFY(digests.compare(1, allDigestParts)->changed.empty());
        // What had been changed by then is told of as before.
        QVERIFY(digests.compare(2, allDigestParts)->changed == std::vector{DigestPart::Results});
    }

private:
    /// A message whose words may be those of a part of the program that is not here.
    static Message said(const char *code, std::vector<MessageArgument> with = {})
    {
        return {messageText(code), std::move(with)};
    }
    static void testbedIsKept(Project &project)
    {
        const auto camera = project.cameras().find("A");
        QVERIFY(camera.has_value());
        QCOMPARE(camera->deviceUri, std::string("v4l2:/dev/video0"));
        const auto intrinsics = project.cameras().currentIntrinsics(camera->id).value();
        QVERIFY(intrinsics.has_value());
        QCOMPARE(intrinsics->calibration.intrinsics.fyPx, 961.25);
        QCOMPARE(intrinsics->calibration.intrinsics.distortion.size(), std::size_t(5));
        QVERIFY(intrinsics->calibration.rejected.front().reason == said("calibration.no_board_found"));
        const auto registration = project.cameras().currentRegistration(camera->id).value();
        QVERIFY(registration.has_value());
        QCOMPARE(registration->registration.worldFromCamera.translation.y(), -1.5);
        QCOMPARE(registration->registration.poseCovariance(5, 5), 1e-6);
        QCOMPARE(registration->pixels.front().pixel.x(), 101.5);
        QCOMPARE(project.layouts().find("Gym floor")->layout.markers.at(3).pointInWorld.y(), 2.2);
        QCOMPARE(project.robots().find("red")->lengthM.value(), 0.26);
        QCOMPARE(project.teams().find("Heron")->className, std::string("9B"));
    }
    static void trialIsKept(Project &project, int format)
    {
        QCOMPARE(project.trials().all()->size(), std::size_t(2));
        const auto trial = project.trials().find("run 1");
        QVERIFY2(trial.has_value(), trial ? "" : trial.error().message().c_str());
        QCOMPARE(trial->task, std::string("Figure eight"));
        QCOMPARE(trial->notes, std::string("wet floor"));
        QCOMPARE(trial->syncOffsetS, 0.014);
        QCOMPARE(trial->syncRate, format >= 3 ? 0.0002 : 0.0);
        QVERIFY(project.trials().find("run 2")->task.empty());
        const auto recordings = project.trials().recordings(trial->id).value();
        QCOMPARE(recordings.size(), std::size_t(2));
        QCOMPARE(recordings[1].clockRate, format >= 3 ? 0.0002 : 0.0);
        QCOMPARE(recordings[0].frameTimes.back(), Nanoseconds(66666667));
        const auto observations = project.trials().currentObservations(recordings[0].id, 1).value();
        QCOMPARE(observations->observations.at(1).ellipse.centrePx.x(), 104.5);
        QCOMPARE(project.trials().truth(trial->id, 1).value()->positions.at(2).x(), 1.56);
        QCOMPARE(project.trials().overrides(trial->id, 1)->size(),
                 format >= 2 ? std::size_t(1) : std::size_t(0));
        // A task was a name alone.
        const auto task = project.tasks().find("Figure eight");
        QVERIFY2(task.has_value(), task ? "" : task.error().message().c_str());
        QVERIFY(task->task.kind == TaskTemplate::Free && task->task.gates.empty());
        QVERIFY(task->task.path.points.empty() && !task->task.limits.maxSpeedMps);
        QVERIFY(task->task.zones.empty() && !task->archived);
        QVERIFY(project.robots().find("red")->drawingColour == DrawingColour::Automatic);
        QCOMPARE(project.robots().find("red")->referenceM.x(), format >= 13 ? 0.02 : 0.0);
        const auto team = project.teams().find("Heron");
        QVERIFY(team->members.empty() && team->robots.empty());
        QCOMPARE(team->pseudonym, std::string(format >= 10 ? "Team 4" : ""));
        QCOMPARE(trial->starred, format >= 10);
        QCOMPARE(trial->tags.size(), std::size_t(format >= 10 ? 1 : 0));
        QCOMPARE(project.tasks().scoring(task->id)->size(), std::size_t(format >= 10 ? 1 : 0));
        QVERIFY(!project.trials().currentImportedTrack(trial->id, 1)->has_value());
        const auto imported = project.trials().currentImportedTrack(project.trials().find("run 2")->id, 1);
        QVERIFY2(imported, imported ? "" : imported.error().message().c_str());
        QCOMPARE(imported->has_value(), format >= 11);
        QCOMPARE(imported->value_or(ImportedTrack()).samples.size(), std::size_t(format >= 11 ? 3 : 0));
    }
    static void analysisIsKept(Project &project, int format)
    {
        const auto analyses = project.analyses().current(project.trials().find("run 1")->id);
        QVERIFY2(analyses.has_value(), analyses ? "" : analyses.error().message().c_str());
        const AnalysisRecord &analysis = analyses->front();
        QCOMPARE(analysis.task, RecordId(0));
        QCOMPARE(analysis.profile.points.at(1).position.x(), 1.53125);
        QVERIFY(!analysis.profile.points.at(2).valid);
        QCOMPARE(analysis.profile.metrics.front().sigma.value(), 0.01);
        QVERIFY(analysis.profile.spikes.front().reason ==
                said("trajectory.jump_of", {quantity(40, 0, "mm")}));
        QCOMPARE(analysis.options.overrides.size(), format >= 2 ? std::size_t(1) : std::size_t(0));
        QVERIFY(analysis.profile.passages.empty());
        QVERIFY(analysis.ambiguousNames.empty()); // nobody noted it
        QVERIFY((analysis.registrations == std::vector<RecordId>{1, 0}));
        // Of an analysis that is older nobody knows what it was made from. What later formats add changes no
        // digest.
        QCOMPARE(analysis.proof,
                 format >= 13 ? AnalysisRecord::Proof::Holds : AnalysisRecord::Proof::NotKept);
        QCOMPARE(project.analyses().countWithoutDigest().value(), format >= 13 ? 0 : 1);
    }
};

ODOGRAPH_TEST(TestOldProjects, QCoreApplication)
#include "tst_old_projects.moc"
