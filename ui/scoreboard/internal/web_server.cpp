// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoreboard/internal/web_server.h"

#include <QElapsedTimer>
#include <QTcpSocket>
#include <utility>

namespace odo {

namespace {

using std::chrono::milliseconds;

/// Beyond the clients that are served, so many get a sentence; others nothing at all.
constexpr int mostRefusals = 50;
constexpr milliseconds sweepInterval{500};
/// How long what a refused client still sends is thrown away, so that it can read why.
constexpr milliseconds lingering{1000};

QByteArray headOf(WebStatus status)
{
    QByteArray head = "HTTP/1.1 " + statusLine(status) +
                      "\r\n"
                      "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; "
                      "connect-src 'self'; img-src 'self'; base-uri 'none'; form-action 'none'; "
                      "frame-ancestors 'none'\r\n"
                      "X-Content-Type-Options: nosniff\r\n"
                      "Referrer-Policy: no-referrer\r\n"
                      "Cross-Origin-Resource-Policy: same-origin\r\n"
                      "Cache-Control: no-store\r\n"
                      "Connection: close\r\n";
    if (status == WebStatus::MethodNotAllowed)
        head += "Allow: GET\r\n";
    if (status == WebStatus::Unavailable)
        head += "Retry-After: 5\r\n";
    return head;
}

/// A whole answer.
QByteArray answerOf(const WebReply &reply)
{
    return headOf(reply.status) + "Content-Type: " + reply.type +
           "\r\nVary: Accept-Language\r\nContent-Length: " + QByteArray::number(reply.body.size()) +
           "\r\n\r\n" + reply.body;
}

QByteArray refusalOf(WebStatus status)
{
    return answerOf({status, "text/plain; charset=utf-8", statusLine(status) + '\n'});
}

/// A message as a server-sent event. It has no line breaks.
QByteArray eventOf(const QByteArray &message)
{
    return "data: " + message + "\n\n";
}

} // namespace

/// One connection: reads a request, answers it, and ends, or goes on as a stream.
class WebClient : public QObject
{
public:
    WebClient(QTcpSocket *socket, WebServer &server);

    void refuse(WebStatus status);
    void send(const QByteArray &message);
    void sweep();
    const QByteArray &channel() const { return m_channel; }

private:
    void read();
    void answer(const WebRequest &request);
    void goOn();

