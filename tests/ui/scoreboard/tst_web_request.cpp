// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "ui/scoreboard/internal/web_request.h"

#include <QTest>
#include <random>

using namespace odo;

namespace {

using State = RequestReading::State;

const QByteArray browser = "GET /events?3 HTTP/1.1\r\n"
                           "Host: 127.0.0.1:8080\r\n"
                           "Connection: keep-alive\r\n"
                           "Accept: text/event-stream\r\n"
                           "Accept-Language: de-AT,de;q=0.9,en;q=0.5\r\n\r\n";

/// A request as a browser's, with something done to it.
QByteArray mutated(std::mt19937 &random)
{
    const auto any = [&random](qsizetype most) {
        return qsizetype(std::uniform_int_distribution<qint64>(0, most)(random));
    };
    QByteArray bytes = browser;
    static const QList<QByteArray> words{"\r\n",
                                         "\r",
                                         "\n",
                                         QByteArray(1, '\0'),
                                         " ",
                                         ":",
                                         "\r\n\r\n",
                                         "HTTP/9.9",
                                         "POST",
                                         "Host: x\r\n",
                                         "%00../..",
                                         "\xff\xfe",
                                         "Content-Length: 18446744073709551616\r\n",
                                         "Transfer-Encoding: chunked\r\n",
                                         QByteArray(3000, 'a')};
    for (qsizetype times = 1 + any(4); times > 0; --times) {
        const qsizetype at = any(bytes.size() - 1);
        switch (any(4)) {
        case 0:
            bytes[at] = char(any(255));
            break;
        case 1:
            bytes.remove(at, 1 + any(20));
            break;
        case 2:
            bytes.insert(at, words[any(words.size() - 1)]);
            break;
        case 3:
            bytes.truncate(at + 1);
            break;
        default:
            bytes += bytes.mid(at, 400);
        }
        if (bytes.isEmpty())
            return bytes;
    }
    return bytes;
}

} // namespace

class TestWebRequest : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aBrowsersRequestIsRead()
    {
        const RequestReading reading = readRequest(browser);
        QCOMPARE(reading.state, State::Complete);
        QCOMPARE(reading.request.path, QByteArray("/events"));
        QCOMPARE(reading.request.host, QByteArray("127.0.0.1"));
        QCOMPARE(reading.request.language, QByteArray("de-AT,de;q=0.9,en;q=0.5"));
        QCOMPARE(readRequest("GET / HTTP/1.0\r\n\r\n").state, State::Complete);
        const RequestReading six = readRequest("GET / HTTP/1.1\r\nhost: [::1]:80\r\n\r\n");
        QCOMPARE(six.request.host, QByteArray("[::1]"));
    }

    /// What comes in pieces is read once it is whole, and never refused before.
    void piecesAreWaitedFor()
    {
        for (qsizetype bytes = 0; bytes < browser.size(); ++bytes)
            QCOMPARE(readRequest(browser.first(bytes)).state, State::Incomplete);
    }

    void whatIsNotOursIsRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("status");
        const QByteArray host = "Host: localhost\r\n";
        QTest::newRow("post") << QByteArray("POST / HTTP/1.1\r\n" + host + "\r\n") << 405;
        QTest::newRow("head") << QByteArray("HEAD / HTTP/1.1\r\n" + host + "\r\n") << 405;
        QTest::newRow("options *") << QByteArray("OPTIONS * HTTP/1.1\r\n" + host + "\r\n") << 405;
        QTest::newRow("http 2") << QByteArray("PRI * HTTP/2.0\r\n\r\n") << 505;
        QTest::newRow("no version") << QByteArray("GET /\r\n\r\n") << 400;
        QTest::newRow("http 0.9") << QByteArray("GET / HTTP/1\r\n\r\n") << 400;
        QTest::newRow("a proxy's") << QByteArray("GET http://a/ HTTP/1.1\r\n" + host + "\r\n") << 400;
        QTest::newRow("tls") << QByteArray("\x16\x03\x01\x02", 4) << 400;
        QTest::newRow("bare lf") << QByteArray("GET / HTTP/1.1\nHost: localhost\n\n") << 400;
        QTest::newRow("zero byte") << QByteArray("GET /\0 HTTP/1.1\r\n\r\n", 19) << 400;
        QTest::newRow("blank in the target") << QByteArray("GET /a b HTTP/1.1\r\n" + host + "\r\n") << 400;
        QTest::newRow("no host") << QByteArray("GET / HTTP/1.1\r\n\r\n") << 400;
        QTest::newRow("two hosts") << QByteArray("GET / HTTP/1.1\r\n" + host + host + "\r\n") << 400;
        QTest::newRow("host is none") << QByteArray("GET / HTTP/1.1\r\nHost: a/b\r\n\r\n") << 400;
        QTest::newRow("folded field")
            << QByteArray("GET / HTTP/1.1\r\n" + host + "A: b\r\n c\r\n\r\n") << 400;
        QTest::newRow("blank before the colon")
            << QByteArray("GET / HTTP/1.1\r\n" + host + "A : b\r\n\r\n") << 400;
        QTest::newRow("content") << QByteArray("GET / HTTP/1.1\r\n" + host + "Content-Length: 5\r\n\r\nabcde")
                                 << 400;
        QTest::newRow("chunks") << QByteArray("GET / HTTP/1.1\r\n" + host +
                                              "Transfer-Encoding: chunked\r\n\r\n")
                                << 400;
        QTest::newRow("long line") << QByteArray("GET /" + QByteArray(longestRequestLine, 'a')) << 414;
        QTest::newRow("long header") << QByteArray("GET / HTTP/1.1\r\n" + host +
                                                   "A: " + QByteArray(longestRequest, 'a'))
                                     << 431;
        QTest::newRow("many fields") << QByteArray("GET / HTTP/1.1\r\n" + host +
                                                   QByteArray("A: b\r\n").repeated(100) + "\r\n")
                                     << 431;
    }

    void whatIsNotOursIsRefused()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(int, status);
        const RequestReading reading = readRequest(bytes);
        QCOMPARE(reading.state, State::Refused);
        QCOMPARE(int(reading.refusal), status);
    }

    /// A hundred thousand requests that were changed at random: each is read, waited for or refused, and what
    /// is read is a path without anything that could leave its line.
    void changedRequestsDoNoHarm()
    {
        std::mt19937 random(39);
        int complete = 0, refused = 0;
        for (int i = 0; i < 100'000; ++i) {
            const QByteArray bytes = mutated(random);
            const RequestReading reading = readRequest(bytes);
            complete += reading.state == State::Complete;
            refused += reading.state == State::Refused;
            if (reading.state == State::Incomplete)
                QVERIFY(bytes.size() <= longestRequest);
            if (reading.state == State::Complete) {
                QVERIFY(reading.request.path.startsWith('/'));
                QVERIFY(reading.request.path.size() <= longestRequestLine);
                for (const char c : reading.request.path + reading.request.host)
                    QVERIFY(c > ' ' && c < 127);
            }
        }
        QVERIFY(complete > 1000 && refused > 10'000);
    }
};

ODOGRAPH_TEST(TestWebRequest, QCoreApplication)
#include "tst_web_request.moc"
