// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/scoreboard/internal/web_request.h"

#include <QHash>
#include <QHostAddress>
#include <QObject>
#include <QTcpServer>
#include <QTimer>
#include <chrono>
#include <functional>

namespace odo {

class WebClient;

/// What a request is answered with.
struct WebReply
{
    WebStatus status = WebStatus::Ok;
    QByteArray type; ///< "text/html; charset=utf-8"; of a stream nothing
    QByteArray body; ///< of a stream its first message
    QByteArray channel =
        {}; ///< not empty: a stream of events, which goes on with what is sent to this channel
};

/// What a server allows at most.
struct WebLimits
{
    int clients = 500;                           ///< connections at once
    std::chrono::milliseconds request{10'000};   ///< to send a request and to take its answer
    std::chrono::milliseconds stalled{30'000};   ///< of a stream, to take a message
    std::chrono::milliseconds heartbeat{15'000}; ///< of a stream without any message
};

/// A small web server for the page of the standings: GET alone, each answer on a connection of its own, and
/// streams of server-sent events (HTML, 9.2). It takes no content, sends a strict content-security policy
/// with each answer, and holds for each client one request of 8 KiB and one message at most: who reads too
/// slowly gets the newest message when the one before is gone.
///
/// Ours, and not Qt HTTP Server: that of Qt 6.4 keeps requests of any size (300 MB took it 300 MB) and any
/// number of silent connections for good, and leaves events to the bare socket (docs/scoreboard.md). On one
/// thread, with an event loop.
class WebServer : public QObject
{
    Q_OBJECT
public:
    using Answer = std::function<WebReply(const WebRequest &)>;

    explicit WebServer(Answer answer, WebLimits limits = {}, QObject *parent = nullptr);
    ~WebServer() override;

    /// port 0: any that is free. Errors, with what to do: Unavailable where the port is in use or may not be
    /// taken, NotFound where the address is none of this computer's.
    Result<void> listen(const QHostAddress &address, quint16 port);
    QHostAddress address() const { return m_server.serverAddress(); }
    quint16 port() const { return m_server.serverPort(); }

    /// Sends a message to all streams of a channel.
    void send(const QByteArray &channel, const QByteArray &message);
    /// The channels that somebody listens to.
    QList<QByteArray> channels() const;
    int clientCount() const { return int(m_clients.size()); }

private:
    friend class WebClient;
    void accept();
    WebReply reply(const WebRequest &request) const;
    QByteArray newest(const QByteArray &channel) const { return m_newest.value(channel); }
    void sweep();

    const Answer m_answer;
    const WebLimits m_limits;
    QTcpServer m_server;
    QTimer m_sweep;
    QList<WebClient *> m_clients;
    QHash<QByteArray, QByteArray> m_newest; ///< message of each channel
};

} // namespace odo