    WebServer &m_server;
    QTcpSocket *m_socket;
    QByteArray m_request;
    QByteArray m_channel; ///< of a stream
    bool m_isRefused = false, m_isBehind = false;
    QElapsedTimer m_age, m_sent; ///< since it came, since the last message
};

WebClient::WebClient(QTcpSocket *socket, WebServer &server)
    : QObject(&server), m_server(server), m_socket(socket)
{
    m_socket->setParent(this);
    m_socket->setReadBufferSize(longestRequest + 1);
    m_age.start();
    connect(m_socket, &QTcpSocket::readyRead, this, &WebClient::read);
    connect(m_socket, &QTcpSocket::bytesWritten, this, &WebClient::goOn);
    connect(m_socket, &QTcpSocket::disconnected, this, [this] {
        m_server.m_clients.removeOne(this);
        deleteLater();
    });
}

void WebClient::read()
{
    const QByteArray more = m_socket->readAll();
    if (m_isRefused || !m_channel.isEmpty() || m_socket->state() != QAbstractSocket::ConnectedState)
        return; // nothing that comes after a request is heard
    m_request += more;
    RequestReading reading = readRequest(m_request);
    if (reading.state == RequestReading::State::Refused)
        refuse(reading.refusal);
    else if (reading.state == RequestReading::State::Complete)
        answer(reading.request);
}

void WebClient::refuse(WebStatus status)
{
    m_isRefused = true;
    m_age.restart();
    m_request.clear();
    m_socket->write(refusalOf(status));
}

void WebClient::answer(const WebRequest &request)
{
    m_request.clear();
    const WebReply reply = m_server.reply(request);
    if (reply.status != WebStatus::Ok)
        return refuse(reply.status);
    if (reply.channel.isEmpty()) {
        m_socket->write(answerOf(reply));
        m_socket->disconnectFromHost();
        return;
    }
    m_channel = reply.channel;
    m_socket->write(headOf(WebStatus::Ok) + "Content-Type: text/event-stream\r\n\r\nretry: 1000\n\n");
    m_sent.start();
    m_socket->write(eventOf(reply.body));
}

void WebClient::send(const QByteArray &message)
{
    m_isBehind = m_socket->bytesToWrite() > 0;
    if (m_isBehind)
        return;
    m_sent.restart();
    m_socket->write(eventOf(message));
}

/// The message that came while the one before was on its way.
void WebClient::goOn()
{
    if (m_isBehind && m_socket->bytesToWrite() == 0)
        send(m_server.newest(m_channel));
}

/// Ends what takes too long. May delete this, later.
void WebClient::sweep()
{
    const WebLimits &limits = m_server.m_limits;
    if (m_isRefused) {
        if (m_age.hasExpired(lingering.count()))
            m_socket->abort();
    } else if (m_channel.isEmpty()) {
        if (!m_age.hasExpired(limits.request.count()))
            return;
        if (m_socket->state() == QAbstractSocket::ConnectedState)
            refuse(WebStatus::RequestTimeout);
        else
            m_socket->abort(); // which takes too long to receive its answer
    } else if (m_socket->bytesToWrite() > 0) {
        if (m_sent.hasExpired(limits.stalled.count()))
            m_socket->abort();
    } else if (m_sent.hasExpired(limits.heartbeat.count())) {
        m_sent.restart();
        m_socket->write(":\n\n"); // a comment: whoever is gone without a word shows by it
    }
}

WebServer::WebServer(Answer answer, WebLimits limits, QObject *parent)
    : QObject(parent), m_answer(std::move(answer)), m_limits(limits)
{
    connect(&m_server, &QTcpServer::newConnection, this, &WebServer::accept);
    connect(&m_sweep, &QTimer::timeout, this, &WebServer::sweep);
    m_sweep.start(sweepInterval);
}

WebServer::~WebServer()
{
    qDeleteAll(std::exchange(m_clients, {}));
}

namespace {

Message chooseAnotherPort()
{
    return ODO_TEXT("ui.choose_another_port", "choose another port, or 0 for any that is free");
}

} // namespace

Result<void> WebServer::listen(const QHostAddress &address, quint16 port)
{
    m_server.setListenBacklogSize(256);
    if (m_server.listen(address, port))
        return {};
    const Message what =
        ODO_TEXT("ui.scoreboard_address", "standings at %1 port %2")(address.toString().toStdString(), port);
    switch (m_server.serverError()) {
    case QAbstractSocket::AddressInUseError:
        return fail(ErrorCode::Unavailable, what,
                    ODO_TEXT("ui.port_in_use", "another program uses this port"), chooseAnotherPort());
    case QAbstractSocket::SocketAddressNotAvailableError:
        return fail(ErrorCode::NotFound, what,
                    ODO_TEXT("ui.address_not_here", "it is no address of this computer"),
                    ODO_TEXT("ui.choose_own_address", "choose 127.0.0.1, an address of this computer, or "
                                                      "0.0.0.0 for all of them"));
    case QAbstractSocket::SocketAccessError:
        return fail(ErrorCode::Unavailable, what,
                    ODO_TEXT("ui.port_not_allowed", "the system does not allow this port"),
                    ODO_TEXT("ui.choose_high_port", "choose a port of 1024 or more"));
    default:
        return fail(ErrorCode::Unavailable, what, foreignWords(m_server.errorString().toStdString()),
                    chooseAnotherPort());
    }
}

void WebServer::accept()
{
    while (QTcpSocket *socket = m_server.nextPendingConnection()) {
        const int clients = clientCount();
        if (clients >= m_limits.clients + mostRefusals) {
            socket->abort();
            socket->deleteLater();
            continue;
        }
        auto *client = new WebClient(socket, *this);
        m_clients.append(client);
        if (clients >= m_limits.clients)
            client->refuse(WebStatus::Unavailable);
    }
}

/// A page of another site could have its own name lead to this computer and read what only this one may see
/// (DNS rebinding): by the loopback, a request must name an address, or "localhost".
WebReply WebServer::reply(const WebRequest &request) const
{
    if (address().isLoopback() && !request.host.isEmpty() && request.host != "localhost") {
        QByteArray host = request.host;
        if (host.startsWith('[') && host.endsWith(']'))
            host = host.sliced(1, host.size() - 2);
        if (QHostAddress(QString::fromLatin1(host)).isNull())
            return {WebStatus::Misdirected, {}, {}};
    }
    return m_answer(request);
}

void WebServer::send(const QByteArray &channel, const QByteArray &message)
{
    m_newest[channel] = message;
    for (WebClient *client : std::as_const(m_clients))
        if (client->channel() == channel)
            client->send(message);
}

QList<QByteArray> WebServer::channels() const
{
    QList<QByteArray> all;
    for (const WebClient *client : m_clients)
        if (!client->channel().isEmpty() && !all.contains(client->channel()))
            all << client->channel();
    return all;
}

void WebServer::sweep()
{
    const QList<WebClient *> clients = m_clients; // ends of connections change the list
    for (WebClient *client : clients)
        client->sweep();
}

} // namespace odo
