// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/connection.h"
#include "core/project/internal/opening_check.h"
#include "core/project/project.h"
#include "core/project/project_media.h"
#include "tests/project/sample_records.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <sqlite3.h>

using namespace odo;
using Access = Project::Access;

/// A project may come from anyone: opening it runs nothing of it, takes no endless time, and touches no other
/// file.
class TestHostileProjects : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = path("a.odo");
        const auto project = Project::create(m_file, "title");
        RecordSource source(5);
        QVERIFY(project && fill(**project, source));
    }

    void whatIsNotOursInTheSchemaIsRefused_data()
    {
        QTest::addColumn<QByteArray>("sql");
        QTest::newRow("a trigger") << QByteArray(
            "CREATE TRIGGER evil AFTER INSERT ON camera BEGIN DELETE FROM trial; END");
        QTest::newRow("a view") << QByteArray("CREATE VIEW evil AS SELECT 1");
        QTest::newRow("a view in place of a table")
            << QByteArray("DROP TABLE trial_tag; CREATE VIEW trial_tag AS WITH RECURSIVE n(x) AS (SELECT 1 "
                          "UNION ALL SELECT x + 1 FROM n) "
                          "SELECT x AS trial_id, x AS tag FROM n");
        QTest::newRow("a table") << QByteArray("CREATE TABLE evil (x)");
        QTest::newRow("a virtual table") << QByteArray("CREATE VIRTUAL TABLE evil USING rtree(a, b, c)");
        QTest::newRow("an index") << QByteArray("CREATE INDEX evil ON camera(device_uri)");
        QTest::newRow("an index of a formula") << QByteArray("CREATE INDEX evil ON camera(abs(id))");
        QTest::newRow("a trigger of ours is missing")
            << QByteArray("DROP TRIGGER observation_chunk_kept_on_delete");
        // Looking through the rows evaluates checks: this one for longer than a test may take.
        QTest::newRow("an endless check")
            << QByteArray("CREATE TABLE evil (x); WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 "
                          "FROM n LIMIT 5000) INSERT INTO evil SELECT x FROM n;"
                          "PRAGMA writable_schema=ON; UPDATE sqlite_master SET sql='CREATE TABLE evil (x "
                          "CHECK (length(replace(hex(zeroblob(30000000 + x)), ''0'', "
                          "''00'')) > x))' WHERE name='evil'");
    }
    void whatIsNotOursInTheSchemaIsRefused()
    {
        QFETCH(QByteArray, sql);
        run(sql);
        for (const Access access : {Access::ReadOnly, Access::ReadWrite}) {
            const auto opened = Project::open(m_file, access);
            QVERIFY(!opened);
            QCOMPARE(
                opened.error().message(),
                std::string(
                    "project 'a.odo': its tables are not those of a project; restore it from a backup copy"));
        }
    }

    void whatSqliteOffersToASchemaIsOff()
    {
        const auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadWrite);
        QVERIFY(connection);
        QCOMPARE(*(*connection)->number(QStringLiteral("PRAGMA trusted_schema")), 0);
        QCOMPARE(*(*connection)->number(QStringLiteral("PRAGMA cell_size_check")), 1);
        QCOMPARE(*(*connection)->number(QStringLiteral("PRAGMA mmap_size")), 0);
        for (const int option : {SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_VIEW,
                                 SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, SQLITE_DBCONFIG_DQS_DDL}) {
            int isOn = 1;
            sqlite3_db_config((*connection)->handle(), option, -1, &isOn);
            QCOMPARE(isOn, 0);
        }
        // Defensive: the schema cannot be rewritten behind SQLite's back.
        QVERIFY((*connection)->execute(QStringLiteral("PRAGMA writable_schema=ON")));
        QVERIFY(
            !(*connection)->execute(QStringLiteral("UPDATE sqlite_master SET sql='' WHERE name='camera'")));
    }

    void whatIsLargerThanOursIsRefused()
    {
        const auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadWrite);
        const QString many = QStringLiteral("0+").repeated(200) + QStringLiteral("0");
        for (const QString &sql :
             {QStringLiteral("SELECT ") + many,
              QStringLiteral("SELECT ") + QStringLiteral(" ").repeated(200'000) + QStringLiteral("1"),
              QStringLiteral("SELECT max(") + QStringLiteral("0,").repeated(100) + QStringLiteral("0)"),
              QStringLiteral("SELECT 1") + QStringLiteral(" UNION ALL SELECT 1").repeated(20)})
            QVERIFY2(!(*connection)->number(sql), qPrintable(sql.left(40)));
        QVERIFY((*connection)->number(QStringLiteral("SELECT 0+0")));
    }

    void whatDoesNotEndIsStopped()
    {
        const QString endless = QStringLiteral(
            "WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT max(x) FROM n");
        const auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadOnly);
        {
            const StepLimit limit(**connection, 1'000'000);
            const auto stopped = (*connection)->number(endless);
            QVERIFY(!stopped);
            QCOMPARE(stopped.error().message(),
                     std::string("project 'a.odo': the file is damaged; restore it from a backup copy"));
            QVERIFY(!(*connection)->number(endless)); // what was left is used up
        }
        QCOMPARE(*(*connection)
                      ->number(QStringLiteral("WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM "
                                              "n LIMIT 1000000) SELECT max(x) FROM n")),
                 1'000'000); // no limit is left behind
    }

    /// SQLite removes the file that a journal names at its end, after rolling back.
    void aJournalThatNamesAnotherFileIsRefused()
    {
        const QByteArray whole = content(m_file);
        const std::filesystem::path own = path("own.txt");
        store(own, "somebody's own");
        store(path("a.odo-journal"), journalNaming(own.string()));
        for (const Access access : {Access::ReadOnly, Access::ReadWrite}) {
            const auto opened = Project::open(m_file, access);
            QVERIFY(!opened);
            QCOMPARE(opened.error().message(), "project '" + m_file.string() +
                                                   "': the journal beside it names another file; copy it "
                                                   "again from its source, or restore a backup copy");
        }
        QCOMPARE(content(own), QByteArray("somebody's own"));
        QVERIFY(content(m_file) == whole);
        store(path("a.odo-journal"), QByteArray(600, '\0')); // what a crash may have left
        QVERIFY(Project::open(m_file, Access::ReadWrite));
    }

    /// SQLite would take what a link leads to for a log of its own, and empty it.
    void aLogThatIsALinkIsRefused()
    {
        const std::filesystem::path own = path("own.txt");
        for (const char *side : {"a.odo-wal", "a.odo-shm", "a.odo-journal"}) {
            store(own, "somebody's own");
            std::filesystem::create_symlink(own, path(side));
            std::filesystem::create_symlink(m_file, path("way"));
            for (const auto &way : {m_file, path("way")}) {
                const auto opened = Project::open(way, Access::ReadWrite);
                QVERIFY2(!opened, side);
                QCOMPARE(opened.error().why.english(),
                         std::string("the journal beside it names another file"));
            }
            QCOMPARE(content(own), QByteArray("somebody's own"));
            std::filesystem::remove(path(side));
            std::filesystem::remove(path("way"));
        }
        QVERIFY(Project::open(m_file, Access::ReadWrite));
    }

    void onlyWhatLiesInTheMediaFolderIsItsOwn()
    {
        const std::filesystem::path media = path("a.media"), elsewhere = path("elsewhere");
        std::filesystem::create_directories(media / "calibration");
        std::filesystem::create_directories(elsewhere);
        store(media / "in.mkv", "x");
        store(elsewhere / "out.mkv", "x");
        std::filesystem::create_symlink(elsewhere, media / "link");
        std::filesystem::create_symlink(elsewhere / "out.mkv", media / "out.mkv");
        for (const auto &own : {media / "in.mkv", media / "gone.mkv", media / "calibration" / ".." / "in.mkv",
                                media / "calibration" / "new" / "a.png"})
            QVERIFY2(isOwnMedia(own, media), own.c_str());
        for (const auto &other :
             {elsewhere / "out.mkv", media / ".." / "elsewhere" / "out.mkv", media / "link" / "out.mkv",
              media / "link" / "gone.mkv", media / "out.mkv", media, media / ".", path("a.media.mkv"),
              std::filesystem::path("/etc/passwd")})
            QVERIFY2(!isOwnMedia(other, media), other.c_str());
        const std::filesystem::path linked = path("linked.media");
        std::filesystem::create_symlink(media, linked); // a media folder on another disk
        QVERIFY(isOwnMedia(linked / "in.mkv", linked));
    }

