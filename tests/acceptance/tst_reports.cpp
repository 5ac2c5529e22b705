// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/program.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

/// `report` and `compare -o` as scripts call them.
class TestReports : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    QString m_project;

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    ProgramRun report(const QStringList &arguments) const
    {
        return runProgram(QStringList{QStringLiteral("report"), m_project} + arguments);
    }
    static bool isPdf(const QString &file)
    {
        QFile pdf(file);
        return pdf.open(QIODevice::ReadOnly) && pdf.read(5) == "%PDF-" &&
               pdf.readAll().trimmed().endsWith("%%EOF");
    }

private Q_SLOTS:
    void initTestCase()
    {
        const auto file = storeExample(m_folder.path().toStdString());
        QVERIFY(file.has_value());
        m_project = QString::fromStdString(file->string());
    }
    void trialsAndTheirClass()
    {
        const QString file = path("report.pdf");
        const ProgramRun run =
            report({QStringLiteral("Trial 1"), QStringLiteral("Trial 2"), QStringLiteral("-o"), file,
                    QStringLiteral("--class"), QStringLiteral("9B"), QStringLiteral("--teams"),
                    QStringLiteral("--method"), QStringLiteral("--json")});
        QVERIFY2(run.exitStatus == 0, run.err.constData());
        QVERIFY(isPdf(file));
        QCOMPARE(run.json().value(QStringLiteral("report")).toString(), file);
        // The ranking, the one team that has the usual task, and three runs with two pages each.
        QCOMPARE(run.json().value(QStringLiteral("pages")).toInt(), 1 + 1 + 2 * 3);
    }
    void aComparison()
    {
        const QString file = path("comparison.pdf");
        const ProgramRun run = runProgram(
            {QStringLiteral("compare"), m_project, QStringLiteral("Trial 1"), QStringLiteral("Trial 2"),
             QStringLiteral("--robot"), QStringLiteral("Red 2"), QStringLiteral("-o"), file,
             QStringLiteral("--json"), QStringLiteral("--paper"), QStringLiteral("letter")});
        QVERIFY2(run.exitStatus == 0, run.err.constData());
        QVERIFY(isPdf(file));
        QVERIFY(run.json().contains(QStringLiteral("aligned_by"))); // the figures as without it
    }
    void standardOutputGetsTheFileAlone_data()
    {
        QTest::addColumn<QStringList>("call");
        QTest::addColumn<QByteArray>("begin");
        const QString output = QStringLiteral("-o"), dash = QStringLiteral("-"),
                      trial = QStringLiteral("Trial 1");
        QTest::newRow("report") << QStringList{QStringLiteral("report"), m_project, trial, output, dash}
                                << QByteArray("%PDF-");
        QTest::newRow("compare") << QStringList{QStringLiteral("compare"),
                                                m_project,
                                                trial,
                                                QStringLiteral("Trial 2"),
                                                QStringLiteral("--robot"),
                                                QStringLiteral("Red 2"),
                                                output,
                                                dash}
                                 << QByteArray("%PDF-");
        QTest::newRow("target") << QStringList{QStringLiteral("target"), QStringLiteral("rings"), output,
                                               dash}
                                << QByteArray("%PDF-");
        QTest::newRow("snapshot") << QStringList{QStringLiteral("snapshot"), m_project, trial, output, dash}
                                  << QByteArray("\x89PNG");
        const QString layouts = path("layouts.odo"), layout = path("layout.csv"), add = QStringLiteral("add");
        QFile file(layout);
        QVERIFY(file.open(QIODevice::WriteOnly) &&
                file.write("label,x_mm,y_mm\nO,0,0\nU,3000.5,0\nV,0,2000\n") > 0);
        file.close();
        QCOMPARE(runProgram({QStringLiteral("new"), layouts}).exitStatus, 0);
        QCOMPARE(
            runProgram({QStringLiteral("layout"), add, layouts, QStringLiteral("gym"), layout}).exitStatus,
            0);
        QTest::newRow("layout") << QStringList{QStringLiteral("layout"), QStringLiteral("export"), layouts,
                                               QStringLiteral("gym"), dash}
                                << QByteArray("label,x_mm,y_mm\nO,0,0\nU,3000.5,0\n");
    }
    void standardOutputGetsTheFileAlone()
    {
        QFETCH(QStringList, call);
        QFETCH(QByteArray, begin);
        const ProgramRun run = runProgram(call);
        QVERIFY2(run.exitStatus == 0, run.err.constData());
        QVERIFY2(run.out.startsWith(begin), run.out.left(80).constData());
        if (begin == "%PDF-")
            QVERIFY(run.out.trimmed().endsWith("%%EOF"));
        QVERIFY(!QFile::exists(QStringLiteral("-")));
        const ProgramRun both = runProgram(call + QStringList{QStringLiteral("--json")});
        QCOMPARE(both.exitStatus, 2);
        QCOMPARE(
            both.json().value(QStringLiteral("error")).toObject().value(QStringLiteral("code")).toString(),
            QStringLiteral("wrong_call"));
    }
    void aReaderThatStopsLeavesNothingBehind()
    {
        const QString temporary = path("temporary");
        QVERIFY(QDir().mkpath(temporary));
        const ProgramRun run = runCommand(
            QStringLiteral("bash"),
            {QStringLiteral("-c"),
             QStringLiteral(
                 "TMPDIR=\"$1\" \"$ODOGRAPH_PROGRAM\" report \"$2\" 'Trial 1' 'Trial 2' -o - | head -c 5"),
             QStringLiteral("bash"), temporary, m_project});
        QCOMPARE(run.out, QByteArray("%PDF-"));
        QVERIFY(QDir(temporary).entryList({QStringLiteral("odograph*")}).isEmpty());
    }
    void aSnapshotLeavesThePreferencesAlone()
    {
        const QString preferences = path("preferences");
        QVERIFY(QDir().mkpath(preferences));
        const QByteArray before = qgetenv("XDG_CONFIG_HOME");
        qputenv("XDG_CONFIG_HOME", preferences.toUtf8());
        const ProgramRun run = runProgram({QStringLiteral("snapshot"), m_project, QStringLiteral("Trial 1"),
                                           QStringLiteral("-o"), path("window.png")});
        qputenv("XDG_CONFIG_HOME", before);
        QVERIFY2(run.exitStatus == 0, run.err.constData());
        QVERIFY(QDir(preferences).isEmpty());
    }
    void aComparisonThatCannotBeWrittenIsAWrongCall()
    {
        const ProgramRun run = runProgram({QStringLiteral("compare"), m_project, QStringLiteral("Trial 8"),
                                           QStringLiteral("Trial 9"), QStringLiteral("-o"), m_project});
        QCOMPARE(run.exitStatus, 2);
    }
    void whatFailsPrintsNothingOfIt()
    {
        const ProgramRun run = report({QStringLiteral("Trial 1"), QStringLiteral("Trial 9"),
                                       QStringLiteral("-o"), QStringLiteral("-")});
        QCOMPARE(run.exitStatus, 1);
        QVERIFY(run.out.isEmpty());
        QCOMPARE(run.err.count('\n'), 1);
    }
    void whatCannotBeIsSaidInALine_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("words");
        const QString o = QStringLiteral("-o"), trial = QStringLiteral("Trial 1"), file = path("none.pdf");
        QTest::newRow("no file") << QStringList{trial} << 2 << QStringLiteral("-o is missing");
        QTest::newRow("nothing to report")
            << QStringList{o, file} << 2 << QStringLiteral("name a trial, or a class");
        QTest::newRow("task without class")
            << QStringList{trial, o, file, QStringLiteral("--task"), QStringLiteral("x")} << 2
            << QStringLiteral("--task needs --class");
        QTest::newRow("paper") << QStringList{trial, o, file, QStringLiteral("--paper"), QStringLiteral("a3")}
                               << 2 << QStringLiteral("--paper is a4 or letter");
        QTest::newRow("trial") << QStringList{trial, QStringLiteral("Trial 9"), o, file} << 1
                               << QStringLiteral("Trial 9");
        QTest::newRow("class") << QStringList{o, file, QStringLiteral("--class"), QStringLiteral("7C")} << 1
                               << QStringLiteral("class '7C': the project has '9B'");
        QTest::newRow("logo") << QStringList{trial, o, file, QStringLiteral("--logo"), path("no.png")} << 1
                              << QStringLiteral("the file does not exist");
        QTest::newRow("folder") << QStringList{trial, o, path("no/where.pdf")} << 1
                                << QStringLiteral("does not exist");
    }
    void whatCannotBeIsSaidInALine()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, status);
        QFETCH(QString, words);
        const ProgramRun run = report(arguments);
        QCOMPARE(run.exitStatus, status);
        QVERIFY(run.out.isEmpty());
        QCOMPARE(run.err.count('\n'), 1);
        QVERIFY2(QString::fromUtf8(run.err).contains(words), run.err.constData());
        QVERIFY(QDir(m_folder.path()).entryList({QStringLiteral("none*")}).isEmpty());
    }
};

ODOGRAPH_TEST(TestReports, QCoreApplication)
#include "tst_reports.moc"
