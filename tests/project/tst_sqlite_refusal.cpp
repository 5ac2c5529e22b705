// SPDX-License-Identifier: GPL-3.0-or-later
// Why SQLite could not write, where the system has told it.
#include "core/project/internal/statement.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <cerrno>
#include <csignal>
#include <sqlite3.h>
#include <sys/resource.h>

using namespace odo;

class TestSqliteRefusal : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void reasonsOfTheSystem_data()
    {
        QTest::addColumn<int>("code");
        QTest::addColumn<int>("systemError");
        QTest::addColumn<QString>("why");
        const QString full = QStringLiteral("the disk is full, the change was not saved");
        QTest::newRow("full") << SQLITE_FULL << ENOSPC << full;
        QTest::newRow("no space") << SQLITE_IOERR_WRITE << ENOSPC << full;
        QTest::newRow("quota") << SQLITE_IOERR_WRITE << EDQUOT << full;
        QTest::newRow("file limit") << SQLITE_IOERR_SHMSIZE << EFBIG << full;
        QTest::newRow("read-only") << SQLITE_IOERR_WRITE << EROFS
                                   << QStringLiteral(
                                          "the disk has become read-only, the change was not saved");
        QTest::newRow("broken") << SQLITE_IOERR_WRITE << EIO
                                << QStringLiteral("the disk reported an error, the change was not saved");
        QTest::newRow("not known") << SQLITE_IOERR_WRITE << 0
                                   << QStringLiteral("the disk reported an error, the change was not saved");
    }
    void reasonsOfTheSystem()
    {
        QFETCH(int, code);
        QFETCH(int, systemError);
        QFETCH(QString, why);
        QCOMPARE(QString::fromStdString(sqliteRefusal(code, systemError).why.english()), why);
    }

    /// As `ulimit -f` limits them; docs/faults.md promises what a full disk gives.
    void aFileThatMayNotGrowIsAFullDisk_data()
    {
        QTest::addColumn<bool>("isOpen");
        QTest::newRow("while opening") << false;
        QTest::newRow("while saving") << true;
    }
    void aFileThatMayNotGrowIsAFullDisk()
    {
        QFETCH(bool, isOpen);
        std::signal(SIGXFSZ, SIG_IGN);
        const QTemporaryDir folder;
        const auto file = std::filesystem::path(folder.filePath(QStringLiteral("p.odo")).toStdString());
        auto project = std::move(*Project::create(file, "Year"));
        if (!isOpen)
            project.reset();
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        rlimit none = before;
        none.rlim_cur = 0;
        setrlimit(RLIMIT_FSIZE, &none);
        std::optional<Error> error;
        if (isOpen) {
            if (const auto added = project->cameras().add(CameraRecord{0, "A"}); !added)
                error = added.error();
        } else if (const auto opened = Project::open(file, Project::Access::ReadWrite); !opened) {
            error = opened.error();
        }
        setrlimit(RLIMIT_FSIZE, &before);
        QVERIFY(error);
        QVERIFY2(error->message().find(
                     "the disk is full, the change was not saved; free some disk space and try again") !=
                     std::string::npos,
                 error->message().c_str());
    }
};

ODOGRAPH_TEST(TestSqliteRefusal, QCoreApplication)
#include "tst_sqlite_refusal.moc"
