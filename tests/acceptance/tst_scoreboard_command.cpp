// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommand that serves the standings: its calls, its answer, and its end.
#include "tests/support/calling_test.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <csignal>
#include <memory>

using namespace odo::test;

class TestScoreboardCommand : public QObject, private CallingTest
{
    Q_OBJECT

    std::unique_ptr<QProcess> m_program;

    /// Returns when it has answered.
    QByteArray begin(const char *line)
    {
        m_program = std::make_unique<QProcess>();
        m_program->start(qEnvironmentVariable("ODOGRAPH_PROGRAM"), filled(QString::fromUtf8(line)));
        QByteArray out;
        while (!out.endsWith("}\n") && !out.endsWith("them.\n") && m_program->waitForReadyRead(20'000))
            out += m_program->readAllStandardOutput();
        return out;
    }
    int end(int signal)
    {
        ::kill(pid_t(m_program->processId()), signal);
        if (!m_program->waitForFinished(20'000)) {
            m_program->kill();
            m_program->waitForFinished();
            return -1;
        }
        return m_program->exitStatus() == QProcess::NormalExit ? m_program->exitCode() : -2;
    }
    static QByteArray answer(int port, const QByteArray &request)
    {
        QTcpSocket socket;
        socket.connectToHost(QStringLiteral("127.0.0.1"), quint16(port));
        socket.write(request);
        while (socket.waitForReadyRead(10'000)) {
        }
        return socket.readAll();
    }

private Q_SLOTS:
    void initTestCase()
    {
        good("new %P");
        write("track.csv", gappedTrack(0));
        good("import %P --trial run --track Red=%/track.csv");
    }

    void saysWhereItListens()
    {
        const QByteArray out = begin("scoreboard %P --port 0 --json");
        const QJsonObject json = QJsonDocument::fromJson(out).object();
        const int port = json[QStringLiteral("port")].toInt();
        QVERIFY2(port > 0, out);
        QCOMPARE(json[QStringLiteral("address")].toString(), QStringLiteral("127.0.0.1"));
        QCOMPARE(json[QStringLiteral("url")].toString(), QStringLiteral("http://127.0.0.1:%1/").arg(port));
        for (const char *name : {"task", "class", "metric"})
            QVERIFY2(json.contains(QLatin1String(name)), name);
        const QByteArray page = answer(port, "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n");
        QVERIFY(page.startsWith("HTTP/1.1 200 OK\r\n") && page.contains("</html>"));
        QVERIFY(answer(port, "PUT / HTTP/1.1\r\nHost: localhost\r\n\r\n").startsWith("HTTP/1.1 405 "));
        QCOMPARE(end(SIGTERM), 143);
        QCOMPARE(m_program->readAllStandardOutput(), QByteArray());
    }

    void saysWhoCanSeeIt()
    {
        QByteArray out = begin("scoreboard %P --port 0");
        QVERIFY2(out.contains("Only this computer can open the page"), out);
        QCOMPARE(end(SIGINT), 130);
        QVERIFY(m_program->readAllStandardError().startsWith("odograph: scoreboard: cancelled"));
        out = begin("scoreboard %P --port 0 --address 0.0.0.0");
        QVERIFY2(out.contains("Everyone in the network can open the page"), out);
        QCOMPARE(end(SIGTERM), 143);
    }

    void aPortInUseIsNamed()
    {
        QTcpServer other;
        QVERIFY(other.listen(QHostAddress(QHostAddress::LocalHost)));
        const ProgramRun failed = run(QStringLiteral("scoreboard %P --port %1").arg(other.serverPort()));
        QCOMPARE(failed.exitStatus, 1);
        QCOMPARE(failed.err, QByteArray("odograph: standings at 127.0.0.1 port " +
                                        QByteArray::number(other.serverPort()) +
                                        ": another program uses this port; choose another port, or 0 for any "
                                        "that is free\n"));
    }

    void badCalls_data()
    {
        beginBadCalls();
        addBadCall("scoreboard %P --port 70000", 2, "--port is a number from 0 to 65535");
        addBadCall("scoreboard %P --port x", 2, "--port is a number from 0 to 65535");
        addBadCall("scoreboard %P --address example.org", 2, "--address is an address");
        addBadCall("scoreboard %P --port 0 --address 203.0.113.7", 1, "it is no address of this computer");
        addBadCall("scoreboard %P --class 7C", 1, "class '7C'");
        addBadCall("scoreboard %P --task Sprint", 1, "Sprint");
        addBadCall("scoreboard %/none.odo", 1, "none.odo");
        addBadCall("scoreboard postgresql://anna:hunter2@db/robots", 2, "~/.pgpass");
        addBadCall("scoreboard postgresql://anna@db", 2, "it names no database");
        addBadCall("scoreboard postgres://anna@/robots?host=/nonexistent --port 0", 1,
                   "school hub '/nonexistent/robots'");
        addBadCall("scoreboard", 2, "an argument is missing");
    }
    void badCalls() { badCallFailsInOneLine(); }

    /// The project is as it was, and nothing is left beside it.
    void leavesTheProjectAsItWas()
    {
        const QByteArray before = fileHash(m_project);
        begin("scoreboard %P --port 0");
        QCOMPARE(good("trial set %P run --note word").exitStatus, 0);
        QCOMPARE(end(SIGTERM), 143);
        QVERIFY(good("check %P").exitStatus == 0);
        QVERIFY(before != fileHash(m_project)); // by the other program
        const QStringList left = QDir(m_folder.path()).entryList(QDir::Files);
        for (const QString &file : left)
            QVERIFY2(!file.endsWith(QLatin1String("-wal")) && !file.endsWith(QLatin1String("-shm")),
                     qPrintable(file));
    }
};

ODOGRAPH_TEST(TestScoreboardCommand, QCoreApplication)
#include "tst_scoreboard_command.moc"
