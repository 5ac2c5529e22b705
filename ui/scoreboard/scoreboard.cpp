// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoreboard/scoreboard.h"

#include "core/project/project.h"
#include "resources/resources.h"
#include "ui/models/shown_names.h"
#include "ui/report/run_map.h"
#include "ui/scoreboard/internal/board_page.h"
#include "ui/scoreboard/internal/web_server.h"

#include <QJsonDocument>
#include <QNetworkInterface>
#include <QTimer>
#include <QUrl>
#include <utility>

namespace odo {

namespace {

/// How often others' changes are asked for: a change is on the page within a second, with time to spare.
constexpr std::chrono::milliseconds followInterval{200};

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
    Parts(std::unique_ptr<Project> ofProject, const StandingsChoice &choice)
        : project(std::move(ofProject)), reader(*project, choice),
          server([this](const WebRequest &request) { return reply(request); })
    {
    }

    WebReply reply(const WebRequest &request) const;
    QByteArray message(const BoardLanguage &language) const
    {
        return QJsonDocument(boardState(content, language, instantNow())).toJson(QJsonDocument::Compact);
    }
    /// Whether anything else is shown now.
    bool take(BoardContent newest);

    const std::unique_ptr<Project> project;
    BoardReader reader;
    const BoardLanguages languages;
    WebServer server;
    QTimer timer;
    BoardContent content;
    QJsonObject shown; ///< in one language, without what goes on by itself
    bool withPseudonyms = arePseudonymsShown();
};

bool Scoreboard::Parts::take(BoardContent newest)
{
    content = std::move(newest);
    withPseudonyms = arePseudonymsShown();
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
    auto parts = std::make_unique<Parts>(std::move(project), settings.choice);
    auto content = ODO_TRY(parts->reader.read());
    parts->take(std::move(content));
    ODO_TRY(parts->server.listen(settings.address, settings.port));
    return std::unique_ptr<Scoreboard>(new Scoreboard(std::move(parts)));
}

Scoreboard::Scoreboard(std::unique_ptr<Parts> parts) : m_parts(std::move(parts))
{
    connect(&m_parts->timer, &QTimer::timeout, this, &Scoreboard::follow);
    m_parts->timer.start(followInterval);
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

void Scoreboard::follow()
{
    if (!m_parts->project->isInPlace()) {
        m_parts->timer.stop();
        Q_EMIT ended(
            fail(ErrorCode::Io, fileSubject(m_parts->project->file()),
                 ODO_TEXT("ui.scoreboard_project_gone", "it was moved or deleted, so the standings ended"),
                 ODO_TEXT("ui.scoreboard_start_again", "start them with the file's present name"))
                .value());
        return;
    }
    if (!m_parts->reader.hasChanged() && m_parts->withPseudonyms == arePseudonymsShown())
        return;
    Result<BoardContent> content = m_parts->reader.read();
    if (!content && content.error().code != ErrorCode::NotFound)
        return; // busy, or the disk fails: read at the next look
    BoardContent newest = content ? std::move(*content) : m_parts->content;
    newest.problem = content ? std::nullopt : std::optional(content.error());
    if (m_parts->take(std::move(newest)))
        publish();
}

void Scoreboard::publish()
{
    const QList<QByteArray> channels = m_parts->server.channels();
    for (const QByteArray &tag : channels)
        if (const BoardLanguage *language = m_parts->languages.find(tag))
            m_parts->server.send(tag, m_parts->message(*language));
}

} // namespace odo
