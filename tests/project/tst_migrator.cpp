// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/connection.h"
#include "core/project/internal/opening_check.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

std::vector<Migration> twoSteps()
{
    return {sqlMigration(foreignWords("first"),
                         {"CREATE TABLE robot (name TEXT)", "INSERT INTO robot VALUES ('red')"}),
            sqlMigration(foreignWords("colours"), {"ALTER TABLE robot ADD COLUMN colour TEXT"})};
}

} // namespace

class TestMigrator : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = std::filesystem::path(m_folder->path().toStdString()) / "Übung.odo";
        auto old = open();
        const Migrator first({twoSteps()[0]});
        QVERIFY(first.create(*old, 1).has_value());
    }

    void migratesAfterABackup()
    {
        const auto connection = open();
        const Migrator migrator(twoSteps());
        QVERIFY(migrator.migrate(*connection).has_value());
        QCOMPARE(*migrator.knownVersion(*connection), 2);
        QCOMPARE(*connection->number(QStringLiteral("SELECT COUNT(*) FROM robot WHERE colour IS NULL")), 1);
        const auto backup = ProjectConnection::open(backupFile(), DatabaseAccess::Immutable);
        QVERIFY2(backup.has_value(), backup ? "" : backup.error().message().c_str());
        QCOMPARE(*(*backup)->number(QStringLiteral("PRAGMA user_version")), 1);
        QCOMPARE(*(*backup)->number(QStringLiteral("SELECT COUNT(*) FROM robot")), 1);
        QCOMPARE(*(*backup)->number(QStringLiteral("SELECT COUNT(*) FROM pragma_table_info('robot')")), 1);
    }
    void theNewestVersionIsLeftAlone()
    {
        const auto connection = open();
        QVERIFY(Migrator({twoSteps()[0]}).migrate(*connection).has_value());
        QVERIFY(!std::filesystem::exists(backupFile()));
    }
    void aFailingStepIsRolledBackWhole()
    {
        auto steps = twoSteps();
        steps.push_back(
            sqlMigration(foreignWords("breaks"), {"INSERT INTO robot VALUES ('blue', 'b')",
                                                  "DROP TABLE robot", "INSERT INTO nowhere VALUES (1)"}));
        const auto connection = open();
        const auto migrated = Migrator(steps).migrate(*connection);
        QVERIFY(!migrated.has_value());
        QVERIFY2(migrated.error().message().find("could not be converted to format 3 (breaks)") !=
                     std::string::npos,
                 migrated.error().message().c_str());
        QCOMPARE(*connection->number(QStringLiteral("PRAGMA user_version")), 2);
        QCOMPARE(*connection->number(QStringLiteral("SELECT COUNT(*) FROM robot")), 1);
        QVERIFY(std::filesystem::exists(backupFile()));
    }
    void anOlderBackupIsKept()
    {
        const auto connection = open();
        QVERIFY(copyDatabase(*connection, backupFile()).has_value());
        QVERIFY(Migrator(twoSteps()).migrate(*connection).has_value());
        QVERIFY(std::filesystem::exists(backupFile()));
        QVERIFY(std::filesystem::exists(backupFile().string() + ".2"));
    }
    void aNewerVersionIsRefused()
    {
        const auto connection = open();
        QVERIFY(connection->execute(QStringLiteral("PRAGMA user_version=9")).has_value());
        const auto migrated = Migrator(twoSteps()).migrate(*connection);
        QCOMPARE(migrated.error().code, ErrorCode::NewerFormat);
        QCOMPARE(migrated.error().message(),
                 std::string("project 'Übung.odo': it was written by a newer Odograph (format 9, this one "
                             "knows formats up to 2); open it with that version, or update this one"));
    }
    void copiesNeverReplaceAFile()
    {
        const auto connection = open();
        QCOMPARE(copyDatabase(*connection, m_file).error().code, ErrorCode::AlreadyExists);
        QCOMPARE(copyDatabase(*connection, "/no/such/folder/a.odo").error().code, ErrorCode::NotFound);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).size(), 1);
    }
    void nestedTransactionsRollBackAlone()
    {
        const auto connection = open();
        const auto count = QStringLiteral("SELECT COUNT(*) FROM robot");
        const auto insert = QStringLiteral("INSERT INTO robot VALUES ('x')");
        const auto outer = transact(*connection, [&]() -> Result<void> {
            const auto inner = transact(*connection, [&]() -> Result<void> {
                if (auto done = connection->execute(insert); !done)
                    return done;
                return fail(ErrorCode::InvalidInput, foreignWords("a"), foreignWords("b"), foreignWords("c"));
            });
            return inner ? Result<void>() : connection->execute(insert);
        });
        QVERIFY(outer.has_value());
        QCOMPARE(*connection->number(count), 2);
        try {
            static_cast<void>(transact(*connection, [&]() -> Result<void> {
                static_cast<void>(connection->execute(insert));
                throw std::bad_alloc();
            }));
        } catch (const std::bad_alloc &) {
        }
        QCOMPARE(*connection->number(count), 2);
        QVERIFY(transact(*connection, [&] { return connection->execute(insert); }).has_value());
        QCOMPARE(*connection->number(count), 3);
    }

private:
    std::unique_ptr<ProjectConnection> open() const
    {
        auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadWrite);
        if (!connection)
            qFatal("%s", connection.error().message().c_str());
        return std::move(*connection);
    }
    std::filesystem::path backupFile() const { return m_file.string() + ".bak-1"; }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_file;
};

ODOGRAPH_TEST(TestMigrator, QCoreApplication)
#include "tst_migrator.moc"
