// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "ui/scoreboard/internal/web_server.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTcpSocket>
#include <QTest>
#include <QTimer>
#include <memory>
#include <random>
#include <vector>

using namespace odo;
using namespace std::chrono_literals;

namespace {

const QByteArray get = "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n";
const QByteArray listening = "GET /events HTTP/1.1\r\nHost: localhost\r\n\r\n";

WebReply answerOfTest(const WebRequest &request)
{
    if (request.path == "/events")
        return {WebStatus::Ok, {}, "first", "en"};
    if (request.path == "/large")
        return {WebStatus::Ok, "text/plain", QByteArray(200'000, 'x')};
    return request.path == "/" ? WebReply{WebStatus::Ok, "text/html", "page"}
                               : WebReply{WebStatus::NotFound, {}, {}};
}

/// Somebody who sends bytes and keeps what comes back.
struct RawClient
{
    explicit RawClient(const WebServer &server, const QByteArray &bytes = {})
    {
        QObject::connect(&socket, &QTcpSocket::readyRead, &socket, [this] {
            if (isReading)
                got += socket.readAll();
        });
        socket.connectToHost(server.address(), server.port());
        socket.write(bytes);
    }
    bool isEnded() const { return socket.state() == QAbstractSocket::UnconnectedState; }
    bool isAnswered(int status) const
    {
        return got.startsWith("HTTP/1.1 " + QByteArray::number(status) + ' ');
    }

    /// Takes no more from the system until read() is called.
    void pause()
    {
        isReading = false;
        socket.setReadBufferSize(1000);
    }
    void read()
    {
        isReading = true;
        socket.setReadBufferSize(0);
        got += socket.readAll();
    }

    QByteArray got;
    bool isReading = true;
    QTcpSocket socket;
};

/// Memory of this program that is its own, in megabytes.
double residentMegabytes()
{
    QFile file(QStringLiteral("/proc/self/status"));
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    const QByteArray text = file.readAll();
    return text.mid(text.indexOf("RssAnon:") + 8).simplified().split(' ').front().toDouble() / 1024;
}

} // namespace

class TestWebServer : public QObject
{
    Q_OBJECT

    std::unique_ptr<WebServer> m_server;

    void begin(const WebLimits &limits = {})
    {
        m_server = std::make_unique<WebServer>(answerOfTest, limits);
        const auto listening = m_server->listen(QHostAddress(QHostAddress::LocalHost), 0);
        QVERIFY2(listening, listening ? "" : listening.error().message().c_str());
    }

private Q_SLOTS:
    void cleanup() { m_server.reset(); }

    void aPageIsAnsweredAndTheConnectionEnds()
    {
        begin();
        RawClient client(*m_server, get);
        QTRY_VERIFY(client.isEnded());
        QVERIFY2(client.isAnswered(200), client.got);
        QVERIFY(client.got.endsWith("\r\n\r\npage"));
        for (const char *field :
             {"Content-Security-Policy: default-src 'none'; script-src 'self'",
              "X-Content-Type-Options: nosniff", "Content-Length: 4", "Connection: close"})
            QVERIFY2(client.got.contains(field), field);
        QTRY_COMPARE(m_server->clientCount(), 0);
    }

    void aRequestMayComeByteByByte()
    {
        begin();
        RawClient client(*m_server);
        QTRY_COMPARE(client.socket.state(), QAbstractSocket::ConnectedState);
        for (const char c : get) {
            client.socket.write(&c, 1);
            client.socket.flush();
            QCoreApplication::processEvents();
        }
        QTRY_VERIFY(client.isEnded());
        QVERIFY(client.isAnswered(200));
    }

    void largeAnswersArriveWhole()
    {
        begin();
        RawClient client(*m_server, "GET /large HTTP/1.1\r\nHost: [::1]:1\r\n\r\n");
        QTRY_VERIFY(client.isEnded());
        QCOMPARE(client.got.size() - client.got.indexOf("\r\n\r\n") - 4, 200'000);
    }

    void whatIsRefusedSaysWhy_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("status");
        QTest::newRow("not there") << QByteArray("GET /a HTTP/1.1\r\nHost: localhost\r\n\r\n") << 404;
        QTest::newRow("post") << QByteArray("POST / HTTP/1.1\r\nHost: localhost\r\n\r\nabc") << 405;
        QTest::newRow("another name") << QByteArray("GET / HTTP/1.1\r\nHost: example.org\r\n\r\n") << 421;
        QTest::newRow("garbage") << QByteArray("\r\n\r\n\0\xff", 6) << 400;
        QTest::newRow("endless header")
            << QByteArray("GET / HTTP/1.1\r\nHost: a\r\nA: " + QByteArray(100'000, 'a')) << 431;
    }
    void whatIsRefusedSaysWhy()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(int, status);
        begin();
        RawClient client(*m_server, bytes);
        QTRY_VERIFY(client.isEnded());
        QVERIFY2(client.isAnswered(status), client.got);
        QCOMPARE(client.got.contains("Allow: GET\r\n"), status == 405);
        QVERIFY(client.got.contains("Content-Security-Policy: "));
        QTRY_COMPARE(m_server->clientCount(), 0);
    }

    void aStreamGetsWhatIsSentToItsChannel()
    {
        begin();
        RawClient client(*m_server, listening), another(*m_server, get);
        QTRY_VERIFY(client.got.endsWith("data: first\n\n"));
        QVERIFY(client.got.contains("Content-Type: text/event-stream\r\n"));
        QVERIFY(!client.got.contains("Content-Length"));
        QCOMPARE(m_server->channels(), QList<QByteArray>{"en"});
        m_server->send("de", "Hallo");
        m_server->send("en", "hello");
        QTRY_VERIFY(client.got.endsWith("data: hello\n\n"));
        QVERIFY(!client.got.contains("Hallo"));
        QVERIFY(!client.isEnded());
        client.socket.abort();
        QTRY_COMPARE(m_server->channels(), QList<QByteArray>());
    }

    void aStreamIsKeptAliveByComments()
    {
        WebLimits limits;
        limits.heartbeat = 1ms;
        begin(limits);
        RawClient client(*m_server, listening);
        QTRY_VERIFY(client.got.endsWith("data: first\n\n:\n\n"));
    }

    /// Messages do not pile up for who does not read: the newest is sent when there is room.
    void aSlowStreamGetsTheNewestMessage()
    {
        begin();
        RawClient client(*m_server, listening);
        QTRY_VERIFY(client.got.endsWith("data: first\n\n"));
        client.pause();
        const QByteArray large(1'000'000, 'x');
        const double before = residentMegabytes();
        for (int i = 0; i < 300; ++i) {
            m_server->send("en", QByteArray::number(i) + large);
            if (i % 10 == 0)
                QCoreApplication::processEvents();
        }
        QVERIFY2(residentMegabytes() - before < 60,
                 qPrintable(QString::number(residentMegabytes() - before)));
        m_server->send("en", "newest");
        client.read();
        QTRY_VERIFY(client.got.endsWith("data: newest\n\n"));
        QVERIFY(client.got.size() < 100'000'000);
    }

    void whoDoesNotReadAtAllIsLeft()
    {
        WebLimits limits;
        limits.stalled = 1ms;
        begin(limits);
        RawClient client(*m_server, listening);
        QTRY_VERIFY(client.got.endsWith("data: first\n\n"));
        client.pause();
        m_server->send("en", QByteArray(20'000'000, 'x'));
        QTRY_COMPARE(m_server->clientCount(), 0);
    }

    void whoSaysNothingIsLeft()
    {
        WebLimits limits;
        limits.request = 1ms;
        begin(limits);
        RawClient silent(*m_server), halfway(*m_server, "GET / HTTP/1.1\r\n");
        QTRY_VERIFY(silent.isEnded() && halfway.isEnded());
        QVERIFY2(halfway.isAnswered(408), halfway.got);
        QTRY_COMPARE(m_server->clientCount(), 0);
    }

    void moreClientsThanAllowedAreRefused()
    {
        WebLimits limits;
        limits.clients = 3;
        begin(limits);
        std::vector<std::unique_ptr<RawClient>> clients;
        for (int i = 0; i < 3; ++i)
            clients.push_back(std::make_unique<RawClient>(*m_server, listening));
        for (const auto &client : clients)
            QTRY_VERIFY(client->got.endsWith("data: first\n\n"));
        RawClient refused(*m_server, get);
        QTRY_VERIFY(refused.isEnded());
        QVERIFY2(refused.isAnswered(503), refused.got);
        QVERIFY(refused.got.contains("Retry-After: "));
        clients.pop_back();
        QTRY_VERIFY(m_server->clientCount() < 3);
        RawClient served(*m_server, get);
        QTRY_VERIFY(served.isEnded());
        QVERIFY(served.isAnswered(200));
    }

    /// No end of connections: the rest is closed without a word.
    void aFloodIsClosed()
    {
        WebLimits limits;
        limits.clients = 2;
        begin(limits);
        std::vector<std::unique_ptr<RawClient>> clients;
        for (int i = 0; i < 150; ++i)
            clients.push_back(std::make_unique<RawClient>(*m_server));
        QTRY_VERIFY(std::ranges::all_of(clients.begin() + 2, clients.end(),
                                        [](const auto &each) { return each->isEnded(); }));
        QVERIFY(m_server->clientCount() <= 2);
    }

    void requestsChangedAtRandomDoNoHarm()
    {
        begin();
        std::mt19937 random(39);
        constexpr int batches = 100, each = 100; // 10,000
        for (int batch = 0; batch < batches; ++batch) {
            std::vector<std::unique_ptr<RawClient>> clients;
            for (int i = 0; i < each; ++i) {
                QByteArray bytes = get;
                for (int times = 0; times < 3; ++times)
                    bytes[qsizetype(random() % std::size_t(bytes.size()))] = char(random() % 256);
                bytes.truncate(qsizetype(random() % std::size_t(2 * bytes.size())));
                clients.push_back(std::make_unique<RawClient>(*m_server, bytes));
                clients.back()->socket.disconnectFromHost(); // when it is sent
            }
            QTRY_VERIFY(std::ranges::all_of(clients, [](const auto &one) { return one->isEnded(); }));
        }
        QTRY_COMPARE(m_server->clientCount(), 0);
        RawClient client(*m_server, get);
        QTRY_VERIFY(client.isEnded());
        QVERIFY(client.isAnswered(200));
    }

    void whatCannotBeListenedTo()
    {
        begin();
        WebServer second(answerOfTest);
        const auto inUse = second.listen(QHostAddress(QHostAddress::LocalHost), m_server->port());
        QCOMPARE(inUse.error().code, ErrorCode::Unavailable);
        QVERIFY(inUse.error().message().find("another program uses this port; choose another port") !=
                std::string::npos);
        const auto elsewhere = second.listen(QHostAddress(QStringLiteral("203.0.113.7")), 0);
        QCOMPARE(elsewhere.error().code, ErrorCode::NotFound);
        QVERIFY(elsewhere.error().message().find("it is no address of this computer") != std::string::npos);
    }

    /// 200 clients with a stream each, a message a second: all get all, and memory stays. As a long test for
    /// a minute.
    void manyClientsForLong()
    {
        begin();
        constexpr int clientCount = 200;
        const int seconds = qEnvironmentVariableIntValue("ODOGRAPH_STREAM_SECONDS");
        const int messages = seconds > 0 ? seconds : 2;
        std::vector<std::unique_ptr<RawClient>> clients;
        for (int i = 0; i < clientCount; ++i)
            clients.push_back(std::make_unique<RawClient>(*m_server, listening));
        const auto allHave = [&clients](const QByteArray &end) {
            return std::ranges::all_of(clients, [&](const auto &each) { return each->got.endsWith(end); });
        };
        QTRY_VERIFY(allHave("data: first\n\n"));
        QTRY_COMPARE(m_server->clientCount(), clientCount);
        const double before = residentMegabytes();
        qint64 slowestMs = 0;
        for (int i = 0; i < messages; ++i) {
            for (const auto &client : clients)
                client->got.clear();
            QElapsedTimer timer;
            timer.start();
            const QByteArray message = QByteArray::number(i) + QByteArray(4000, 'x');
            m_server->send("en", message);
            QTRY_VERIFY(allHave("data: " + message + "\n\n"));
            slowestMs = std::max(slowestMs, timer.elapsed());
            if (seconds > 0) {
                QTimer pause;
                pause.setSingleShot(true);
                pause.start(std::max<qint64>(0, 1000 - timer.elapsed()));
                QTRY_VERIFY(!pause.isActive());
            }
        }
        const double grown = residentMegabytes() - before;
        qInfo("%d clients, %d messages: slowest %lld ms, memory %+.1f MB", clientCount, messages,
              static_cast<long long>(slowestMs), grown);
        QVERIFY2(grown < 20, qPrintable(QString::number(grown)));
        QVERIFY(slowestMs < 1000 * test::slowness);
    }
};

ODOGRAPH_TEST(TestWebServer, QCoreApplication)
#include "tst_web_server.moc"
