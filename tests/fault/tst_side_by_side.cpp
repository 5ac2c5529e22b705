// SPDX-License-Identifier: GPL-3.0-or-later
// Several processes at once on one project: one of an older format, and one on a slow disk. A sound project
// is never called damaged, and none of them fails.
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <memory>
#include <sqlite3.h>
#include <vector>

using namespace odo::test;

class TestSideBySide : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    /// Each is stopped at a call of its own of the system, for the disk is slow.
    void anOlderFormatIsBroughtUpToDateByOneOfFour_data()
    {
        QTest::addColumn<int>("format");
        QTest::addColumn<int>("slowUs");
        const int rounds = qEnvironmentVariableIntValue("ODOGRAPH_ALL_FAULTS") != 0 ? 30 : 4;
        for (int round = 0; round < rounds; ++round) {
            const int format = 1 + 3 * round % 10;
            QTest::addRow("%d: format %d", round, format) << format << (round % 4) * 300;
        }
    }
    void anOlderFormatIsBroughtUpToDateByOneOfFour()
    {
        QFETCH(int, format);
        QFETCH(int, slowUs);
        const QString project = storedFormat(format);
        std::vector<std::unique_ptr<QProcess>> processes;
        for (int i = 0; i < 4; ++i)
            processes.push_back(begin({QStringLiteral("list"), project, QStringLiteral("--json")}, slowUs));
        for (const auto &process : processes)
            QVERIFY2(succeeds(*process), m_words.constData());
        // Of two that close it at one moment, each leaves its log to the other: an empty one, until it is
        // next opened.
        QCOMPARE(QFileInfo(project + QStringLiteral("-wal")).size(), 0);
        QCOMPARE(runProgram({QStringLiteral("list"), project}).exitStatus, 0);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden),
                 (QStringList{QStringLiteral("year.odo"), QStringLiteral("year.odo.bak-%1").arg(format)}));
    }

    void whoeverReadsBesideWritersOnASlowDiskFindsItSound()
    {
        const QString project = m_folder->filePath(QStringLiteral("year.odo"));
        QCOMPARE(runProgram({QStringLiteral("new"), project}).exitStatus, 0);
        const int reads = qEnvironmentVariableIntValue("ODOGRAPH_ALL_FAULTS") != 0 ? 24 : 8;
        std::vector<std::unique_ptr<QProcess>> processes;
        for (int i = 0; i < reads; ++i) {
            const bool reading = i % 2 == 0;
            processes.push_back(begin(reading ? QStringList{QStringLiteral("list"), project}
                                              : QStringList{QStringLiteral("camera"), QStringLiteral("add"),
                                                            project, QStringLiteral("C%1").arg(i)},
                                      2000));
            if (i % 4 == 3) {
                for (const auto &process : processes)
                    QVERIFY2(succeeds(*process), m_words.constData());
                processes.clear();
            }
        }
        for (const auto &process : processes)
            QVERIFY2(succeeds(*process), m_words.constData());
        QCOMPARE(runProgram({QStringLiteral("check"), project}).exitStatus, 0);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden),
                 QStringList{QStringLiteral("year.odo")});
    }

private:
    QString storedFormat(int format) const
    {
        QFile dump(QDir(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR"))
                       .filePath(QStringLiteral("tests/data/project_format_%1.sql").arg(format)));
        if (!dump.open(QIODevice::ReadOnly))
            qFatal("no dump of format %d", format);
        const QString made = m_folder->filePath(QStringLiteral("year.odo"));
        sqlite3 *database = nullptr;
        char *why = nullptr;
        if (sqlite3_open(made.toUtf8().constData(), &database) != SQLITE_OK ||
            sqlite3_exec(database, dump.readAll().constData(), nullptr, nullptr, &why) != SQLITE_OK)
            qFatal("format %d: %s", format, why);
        sqlite3_close(database);
        return made;
    }

    static std::unique_ptr<QProcess> begin(const QStringList &arguments, int slowUs)
    {
        auto process = std::make_unique<QProcess>();
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("LD_PRELOAD"), qEnvironmentVariable("ODOGRAPH_SLOW_DISK_LIBRARY"));
        environment.insert(QStringLiteral("ODOGRAPH_SLOW_US"), QString::number(slowUs));
        process->setProcessEnvironment(environment);
        process->start(qEnvironmentVariable("ODOGRAPH_PROGRAM"), arguments);
        return process;
    }

    bool succeeds(QProcess &process)
    {
        constexpr int longestMs = 120'000;
        const bool ended = process.waitForFinished(longestMs);
        m_words = process.readAllStandardError();
        return ended && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QByteArray m_words;
};

ODOGRAPH_TEST(TestSideBySide, QCoreApplication)
#include "tst_side_by_side.moc"
