// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/schema.h"
#include "core/project/project.h"
#include "core/project/project_locks.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "tests/project/sample_records.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <future>

using namespace odo;
using Access = Project::Access;

class TestProjectFile : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = folder() / "Прогон #1 100%?.odo"; // what an address of SQLite would trip over
        auto project = Project::create(m_file, "title");
        QVERIFY2(project.has_value(), project ? "" : project.error().message().c_str());
        m_filled = *fill(**project, m_source);
    }

    void aClosedProjectIsASingleFile()
    {
        QCOMPARE(files(), QStringList{QString::fromUtf8("Прогон #1 100%?.odo")});
    }

    void theHeaderTellsWhatItIs()
    {
        const QByteArray bytes = content(m_file);
        QVERIFY(bytes.startsWith("SQLite format 3"));
        QCOMPARE(bytes.mid(68, 4), QByteArray("Odog"));
        QCOMPARE(bytes.mid(60, 4), QByteArray("\0\0\0\25", 4));
    }

    void ofTwoThatWriteOneWaitsForTheOther()
    {
        const auto project = Project::open(m_file, Access::ReadWrite);
        const std::filesystem::path otherwise = folder() / "." / m_file.filename();
        std::future<bool> other;
        const auto isKeptWaiting = [&] {
            other = std::async(std::launch::async,
                               [turn = WriteTurn::of(otherwise)] { return HeldTurn(*turn).isHeld(); });
            return other.wait_for(std::chrono::milliseconds(50)) == std::future_status::timeout;
        };
        QVERIFY((*project)->inTransaction([&]() -> Result<void> {
            if (auto done = (*project)->setTitle("inside"); !done)
                return done;
            return isKeptWaiting()
                       ? Result<void>()
                       : fail(ErrorCode::Internal, foreignWords("the turn"), foreignWords("it is free"), {});
        }));
        QVERIFY(other.get());
        QVERIFY(!(*project)->inTransaction([&]() -> Result<void> {
            return isKeptWaiting() ? cancelled(foreignWords("the change")) : Result<void>();
        }));
        QVERIFY(other.get());
    }

    void isOpenedAgainForAnotherThread()
    {
        constexpr int changes = 50;
        const auto project = Project::open(m_file, Access::ReadWrite);
        const std::size_t problems = (*project)->check(false)->size(); // its recordings are not there
        auto other = std::async(std::launch::async, [this]() -> Result<void> {
            const auto again = Project::openAgain(m_file, Project::Access::ReadWrite);
            if (!again)
                return tl::unexpected(again.error());
            for (int i = 0; i < changes; ++i) {
                if (const auto team = (*again)->teams().add({0, "Team " + std::to_string(i), "9A"}); !team)
                    return tl::unexpected(team.error());
            }
            return {};
        });
        const std::size_t before = (*project)->robots().all()->size();
        for (int i = 0; i < changes; ++i) {
            RobotRecord robot;
            robot.name = "Robot " + std::to_string(i);
            QVERIFY((*project)->robots().add(robot));
        }
        QVERIFY(other.get());
        QCOMPARE((*project)->robots().all()->size(), before + changes);
        QVERIFY((*project)->teams().find("Team 49"));
        QCOMPARE((*project)->check(false)->size(), problems);
    }

    void creatingNeverReplacesNorLeavesAnything()
    {
        const QByteArray before = content(m_file);
        QCOMPARE(Project::create(m_file, "x").error().code, ErrorCode::AlreadyExists);
        QCOMPARE(content(m_file), before);
        const auto nowhere = Project::create("/no/such/folder/a.odo", "x");
        QCOMPARE(nowhere.error().code, ErrorCode::NotFound);
        QCOMPARE(nowhere.error().message(),
                 std::string("project '/no/such/folder/a.odo': folder '/no/such/folder' does not exist; "
                             "create the folder first, or choose another one"));
        QVERIFY(!Project::create(m_file / "below a file.odo", "x").has_value());
        QCOMPARE(Project::create("/proc/a.odo", "x").error().code, ErrorCode::ReadOnly);
        QVERIFY(!Project::create(folder() / std::string(300, 'x'), "x").has_value());
        QCOMPARE(files().size(), 1);
    }

    void creatingTakesNoPlaceOfAnotherProject()
    {
        const QString media =
            m_folder->filePath(QString::fromStdString(m_file.stem().string()) + QStringLiteral(".media"));
        QVERIFY(QDir().mkpath(media));
        for (const char *suffix : {"-wal", "-shm", "-journal", ".lock", ".bak-1", ".damaged"}) {
            const auto refused = Project::create(m_file.string() + suffix, "x");
            QCOMPARE(refused.error().code, ErrorCode::WrongCall);
            QCOMPARE(refused.error().message(),
                     "project '" + m_file.string() + suffix +
                         "': it is the log, the lock or a backup of a project; choose another name");
        }
        const auto inside = Project::create(media.toStdString() + "/inner.odo", "x");
        QCOMPARE(inside.error().code, ErrorCode::WrongCall);
        QCOMPARE(inside.error().why.english(),
                 "it is in the media folder of project '" + m_file.filename().string() + "'");
        QVERIFY(QDir(media).isEmpty());
        QCOMPARE(files().size(), 1);
    }

    void readingChangesNoByteAndLeavesNoFile()
    {
        const QByteArray before = content(m_file);
        {
            const auto project = Project::open(m_file, Access::ReadOnly);
            QVERIFY2(project.has_value(), project ? "" : project.error().message().c_str());
            QCOMPARE((*project)->trials().all()->size(), std::size_t(1));
            QCOMPARE((*project)->analyses().current(m_filled.trial)->front().profile.samples.size(),
                     std::size_t(50));
            QVERIFY((*project)->check(false).has_value());
            QCOMPARE((*project)->cameras().add({0, "C", ""}).error().code, ErrorCode::ReadOnly);
            QCOMPARE((*project)->setTitle("x").error().code, ErrorCode::ReadOnly);
        }
        QCOMPARE(files().size(), 1);
        QVERIFY(content(m_file) == before);
    }

    void aFileThatCannotBeWrittenIsReadable()
    {
        // Permissions do not bind root; the immutable attribute does, where the file system knows it.
        const QString file = QString::fromStdString(m_file.string());
        if (QProcess::execute(QStringLiteral("chattr"), {QStringLiteral("+i"), file}) != 0)
            QSKIP("the file system knows no immutable files");
        const auto writing = Project::open(m_file, Access::ReadWrite);
        const bool readable = Project::open(m_file, Access::ReadOnly).has_value();
        QProcess::execute(QStringLiteral("chattr"), {QStringLiteral("-i"), file});
        QVERIFY(!writing.has_value());
        QCOMPARE(writing.error().code, ErrorCode::ReadOnly);
        QVERIFY(readable);
    }

    void saysWhyAFileIsNoProject_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("why");
        QTest::newRow("empty") << QByteArray() << QStringLiteral("the file is empty");
        QTest::newRow("text") << QByteArray("hello") << QStringLiteral("it is not a project file");
        QTest::newRow("cut header") << QByteArray("SQLite format 3\0abc", 19)
                                    << QStringLiteral("the file is incomplete");
    }
    void saysWhyAFileIsNoProject()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, why);
        expectRefusal(content, ErrorCode::InvalidInput, why);
    }
    void refusesForeignNewerAndTruncatedFiles()
    {
        const QByteArray whole = content(m_file);
        QByteArray foreign = whole, newer = whole;
        foreign.replace(68, 4, "\0\0\0\0", 4);
        newer.replace(60, 4, "\0\0\0\x16", 4);
        expectRefusal(foreign, ErrorCode::InvalidInput,
                      QStringLiteral("it is a database of another program"));
        expectRefusal(newer, ErrorCode::NewerFormat,
                      QStringLiteral("it was written by a newer Odograph (format 22"));
        for (int part : {1, 2, 3})
            expectRefusal(whole.left(whole.size() * part / 4), ErrorCode::InvalidInput,
                          QStringLiteral("incomplete: it has"));
        QCOMPARE(Project::open(folder(), Access::ReadOnly).error().code, ErrorCode::InvalidInput);
        QCOMPARE(Project::open(folder() / "no.odo", Access::ReadWrite).error().code, ErrorCode::NotFound);
    }
    void refusesASchemaThatIsNotOurs()
    {
        {
            const auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadWrite);
            QVERIFY((*connection)
                        ->execute(QStringLiteral(
                            "CREATE TRIGGER evil AFTER INSERT ON camera BEGIN DELETE FROM trial; END"))
                        .has_value());
            (*connection)->checkpoint(ProjectConnection::Checkpoint::Emptying);
        }
        expectRefusal(content(m_file), ErrorCode::InvalidInput,
                      QStringLiteral("its tables are not those of a project"));
    }

    void survivesFlippedBits()
    {
        const QByteArray whole = content(m_file);
        const std::filesystem::path flipped = folder() / "flipped.odo";
        std::mt19937 random(5);
        int refused = 0;
        for (int i = 0; i < 300; ++i) {
            QByteArray bytes = whole;
            // Half of the flips go to the header; pages are padded with zeros, of which none is worth a flip.
            const std::size_t range = i % 2 == 0 ? 100 : std::size_t(bytes.size());
            qsizetype at = 0;
            do {
                at = qsizetype(random() % range);
            } while (bytes[at] == 0 && range > 100);
            bytes[at] = char(bytes[at] ^ (1 << random() % 8));
            store(flipped, bytes);
            const auto project = Project::open(flipped, i % 4 == 0 ? Access::ReadWrite : Access::ReadOnly);
            if (!project) {
                ++refused;
                QVERIFY(project.error().message().size() > 20);
                QVERIFY(content(flipped) == bytes); // what cannot be read is left as it is
            } else {
                readEverything(**project);
            }
        }
        QVERIFY2(refused > 50, qPrintable(QString::number(refused)));
        std::filesystem::remove(flipped);
    }

    void transactionsRollBackUnlessTheySucceed()
    {
        const auto project = Project::open(m_file, Access::ReadWrite);
        const auto failed = (*project)->inTransaction([&]() -> Result<void> {
            if (!(*project)->cameras().add({0, "C", ""}))
                return fail(ErrorCode::Internal, foreignWords("test"), foreignWords("no camera"), {});
            return fail(ErrorCode::Cancelled, foreignWords("test"), foreignWords("stopped"), {});
        });
        QCOMPARE(failed.error().code, ErrorCode::Cancelled);
        QCOMPARE((*project)->cameras().find("C").error().code, ErrorCode::NotFound);
        QVERIFY((*project)->inTransaction([&]() -> Result<void> {
            const auto added = (*project)->cameras().add({0, "C", ""});
            return added ? Result<void>() : tl::unexpected(added.error());
        }));
        QVERIFY((*project)->cameras().find("C").has_value());
    }

    void observationsAreNeverChangedNorDeleted()
    {
        const auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadWrite);
        for (const char *sql : {"DELETE FROM observation_series", "DELETE FROM observation_chunk",
                                "UPDATE observation_series SET algorithm='x'",
                                "UPDATE observation_chunk SET observations=x'00'"})
            QVERIFY2(!(*connection)->execute(QString::fromLatin1(sql)).has_value(), sql);
        QCOMPARE(*(*connection)->number(QStringLiteral("SELECT COUNT(*) FROM observation_series")), 2);
    }

    void savesACopy()
    {
        const std::filesystem::path copy = folder() / "Kopie.odo";
        {
            const auto project = Project::open(m_file, Access::ReadWrite);
            QVERIFY((*project)->setTitle("just changed"));
            QVERIFY((*project)->saveCopy(copy).has_value());
            QCOMPARE((*project)->saveCopy(copy).error().code, ErrorCode::AlreadyExists);
        }
        {
            const auto opened = Project::open(copy, Access::ReadOnly);
            QVERIFY2(opened.has_value(), opened ? "" : opened.error().message().c_str());
            QCOMPARE((*opened)->title().value(), std::string("just changed"));
            QCOMPARE((*opened)->trials().all()->size(), std::size_t(1));
        }
        QCOMPARE(files().size(), 2);
    }

    void recordingsAreFoundBesideTheProject()
    {
        const auto project = Project::open(m_file, Access::ReadWrite);
        QCOMPARE((*project)->mediaFolder(), folder() / "Прогон #1 100%?.media");
        const RecordId camera = (*project)->cameras().find("A")->id;
        RecordingRecord inside = m_source.recording(camera, 1), outside = inside;
        inside.path = (folder() / "x.media" / "a.mkv").string();
        outside.path = "/elsewhere/b.mkv";
        TrialRecord trial;
        trial.name = "paths";
        const auto stored = (*project)->trials().add(trial, {inside, outside});
        const auto recordings = (*project)->trials().recordings(stored->id);
        QCOMPARE(recordings->at(0).path, std::string("x.media/a.mkv"));
        QCOMPARE((*project)->resolve(recordings->at(0)), folder() / "x.media" / "a.mkv");
        QCOMPARE(recordings->at(1).path, std::string("/elsewhere/b.mkv"));
        QCOMPARE((*project)->resolve(recordings->at(1)), std::filesystem::path("/elsewhere/b.mkv"));
        RecordingRecord hostile = inside;
        hostile.path = "../../etc/passwd";
        QCOMPARE((*project)->resolve(hostile), folder() / "passwd");
        trial.name = "hostile";
        QCOMPARE((*project)->trials().add(trial, {hostile}).error().code, ErrorCode::InvalidInput);
        QCOMPARE((*project)->trials().find("hostile").error().code, ErrorCode::NotFound);
    }

    void checksRecordings()
    {
        const auto project = Project::open(m_file, Access::ReadWrite);
        const std::filesystem::path video = folder() / "clip.mkv";
        store(video, "abc");
        RecordingRecord good = m_source.recording((*project)->cameras().find("A")->id, 3);
        good.path = "clip.mkv";
        good.bytes = 3;
        good.sha256 = *fileSha256(video, {});
        QCOMPARE(good.sha256,
                 std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
        TrialRecord trial;
        trial.name = "checked";
        QVERIFY((*project)->trials().add(trial, {good}).has_value());
        QCOMPARE(problemsAt(**project, video, true), QStringList());
        store(video, "abd");
        QCOMPARE(problemsAt(**project, video, false), QStringList());
        QVERIFY(problemsAt(**project, video, true).value(0).contains(QStringLiteral("has changed")));
        store(video, "abcd");
        QVERIFY(
            problemsAt(**project, video, false).value(0).contains(QStringLiteral("4 bytes instead of 3")));
        std::filesystem::remove(video);
        QVERIFY(problemsAt(**project, video, false).value(0).contains(QStringLiteral("is missing")));
        std::filesystem::create_directory(video); // what is there is told
        QVERIFY(problemsAt(**project, video, false)
                    .value(0)
                    .contains(QStringLiteral("it is a folder or a device, not a file")));
        std::filesystem::remove(video);
        std::filesystem::create_symlink(video.filename(), video);
        QVERIFY(problemsAt(**project, video, false)
                    .value(0)
                    .contains(QStringLiteral("it cannot be read (Too many levels of symbolic links)")));
    }

    void checkFindsObservationsThatDoNotFit()
    {
        const auto project = Project::open(m_file, Access::ReadWrite);
        ObservationSeries series{
            m_filled.recordings[0], m_filled.robot, "colour 2", {m_source.observation(50)}};
        QVERIFY((*project)->trials().addObservations(series).has_value());
        const auto problems = problemsAt(**project, "trial 'run 1'", false);
        QCOMPARE(problems.size(), 2); // and they are not those that were analysed
        QVERIFY(problems[1].contains(
            QStringLiteral("view 'A' has 50 frames, but the observations of 'red' (1)")));
    }

    void aSecondProcessSeesWhatTheFirstHasSaved()
    {
        const auto writer = Project::open(m_file, Access::ReadWrite);
        QVERIFY((*writer)->cameras().add({0, "C", ""}).has_value());
        const auto reader = Project::open(m_file, Access::ReadOnly);
        QVERIFY2(reader.has_value(), reader ? "" : reader.error().message().c_str());
        QVERIFY((*reader)->cameras().find("C").has_value());
    }

private:
    std::filesystem::path folder() const { return std::filesystem::path(m_folder->path().toStdString()); }
    QStringList files() const { return QDir(m_folder->path()).entryList(QDir::Files); }

    static QByteArray content(const std::filesystem::path &file)
    {
        QFile input(QString::fromStdString(file.string()));
        return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray();
    }
    static void store(const std::filesystem::path &file, const QByteArray &bytes)
    {
        QFile output(QString::fromStdString(file.string()));
        if (!output.open(QIODevice::WriteOnly) || output.write(bytes) != bytes.size())
            qFatal("cannot write the test's file");
    }
    void expectRefusal(const QByteArray &bytes, ErrorCode code, const QString &why)
    {
        const std::filesystem::path bad = folder() / "bad.odo";
        store(bad, bytes);
        const qsizetype count = files().size();
        for (const Access access : {Access::ReadOnly, Access::ReadWrite}) {
            const auto project = Project::open(bad, access);
            QVERIFY(!project.has_value());
            QCOMPARE(project.error().code, code);
            QVERIFY2(project.error().message().find(why.toStdString()) != std::string::npos,
                     project.error().message().c_str());
            QVERIFY(content(bad) == bytes);
            QCOMPARE(files().size(), count);
        }
    }
    static QStringList problemsAt(const Project &project, const std::filesystem::path &where, bool withHashes)
    {
        QStringList found;
        const auto problems = project.check(withHashes);
        for (const ProjectProblem &problem : problems.value()) {
            if (problem.where.english() == where.string())
                found += QString::fromStdString(problem.what.english());
        }
        return found;
    }
    void readEverything(Project &project)
    {
        static_cast<void>(project.check(false));
        static_cast<void>(project.layouts().all());
        static_cast<void>(project.teams().all());
        static_cast<void>(project.tasks().all());
        const auto cameras = project.cameras().all();
        for (const CameraRecord &camera : cameras.value_or(std::vector<CameraRecord>())) {
            static_cast<void>(project.cameras().currentIntrinsics(camera.id));
            static_cast<void>(project.cameras().currentRegistration(camera.id));
        }
        static_cast<void>(project.trials().truth(m_filled.trial, m_filled.robot));
        static_cast<void>(project.analyses().current(m_filled.trial));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_file;
    FilledProject m_filled;
    RecordSource m_source{21};
};

ODOGRAPH_TEST(TestProjectFile, QCoreApplication)
#include "tst_project_file.moc"
