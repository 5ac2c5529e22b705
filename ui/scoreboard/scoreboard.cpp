// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoreboard/scoreboard.h"

#include "core/project/project.h"
#include "resources/resources.h"
#include "ui/report/run_map.h"
#include "ui/scoreboard/internal/board_page.h"
#include "ui/scoreboard/internal/hub_source.h"
#include "ui/scoreboard/internal/project_source.h"
#include "ui/scoreboard/internal/web_server.h"

#include <QJsonDocument>
#include <QNetworkInterface>
#include <QUrl>
#include <utility>

namespace odo {

namespace {

/// The address by which others reach this computer; the loopback where there is no network.
QHostAddress reachableAddress(const QHostAddress &listening)
{
    const bool isAny = listening == QHostAddress(QHostAddress::AnyIPv4) ||
                       listening == QHostAddress(QHostAddress::AnyIPv6) ||
                       listening == QHostAddress(QHostAddress::Any);
    if (!isAny)
        return listening;
    const QList<QHostAddress> addresses = QNetworkInterface::allAddresses();
    for (const QHostAddress &address : addresses)
        if (address.protocol() == QAbstractSocket::IPv4Protocol && address.isGlobal())
            return address;
    return QHostAddress(QHostAddress::LocalHost);
}

} // namespace

struct Scoreboard::Parts
{
    explicit Parts(std::unique_ptr<BoardSource> itsSource)
        : source(std::move(itsSource)), server([this](const WebRequest &request) { return reply(request); })
    {
    }

    WebReply reply(const WebRequest &request) const;
    QByteArray message(const BoardLanguage &language) const
    {
        return QJsonDocument(boardState(content, language, instantNow())).toJson(QJsonDocument::Compact);
    }
    /// Whether anything else is shown now.
    bool take(BoardContent newest);

    const std::unique_ptr<BoardSource> source;
    const BoardLanguages languages;
    WebServer server;
    BoardContent content;
    QJsonObject shown; ///< in one language, without what goes on by itself
};

bool Scoreboard::Parts::take(BoardContent newest)
{
    content = std::move(newest);
    QJsonObject state =
        boardState(content, languages.preferred({}), content.running ? content.running->since : Instant());
    if (state == shown)
        return false;
    shown = std::move(state);
    return true;
}

WebReply Scoreboard::Parts::reply(const WebRequest &request) const
{
    static const QByteArray html = "text/html; charset=utf-8";
    const BoardLanguage &language = languages.preferred(request.language);
    if (request.path == "/")
        return {WebStatus::Ok, html, boardPage(language)};
    if (request.path == "/events")
        return {WebStatus::Ok, {}, message(language), language.tag()};
    if (request.path == "/map")
        return {WebStatus::Ok, html, boardMap(content, language)};
    if (request.path == "/scoreboard.css")
        return {WebStatus::Ok, "text/css; charset=utf-8",
                drawingStyle().toUtf8() + resourceBytes(QStringLiteral("scoreboard/scoreboard.css"))};
    if (request.path == "/scoreboard.js")
        return {WebStatus::Ok, "text/javascript; charset=utf-8",
                resourceBytes(QStringLiteral("scoreboard/scoreboard.js"))};
    if (request.path == "/icon.svg")
        return {WebStatus::Ok, "image/svg+xml", resourceBytes(QStringLiteral("icons/odograph.svg"))};
    return {WebStatus::NotFound, {}, {}};
}

Result<std::unique_ptr<Scoreboard>> Scoreboard::start(std::unique_ptr<Project> project,
                                                      const ScoreboardSettings &settings)
{
    return serve(std::make_unique<ProjectSource>(std::move(project), settings.choice), settings);
}

Result<std::unique_ptr<Scoreboard>> Scoreboard::start(const HubAddress &hub,
                                                      const ScoreboardSettings &settings)
{
    return serve(std::make_unique<HubSource>(hub, settings.choice), settings);
}

Result<std::unique_ptr<Scoreboard>> Scoreboard::serve(std::unique_ptr<BoardSource> source,
                                                      const ScoreboardSettings &settings)
{
    auto parts = std::make_unique<Parts>(std::move(source));
    auto content = ODO_TRY(parts->source->begin());
    parts->take(std::move(content));
    ODO_TRY(parts->server.listen(settings.address, settings.port));
    return std::unique_ptr<Scoreboard>(new Scoreboard(std::move(parts)));
}

Scoreboard::Scoreboard(std::unique_ptr<Parts> parts) : m_parts(std::move(parts))
{
    connect(m_parts->source.get(), &BoardSource::read, this, [this](const BoardContent &content) {
        if (m_parts->take(content))
            publish();
    });
    connect(m_parts->source.get(), &BoardSource::ended, this, &Scoreboard::ended);
}

Scoreboard::~Scoreboard() = default;

QHostAddress Scoreboard::address() const
{
    return m_parts->server.address();
}

quint16 Scoreboard::port() const
{
    return m_parts->server.port();
}

QString Scoreboard::url() const
{
    QUrl url;
    url.setScheme(QStringLiteral("http"));
    url.setHost(reachableAddress(address()).toString());
    url.setPort(port());
    url.setPath(QStringLiteral("/"));
    return url.toString();
}

const StandingsChoice &Scoreboard::choice() const
{
    return m_parts->content.reading.standings.choice;
}

void Scoreboard::publish()
{
    const QList<QByteArray> channels = m_parts->server.channels();
    for (const QByteArray &tag : channels)
        if (const BoardLanguage *language = m_parts->languages.find(tag))
            m_parts->server.send(tag, m_parts->message(*language));
}

} // namespace odo
