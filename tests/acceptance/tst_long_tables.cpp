// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <random>

using namespace odo::test;
using namespace Qt::StringLiterals;

namespace {

/// A million with the long tests (ODOGRAPH_TABLE_ROWS).
int rowCount()
{
    return qEnvironmentVariableIntValue("ODOGRAPH_TABLE_ROWS") > 0
               ? qEnvironmentVariableIntValue("ODOGRAPH_TABLE_ROWS")
               : 150'000;
}
constexpr int million = 1'000'000;

/// A robot that drives for as long as that, 200 positions a second, measured to 0.8 mm.
bool writeTable(const QString &name, int rows)
{
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly))
        return false;
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, 0.8);
    file.write("t_s,x_mm,y_mm\n");
    std::array<char, 64> line{};
    for (int i = 0; i < rows; ++i) {
        const double t = i / 200.0;
        const int size = std::snprintf(line.data(), line.size(), "%.3f,%.2f,%.2f\n", t,
                                       1500 * std::sin(t * 0.5) + 300 * std::sin(t * 1.7) + noise(random),
                                       1000 * std::cos(t * 0.37) + 200 * std::sin(t * 1.1) + noise(random));
        if (file.write(line.data(), size) != size)
            return false;
    }
    return true;
}

} // namespace

/// Tables of a million lines: quick, in little memory, and stopped within a second.
class TestLongTables : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }
    const QString m_project = path(u"long.odo"_s), m_table = path(u"long.csv"_s);
    QStringList importOf(const QString &trial) const
    {
        return {u"import"_s, m_project, u"--trial"_s, trial, u"--track"_s, u"R="_s + m_table};
    }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(writeTable(m_table, rowCount()));
        QCOMPARE(runProgram({u"new"_s, m_project}).exitStatus, 0);
    }

    /// At any moment, and the project is as it was.
    void stopsWithinASecond()
    {
        const auto first = runProgram({u"list"_s, m_project, u"--json"_s}).out;
        int stopped = 0;
        for (const int afterMs : {80, 200, 400, 700, 1100, 1600, 2300, 3300, 4600, 6000}) {
            QProcess process;
            process.start(qEnvironmentVariable("ODOGRAPH_PROGRAM"), importOf(u"stopped"_s));
            QVERIFY(process.waitForStarted());
            if (process.waitForFinished(afterMs)) {
                QCOMPARE(process.exitCode(), 0);
                break; // it was through
            }
            QElapsedTimer clock;
            clock.start();
            ::kill(static_cast<pid_t>(process.processId()), SIGINT);
            QVERIFY(process.waitForFinished());
            QVERIFY2(clock.elapsed() < 1000 * slowness, qPrintable(QString::number(clock.elapsed())));
            if (process.exitCode() == 0)
                break;                                        // it was being stored for good
            if (process.exitStatus() == QProcess::NormalExit) // else it had not come to watching for signals
                QCOMPARE(process.exitCode(), 130);
            QCOMPARE(runProgram({u"list"_s, m_project, u"--json"_s}).out, first);
            ++stopped;
        }
        QVERIFY(stopped > 0);
    }

    void isQuickAndSmall()
    {
        const MeasuredRun import = runMeasured(importOf(u"lap"_s));
        qInfo("%d rows: %.1f s, %.0f MB", rowCount(), import.seconds, import.megabytes);
        QCOMPARE(import.exitStatus, 0);
        QVERIFY2(import.megabytes < 300, qPrintable(QString::number(import.megabytes)));
        if (rowCount() >= million)
            QVERIFY2(import.seconds < 10, qPrintable(QString::number(import.seconds)));
        const QJsonObject robot =
            runProgram({u"show"_s, m_project, u"lap"_s, u"--json"_s}).json()[u"robots"_s][u"R"_s].toObject();
        for (const QJsonValue &metric : robot[u"metrics"_s].toArray()) {
            if (metric[u"name"_s].toString() == u"duration"_s)
                QVERIFY(std::abs(metric[u"value"_s].toDouble() - rowCount() / 200.0) < 0.1);
        }
        QVERIFY(robot[u"spikes"_s].toArray().size() < rowCount() / 10'000);
    }

    /// What is done with any trial.
    void canBeUsed()
    {
        using Arguments = QStringList;
        for (const Arguments &arguments :
             {Arguments{u"show"_s, m_project, u"lap"_s, u"--json"_s}, Arguments{u"check"_s, m_project},
              Arguments{u"check"_s, m_project, u"--quick"_s},
              Arguments{u"export"_s, m_project, u"lap"_s, u"-o"_s, path(u"out.csv"_s)},
              Arguments{u"export"_s, m_project, u"lap"_s, u"--format"_s, u"tum"_s, u"-o"_s,
                        path(u"out.tum"_s)},
              Arguments{u"export"_s, m_project, u"lap"_s, u"--format"_s, u"json"_s, u"-o"_s,
                        path(u"out.json"_s)},
              Arguments{u"report"_s, m_project, u"lap"_s, u"-o"_s, path(u"out.pdf"_s)},
              Arguments{u"snapshot"_s, m_project, u"lap"_s, u"-o"_s, path(u"out.png"_s)}}) {
            const MeasuredRun run = runMeasured(arguments);
            qInfo("%s: %.1f s, %.0f MB",
                  qPrintable(arguments.first() + u' ' + arguments.last().section(u'/', -1)), run.seconds,
                  run.megabytes);
            QCOMPARE(run.exitStatus, 0);
            QVERIFY2(run.megabytes < 500, qPrintable(arguments.join(u' ') + QString::number(run.megabytes)));
            QVERIFY2(run.seconds < 10 * slowness,
                     qPrintable(arguments.join(u' ') + QString::number(run.seconds)));
        }
    }
};

ODOGRAPH_TEST(TestLongTables, QCoreApplication)
#include "tst_long_tables.moc"
