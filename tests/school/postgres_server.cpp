// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/school/postgres_server.h"

#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <unistd.h>

namespace odo::test {

namespace {

const QString programs = QStringLiteral("/usr/lib/postgresql/15/bin/");
constexpr int patienceMs = 120'000;

} // namespace

PostgresServer::~PostgresServer()
{
    stop();
}

/// The server refuses to run as root; then everything of it belongs to the user that Debian makes for it.
PostgresServer::Outcome PostgresServer::call(const QString &program, const QStringList &arguments) const
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("PGHOST"), folder());
    environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8"));
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(QStringLiteral("/"));
    if (geteuid() == 0)
        process.start(QStringLiteral("runuser"), QStringList{QStringLiteral("-u"), QStringLiteral("postgres"),
                                                             QStringLiteral("--"), program} +
                                                     arguments);
    else
        process.start(program, arguments);
    const bool isDone = process.waitForFinished(patienceMs);
    return {isDone && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0,
            QString::fromUtf8(process.readAllStandardOutput()).trimmed(),
            QString::fromUtf8(process.readAllStandardError()).trimmed()};
}

PostgresServer::Outcome PostgresServer::control(const QStringList &arguments) const
{
    return call(programs + QStringLiteral("pg_ctl"),
                QStringList{QStringLiteral("-D"), folder() + QStringLiteral("/data"), QStringLiteral("-w"),
                            QStringLiteral("-l"), folder() + QStringLiteral("/log")} +
                    arguments);
}

/// Its data, with logins that need no password but one.
QString PostgresServer::makeData() const
{
    if (geteuid() == 0)
        QProcess::execute(QStringLiteral("chown"), {QStringLiteral("postgres"), folder()});
    const Outcome made = call(programs + QStringLiteral("initdb"),
                              {QStringLiteral("-D"), folder() + QStringLiteral("/data"), QStringLiteral("-U"),
                               QStringLiteral("postgres"), QStringLiteral("-A"), QStringLiteral("trust"),
                               QStringLiteral("-E"), QStringLiteral("UTF8"), QStringLiteral("--no-sync")});
    if (!made.isGood)
        return QStringLiteral("PostgreSQL cannot make a database here: ") + made.err;
    QFile access(folder() + QStringLiteral("/data/pg_hba.conf"));
    if (!access.open(QIODevice::WriteOnly))
        return QStringLiteral("pg_hba.conf cannot be written");
    access.write("local all secret scram-sha-256\nlocal all all trust\n");
    if (geteuid() == 0) // the socket is for this user too
        QProcess::execute(QStringLiteral("chmod"), {QStringLiteral("755"), folder()});
    return {};
}

QString PostgresServer::start()
{
    if (!QFile::exists(programs + QStringLiteral("initdb")))
        return QStringLiteral("PostgreSQL 15 is not installed");
    if (!QFile::exists(folder() + QStringLiteral("/data"))) {
        if (QString problem = makeData(); !problem.isEmpty())
            return problem;
    }
    const Outcome started = control(
        {QStringLiteral("-o"),
         QStringLiteral("-k %1 -c listen_addresses='' -c unix_socket_permissions=0777 -c max_connections=200")
             .arg(folder()),
         QStringLiteral("start")});
    m_isRunning = started.isGood;
    return started.isGood ? QString() : QStringLiteral("PostgreSQL does not start: ") + started.err;
}

void PostgresServer::stop()
{
    if (m_isRunning)
        control({QStringLiteral("-m"), QStringLiteral("immediate"), QStringLiteral("stop")});
    m_isRunning = false;
}

void PostgresServer::restart(bool isCrash)
{
    control({QStringLiteral("-m"), isCrash ? QStringLiteral("immediate") : QStringLiteral("fast"),
             QStringLiteral("restart")});
}

QString PostgresServer::url(const QString &user, const QString &database) const
{
    return QStringLiteral("postgresql://%1@/%2?host=%3").arg(user, database, folder());
}

QString PostgresServer::sql(const QString &statement, const QString &user, const QString &database) const
{
    const Outcome outcome =
        call(QStringLiteral("psql"),
             {QStringLiteral("-X"), QStringLiteral("-q"), QStringLiteral("-A"), QStringLiteral("-t"),
              QStringLiteral("-v"), QStringLiteral("ON_ERROR_STOP=1"), QStringLiteral("-U"), user,
              QStringLiteral("-d"), database, QStringLiteral("-c"), statement});
    return outcome.isGood ? outcome.out : outcome.err;
}

bool PostgresServer::runTool(const QString &tool, const QStringList &arguments) const
{
    const Outcome outcome = call(tool, arguments);
    if (!outcome.isGood)
        qWarning("%s: %s", qPrintable(tool), qPrintable(outcome.err));
    return outcome.isGood;
}

} // namespace odo::test