private:
    std::filesystem::path path(const char *name) const
    {
        return std::filesystem::path(m_folder->path().toStdString()) / name;
    }

    /// What another program would write into the file.
    void run(const QByteArray &sql)
    {
        sqlite3 *database = nullptr;
        QCOMPARE(sqlite3_open(m_file.c_str(), &database), SQLITE_OK);
        sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
        char *problem = nullptr;
        QVERIFY2(sqlite3_exec(database, "PRAGMA journal_mode=DELETE", nullptr, nullptr, nullptr) == SQLITE_OK,
                 "journal");
        QVERIFY2(sqlite3_exec(database, sql.constData(), nullptr, nullptr, &problem) == SQLITE_OK, problem);
        sqlite3_close(database);
    }

    /// A journal's head without pages, and at its end the name: its place, length, sum and the mark.
    static QByteArray journalNaming(const std::string &name)
    {
        const QByteArray mark("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8);
        const auto number = [](std::uint32_t value) {
            QByteArray bytes;
            for (const int shift : {24, 16, 8, 0})
                bytes.append(static_cast<char>(value >> shift & 0xff));
            return bytes;
        };
        std::uint32_t sum = 0;
        for (const char c : name)
            sum += static_cast<std::uint32_t>(static_cast<int>(c));
        const QByteArray head = mark + number(0) + number(0) + number(1) + number(512) + number(4096);
        return head.leftJustified(512, '\0') + number(0x40000000 / 4096 + 1) +
               QByteArray::fromStdString(name) + number(static_cast<std::uint32_t>(name.size())) +
               number(sum) + mark;
    }

    static QByteArray content(const std::filesystem::path &file)
    {
        QFile input(QString::fromStdString(file.string()));
        return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray("it cannot be read");
    }
    static void store(const std::filesystem::path &file, const QByteArray &bytes)
    {
        QFile output(QString::fromStdString(file.string()));
        if (!output.open(QIODevice::WriteOnly) || output.write(bytes) != bytes.size())
            qFatal("cannot write the test's file");
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_file;
};

ODOGRAPH_TEST(TestHostileProjects, QCoreApplication)
#include "tst_hostile_projects.moc"
