// SPDX-License-Identifier: GPL-3.0-or-later
// A sound project in which each column in its turn holds what nobody would enter: every way of reading it
// answers, and changes nothing.
#include "tests/attack/attacked.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QFile>
#include <QGuiApplication>
#include <QTemporaryDir>
#include <QTest>
#include <sqlite3.h>

using namespace odo;
using namespace odo::test;

namespace {

struct Column
{
    QByteArray table, name, type;
};

/// Values by the kind of column, as SQL.
QByteArrayList valuesFor(const Column &column)
{
    if (column.type == "TEXT")
        return {"hex(zeroblob(500000))",
                "char(27)||'[2J'||char(8238)||char(10)||'x'",
                "''",
                "'../../../etc/passwd'",
                "x'ff00fe'",
                "-1"};
    if (column.type == "BLOB")
        return {"zeroblob(10000000)", "x'00'", "randomblob(997)", "'a text'"};
    if (column.type == "REAL")
        return {"1e300", "-1e300", "9e999", "'nan'", "0"};
    return {"-1", "4611686018427387904", "0", "'a text'", "1e300"};
}

} // namespace

class TestCraftedProjects : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        const auto file = storeExample(m_folder.path().toStdString());
        QVERIFY(file);
        m_sound = QString::fromStdString(file->string());
    }

    void isAnswered_data()
    {
        QTest::addColumn<QByteArray>("table");
        QTest::addColumn<QByteArray>("sql");
        constexpr int sample = 120;
        int number = 0;
        for (const Column &column : columns()) {
            const QByteArrayList values = valuesFor(column);
            for (const QByteArray &value : values) {
                if (isWanted(++number, sample))
                    QTest::addRow("%d %s.%s=%s", number, column.table.constData(), column.name.constData(),
                                  value.constData())
                        << column.table
                        << "UPDATE \"" + column.table + "\" SET \"" + column.name + "\"=" + value;
            }
        }
        QVERIFY2(number >= 200, qPrintable(QString::number(number)));
    }
    void isAnswered()
    {
        QFETCH(QByteArray, table);
        QFETCH(QByteArray, sql);
        const QString project = crafted(table, sql);
        const QByteArray before = fileHash(project);
        for (const QStringList &call : calls(project)) {
            const AttackedRun run = attacked(call);
            const QString fault = faultOf(run);
            QVERIFY2(fault.isEmpty(), qPrintable(call.join(u' ') + QStringLiteral(": ") + fault));
            QVERIFY2(fileHash(project) == before,
                     qPrintable(call.join(u' ') + QStringLiteral(" changed the project")));
        }
    }

private:
    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    QList<QStringList> calls(const QString &project) const
    {
        const QString trial = QStringLiteral("Trial 1"), out = QStringLiteral("-o");
        QList<QStringList> calls{{QStringLiteral("list"), project},
                                 {QStringLiteral("show"), project, trial},
                                 {QStringLiteral("check"), project},
                                 {QStringLiteral("report"), project, trial, out, path("out.pdf")},
                                 {QStringLiteral("export"), project, trial, out, path("out.csv")}};
        for (const char *mode : {"review", "history", "testbed", "compare"})
            calls.append({QStringLiteral("snapshot"), project, trial, out, path("out.png"),
                          QStringLiteral("--mode"), QString::fromLatin1(mode)});
        return calls;
    }

    std::vector<Column> columns() const
    {
        std::vector<Column> columns;
        const auto add = [](void *into, int, char **values, char **) {
            static_cast<std::vector<Column> *>(into)->push_back(
                {values[0], values[1], QByteArray(values[2]).toUpper()});
            return 0;
        };
        sqlite3 *database = nullptr;
        sqlite3_open(m_sound.toUtf8().constData(), &database);
        sqlite3_exec(database,
                     "SELECT t.name, c.name, c.type FROM sqlite_master t, pragma_table_info(t.name) c WHERE "
                     "t.type='table' AND t.name NOT LIKE 'sqlite%'",
                     add, &columns, nullptr);
        sqlite3_close(database);
        return columns;
    }

    /// A copy with the change, past all constraints and guards, which are there again afterwards.
    QString crafted(const QByteArray &table, const QByteArray &sql) const
    {
        const QString file = path("crafted.odo");
        for (const char *side : {"", "-wal", "-shm"})
            QFile::remove(file + QLatin1String(side));
        QFile::copy(m_sound, file);
        sqlite3 *database = nullptr;
        sqlite3_open(file.toUtf8().constData(), &database);
        QByteArrayList guards, drops;
        const auto note = [](void *into, int, char **values, char **) {
            static_cast<QByteArrayList *>(into)->append(values[0]);
            return 0;
        };
        const QByteArray ofTable = "FROM sqlite_master WHERE type='trigger' AND tbl_name='" + table + "'";
        sqlite3_exec(database, ("SELECT sql " + ofTable).constData(), note, &guards, nullptr);
        sqlite3_exec(database, ("SELECT 'DROP TRIGGER \"'||name||'\"' " + ofTable).constData(), note, &drops,
                     nullptr);
        sqlite3_exec(database, "PRAGMA ignore_check_constraints=ON; PRAGMA foreign_keys=OFF", nullptr,
                     nullptr, nullptr);
        for (const QByteArray &drop : drops)
            sqlite3_exec(database, drop.constData(), nullptr, nullptr, nullptr);
        // Where a column must be unique, only one row is changed.
        if (sqlite3_exec(database, sql.constData(), nullptr, nullptr, nullptr) != SQLITE_OK)
            sqlite3_exec(database,
                         (sql + " WHERE rowid=(SELECT min(rowid) FROM \"" + table + "\")").constData(),
                         nullptr, nullptr, nullptr);
        for (const QByteArray &guard : guards)
            sqlite3_exec(database, guard.constData(), nullptr, nullptr, nullptr);
        sqlite3_exec(database, "PRAGMA wal_checkpoint(TRUNCATE)", nullptr, nullptr, nullptr);
        sqlite3_close(database);
        return file;
    }

    QTemporaryDir m_folder;
    QString m_sound;
};

ODOGRAPH_TEST(TestCraftedProjects, QGuiApplication)
#include "tst_crafted_projects.moc"
