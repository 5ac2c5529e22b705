// SPDX-License-Identifier: GPL-3.0-or-later
// A project of every older format, as tests/data keeps them, listed by the program: it is brought up to date,
// and nothing is missing.
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <sqlite3.h>

using namespace odo::test;

class TestOldFormats : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    static QString dumpOf(int format)
    {
        return QDir(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR"))
            .filePath(QStringLiteral("tests/data/project_format_%1.sql").arg(format));
    }

    QString stored(int format) const
    {
        QFile dump(dumpOf(format));
        if (!dump.open(QIODevice::ReadOnly))
            qFatal("no dump of format %d", format);
        const QString made = m_folder.filePath(QStringLiteral("year %1.odo").arg(format));
        sqlite3 *database = nullptr;
        char *why = nullptr;
        if (sqlite3_open(made.toUtf8().constData(), &database) != SQLITE_OK ||
            sqlite3_exec(database, dump.readAll().constData(), nullptr, nullptr, &why) != SQLITE_OK)
            qFatal("format %d: %s", format, why);
        sqlite3_close(database);
        return made;
    }

private Q_SLOTS:
    void areListed_data()
    {
        QTest::addColumn<int>("format");
        int format = 1;
        for (; QFile::exists(dumpOf(format)); ++format)
            QTest::addRow("format %d", format) << format;
        QVERIFY(format > 10);
    }
    void areListed()
    {
        QFETCH(int, format);
        const QString project = stored(format);
        const ProgramRun list = runProgram({QStringLiteral("list"), project, QStringLiteral("--json")});
        QVERIFY2(list.exitStatus == 0, list.err.constData());
        const QJsonArray trials = list.json()[QLatin1String("trials")].toArray();
        QCOMPARE(trials.size(), 2);
        QStringList names;
        for (const QJsonValue &trial : trials)
            names << trial[QLatin1String("name")].toString();
        QVERIFY(names.contains(QStringLiteral("run 1")) && names.contains(QStringLiteral("run 2")));
        QVERIFY(QFile::exists(project + QStringLiteral(".bak-%1").arg(format)));
        // A second time it is an ordinary project.
        QCOMPARE(runProgram({QStringLiteral("list"), project, QStringLiteral("--json")}).out, list.out);
    }
};

ODOGRAPH_TEST(TestOldFormats, QCoreApplication)
#include "tst_old_formats.moc"
