// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocalSocket>
#include <QString>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>
#include <chrono>
#include <functional>
#include <utility>

namespace odo::test {

/// What befalls a connection each time that so many bytes went through it, either way.
struct Fault
{
    /// Silence: nothing goes through any more, and the connection stays.
    enum class Kind { None, Cut, Stall, StallAndCut, Silence } kind = Kind::None;
    qint64 afterBytes = 0;
    std::chrono::milliseconds delay{0}; ///< of each piece, from the beginning
    QByteArray atAnswer = {};           ///< cut where the server answers this again; empty: nowhere
};

/// One connection between a program and the server.
class Link : public QObject
{
public:
    Link(QTcpSocket *program, const QString &server, const Fault &fault, int &befallen, QObject *parent)
        : QObject(parent), m_program(program), m_fault(fault), m_befallen(befallen)
    {
        program->setParent(this);
        m_server.connectToServer(server);
        QObject::connect(program, &QIODevice::readyRead, this, [this] { take(*m_program, m_server); });
        QObject::connect(&m_server, &QIODevice::readyRead, this, [this] { take(m_server, *m_program); });
        QObject::connect(program, &QTcpSocket::disconnected, this, [this] { cut(); });
        QObject::connect(&m_server, &QLocalSocket::disconnected, this,
                         [this] { m_program->disconnectFromHost(); });
    }

private:
    void take(QIODevice &from, QIODevice &to)
    {
        if (m_isStalled)
            return; // it stays in the socket
        const QByteArray bytes = from.readAll();
        m_passed += bytes.size();
        if (!m_fault.atAnswer.isEmpty() && &from == &m_server && bytes.contains(m_fault.atAnswer) &&
            ++m_answers == 2) {
            ++m_befallen;
            return cut();
        }
        if (m_fault.kind != Fault::Kind::None && m_passed > m_fault.afterBytes)
            return befall(bytes, to);
        QTimer::singleShot(m_fault.delay, this, [bytes, &to] {
            if (to.isOpen())
                to.write(bytes);
        });
    }
    void befall(const QByteArray &bytes, QIODevice &to)
    {
        constexpr std::chrono::milliseconds stall{400};
        const Fault::Kind kind = m_fault.kind;
        m_passed = 0; // it befalls it again
        ++m_befallen;
        if (kind == Fault::Kind::Cut)
            return cut();
        m_isStalled = true;
        if (kind == Fault::Kind::Silence)
            return;
        QTimer::singleShot(stall, this, [this, kind, bytes, &to] {
            m_isStalled = false;
            if (kind == Fault::Kind::StallAndCut || !to.isOpen())
                return cut();
            to.write(bytes);
            take(*m_program, m_server);
            take(m_server, *m_program);
        });
    }
    void cut()
    {
        m_program->abort();
        m_server.abort();
        deleteLater();
    }

    QTcpSocket *m_program;
    QLocalSocket m_server;
    Fault m_fault;
    int &m_befallen;
    qint64 m_passed = 0;
    int m_answers = 0; ///< as the fault waits for
    bool m_isStalled = false;
};

/// Between programs and the socket of a server, as long as its thread handles events.
class BadNetwork : public QTcpServer
{
public:
    explicit BadNetwork(QString server) : m_server(std::move(server))
    {
        QObject::connect(this, &QTcpServer::newConnection, this, [this] {
            while (QTcpSocket *program = nextPendingConnection())
                new Link(program, m_server, next ? next() : Fault(), befallen, this);
        });
        listen(QHostAddress::LocalHost);
    }

    std::function<Fault()> next; ///< what befalls the next connection
    int befallen = 0;            ///< how often any fault did

private:
    const QString m_server;
};

} // namespace odo::test
