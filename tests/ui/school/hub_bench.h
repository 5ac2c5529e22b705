// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/school/school_sync.h"
#include "tests/school/bench_trials.h"
#include "tests/school/postgres_server.h"
#include "ui/school/hub_exchange.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTemporaryDir>
#include <memory>

namespace odo::test {

/// A school's hub with the logins bench1, bench2 and secret (password hunter2), and projects for it.
class HubBench
{
public:
    /// Empty: it runs. Otherwise why not.
    QString start();
    /// For a test function: an empty hub and an empty folder.
    void clear();
    /// With so many trials, which are not connected.
    std::unique_ptr<Project> project(const char *name, int trials) const;
    HubAddress address(const char *login) const;
    int number(const char *statement) const { return server.sql(QString::fromLatin1(statement)).toInt(); }

    PostgresServer server;

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

/// So quick that a test need not wait.
HubPace quickPace();

/// How long the event loop of this thread stood still at most, by the clock on the wall.
class StandstillWatch : public QObject
{
public:
    StandstillWatch();
    qint64 longestMs() const { return m_longestMs; }

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    QElapsedTimer m_since;
    qint64 m_longestMs = 0;
};

} // namespace odo::test
