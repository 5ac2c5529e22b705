// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QTemporaryDir>

namespace odo::test {

/// A PostgreSQL of Debian's of its own, in a temporary folder, on a socket there and no port; as root it runs
/// as the user postgres. It is stopped with the object. Logins need no password, but those named "secret…".
class PostgresServer
{
public:
    ~PostgresServer();
    /// For the first time, or again with the same data. Empty: it runs. Otherwise why not: it is not
    /// installed.
    QString start();
    void stop();
    /// At once, as a power failure does it, or after those who are connected have been sent away.
    void restart(bool isCrash);

    /// "postgresql://user@/database?host=FOLDER"
    QString url(const QString &user, const QString &database = QStringLiteral("school")) const;
    /// What psql prints of a statement, run by a login, without decoration; its error where it fails.
    QString sql(const QString &statement, const QString &user = QStringLiteral("postgres"),
                const QString &database = QStringLiteral("school")) const;
    /// Another of its programs (pg_dump), as its user, with the socket's folder as PGHOST.
    bool runTool(const QString &tool, const QStringList &arguments) const;
    QString folder() const { return m_folder.path(); }

private:
    struct Outcome
    {
        bool isGood = false;
        QString out, err;
    };
    QString makeData() const;
    Outcome call(const QString &program, const QStringList &arguments) const;
    Outcome control(const QStringList &arguments) const;

    QTemporaryDir m_folder;
    bool m_isRunning = false;
};

} // namespace odo::test
