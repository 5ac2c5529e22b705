// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/hub_address.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;

namespace {

class HubAddressTest : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void urlsAreReadAsPsqlReadsThem();
    void badUrlsAreRefused_data();
    void badUrlsAreRefused();
    void noErrorRepeatsAPassword();
};

void HubAddressTest::urlsAreReadAsPsqlReadsThem()
{
    const auto whole =
        HubAddress::parse("postgresql://bench%201@db.school.example:5433/robots?sslmode=verify-full");
    QVERIFY(whole);
    QCOMPARE(whole->user, "bench 1");
    QCOMPARE(whole->host, "db.school.example");
    QCOMPARE(whole->port, 5433);
    QCOMPARE(whole->database, "robots");
    QCOMPARE(whole->sslMode, "verify-full");
    const auto socket = HubAddress::parse("postgresql://anna@/school?host=/run/postgresql");
    QVERIFY(socket);
    QCOMPARE(socket->host, "/run/postgresql");
    QCOMPARE(socket->sslMode, "prefer");
    QCOMPARE(socket->port, 0);
    for (const char *url : {"postgresql://bench%201@db.school.example:5433/robots?sslmode=verify-full",
                            "postgresql://anna@/school?host=/run/postgresql", "postgresql:///school",
                            "postgresql://[::1]/school", "postgresql://anna@/school"}) {
        const auto once = HubAddress::parse(url);
        QVERIFY2(once, url);
        const auto again = HubAddress::parse(once->url());
        QVERIFY2(again, once->url().c_str());
        QCOMPARE(again->url(), once->url());
        QCOMPARE(again->user, once->user);
        QCOMPARE(again->host, once->host);
        QCOMPARE(again->database, once->database);
    }
}

void HubAddressTest::badUrlsAreRefused_data()
{
    QTest::addColumn<QString>("url");
    QTest::addColumn<QString>("words");
    const auto add = [](const char *url, const char *words) {
        QTest::newRow(url) << QString::fromLatin1(url) << QString::fromLatin1(words);
    };
    add("mysql://anna@school/robots", "no address of a PostgreSQL database");
    add("school", "no address of a PostgreSQL database");
    add("", "no address of a PostgreSQL database");
    add("postgresql://anna@school", "names no database");
    add("postgresql://anna@school/robots?sslmode=always", "sslmode 'always' is not known");
    add("postgresql://anna@school/robots?options=-csearch_path", "option 'options' is not known");
    add("postgresql://anna@school/a'b", "quotation mark");
    add("postgresql://anna@school/a%3Bb", "semicolon");
}

void HubAddressTest::badUrlsAreRefused()
{
    QFETCH(QString, url);
    QFETCH(QString, words);
    const auto address = HubAddress::parse(url.toStdString());
    QVERIFY(!address);
    QVERIFY2(QString::fromStdString(address.error().message()).contains(words),
             address.error().message().c_str());
}

void HubAddressTest::noErrorRepeatsAPassword()
{
    for (const char *url :
         {"postgresql://anna:hunter2@school/robots", "postgresql://anna@school/robots?password=hunter2"}) {
        const auto address = HubAddress::parse(url);
        QVERIFY(!address);
        const QString said = QString::fromStdString(address.error().message());
        QVERIFY2(said.contains(QLatin1String(".pgpass")), qPrintable(said));
        QVERIFY2(!said.contains(QLatin1String("hunter2")), qPrintable(said));
    }
}

} // namespace

ODOGRAPH_TEST(HubAddressTest, QCoreApplication)
#include "tst_hub_address.moc"
