// SPDX-License-Identifier: GPL-3.0-or-later
// A hub that an earlier version made: it is named as such, and upgraded with all that is in it.
#include "core/school/hub_results.h"
#include "core/school/school_sync.h"
#include "tests/school/postgres_server.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTest>

using namespace odo;
using odo::test::PostgresServer;

class TestHubSchema : public QObject
{
    Q_OBJECT
    PostgresServer m_server;

    HubAddress hub(const char *login) const
    {
        return *HubAddress::parse(m_server.url(QString::fromLatin1(login)).toStdString());
    }
    static QString firstSchema()
    {
        QFile file(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR") +
                   QStringLiteral("/core/school/schema/01_hub.sql"));
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    }

private Q_SLOTS:
    void initTestCase()
    {
        const QString problem = m_server.start();
        if (!problem.isEmpty())
            QSKIP(qPrintable(QStringLiteral("ODOGRAPH-SKIPPED: ") + problem));
        const QString postgres = QStringLiteral("postgres");
        m_server.sql(QStringLiteral("CREATE DATABASE school"), postgres, postgres);
        QCOMPARE(m_server.sql(firstSchema()), QString());
        QCOMPARE(
            m_server.sql(QStringLiteral(
                "CREATE ROLE bench1 LOGIN IN ROLE bench; CREATE ROLE wall LOGIN IN ROLE viewer; "
                "INSERT INTO odograph.document (uuid, kind, name, bench, owner, sha256, body) VALUES "
                "('00000000-0000-0000-0000-000000000001', 'trial', 'Run 1', gen_random_uuid(), 'bench1', "
                "repeat('0', 64), ''); "
                "INSERT INTO odograph.result VALUES ('00000000-0000-0000-0000-000000000001', 'Red', "
                "'bench1', 'Run 1', 'Anna', 'Falcon', '9B', 'Slalom', '2026-03-01', 10); "
                "INSERT INTO odograph.metric VALUES ('00000000-0000-0000-0000-000000000001', 'Red', "
                "'gate_time', 's', 8.5, 0.05, false)")),
            QString());
    }

    void anOlderHubIsNamed()
    {
        const auto results = HubResults::connect(hub("wall"));
        QVERIFY(!results);
        QCOMPARE(results.error().code, ErrorCode::NotFound);
        const QString words = QString::fromStdString(results.error().message());
        QVERIFY2(
            words.contains(QStringLiteral("its schema has version 1, and this Odograph needs 3; have its "
                                          "administrator run odograph school init")),
            qPrintable(words));
    }

    void upgradingKeepsWhatThereIs()
    {
        for (int time = 0; time < 2; ++time) {
            const auto version = initialiseHub(hub("postgres"));
            QVERIFY2(version, version ? "" : version.error().message().c_str());
            QCOMPARE(*version, 3);
        }
        const auto results = HubResults::connect(hub("wall"));
        QVERIFY2(results, results ? "" : results.error().message().c_str());
        const auto found = (*results)->standings({"", "", ""});
        QVERIFY2(found, found ? "" : found.error().message().c_str());
        const Standings &standings = found->reading.standings;
        QCOMPARE(standings.choice.task, "Slalom");
        QCOMPARE(standings.choice.metric, "gate_time");
        QCOMPARE(standings.teams.size(), 1u);
        QCOMPARE(standings.teams.front().team, "Falcon");
        QCOMPARE(standings.teams.front().statistics.median, 8.5);
        QCOMPARE(m_server.sql(QStringLiteral("SELECT name FROM odograph.result"), QStringLiteral("bench1")),
                 QStringLiteral("Run 1"));
    }

    /// As does whatever is a change of results, and nothing else.
    void aChangeOfResultsChangesTheState()
    {
        const auto results = *HubResults::connect(hub("wall"));
        const auto before = *results->state();
        m_server.sql(QStringLiteral("SELECT * FROM odograph.result"), QStringLiteral("wall"));
        QCOMPARE(*results->state(), before);
        m_server.sql(QStringLiteral("UPDATE odograph.result SET standing = 'doubtful'"),
                     QStringLiteral("bench1"));
        const auto marked = *results->state();
        QVERIFY(marked > before);
        QCOMPARE(results->standings({"", "", ""})->reading.standings.teams.front().doubtfulRuns(), 1);
        m_server.sql(QStringLiteral("DELETE FROM odograph.document"));
        QVERIFY(*results->state() > marked);
        QVERIFY(results->standings({"", "", ""})->reading.standings.teams.empty());
    }
};

ODOGRAPH_TEST(TestHubSchema, QCoreApplication)
#include "tst_hub_schema.moc"
