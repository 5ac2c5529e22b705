// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoreboard/internal/web_request.h"

#include <QList>
#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

namespace odo {

namespace {

RequestReading refused(WebStatus status)
{
    return {RequestReading::State::Refused, {}, status};
}

/// A character of a method's or field's name (RFC 9110, 5.6.2).
bool isTokenCharacter(char c)
{
    const bool isLetterOrDigit = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    return isLetterOrDigit || (c != '\0' && std::strchr("!#$%&'*+-.^_`|~", c) != nullptr);
}

bool isToken(QByteArrayView text)
{
    return !text.isEmpty() && std::all_of(text.begin(), text.end(), isTokenCharacter);
}

bool isPlain(QByteArrayView text, bool withBlanks)
{
    return std::all_of(text.begin(), text.end(), [withBlanks](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return withBlanks ? byte == '\t' || (byte >= 0x20 && byte != 0x7f) : byte > 0x20 && byte < 0x7f;
    });
}

/// "127.0.0.1:8080" without its port; nullopt where it is no host.
std::optional<QByteArray> hostAlone(QByteArrayView field)
{
    qsizetype end = field.startsWith('[') ? field.indexOf(']') + 1 : field.indexOf(':');
    if (end < 0)
        end = field.size();
    const QByteArrayView host = field.first(end), port = field.sliced(end);
    const bool isPort =
        port.isEmpty() || (port.front() == ':' && std::all_of(port.begin() + 1, port.end(),
                                                              [](char c) { return c >= '0' && c <= '9'; }));
    const bool isName = !host.isEmpty() && std::all_of(host.begin(), host.end(), [](char c) {
        return isTokenCharacter(c) || c == '[' || c == ']' || c == ':';
    });
    return isPort && isName ? std::optional(host.toByteArray().toLower()) : std::nullopt;
}

std::optional<WebStatus> readFirstLine(QByteArrayView line, WebRequest &request)
{
    const qsizetype first = line.indexOf(' '), last = line.lastIndexOf(' ');
    if (first <= 0 || last <= first)
        return WebStatus::BadRequest;
    const QByteArrayView method = line.first(first), target = line.sliced(first + 1, last - first - 1),
                         version = line.sliced(last + 1);
    if (!isToken(method) || !isPlain(target, false))
        return WebStatus::BadRequest;
    const bool isVersion = version.size() == 8 && version.startsWith("HTTP/") && version[5] >= '0' &&
                           version[5] <= '9' && version[6] == '.' && version[7] >= '0' && version[7] <= '9';
    if (!isVersion)
        return WebStatus::BadRequest;
    if (version[5] != '1')
        return WebStatus::VersionNotSupported;
    if (method != QByteArrayView("GET"))
        return WebStatus::MethodNotAllowed;
    if (target.isEmpty() || target.front() != '/')
        return WebStatus::BadRequest;
    const qsizetype query = target.indexOf('?');
    request.path = (query < 0 ? target : target.first(query)).toByteArray();
    return std::nullopt;
}

/// Whether it says that content follows, which no GET of a page has.
bool announcesContent(QByteArrayView name, QByteArrayView value)
{
    return name.compare("transfer-encoding", Qt::CaseInsensitive) == 0 ||
           (name.compare("content-length", Qt::CaseInsensitive) == 0 && value != QByteArrayView("0"));
}

std::optional<WebStatus> readFields(QByteArrayView lines, bool needsHost, WebRequest &request)
{
    int fields = 0, hosts = 0;
    while (!lines.isEmpty()) {
        const qsizetype end = lines.indexOf("\r\n");
        const QByteArrayView line = lines.first(end);
        lines = lines.sliced(end + 2);
        const qsizetype colon = line.indexOf(':');
        if (colon <= 0 || !isToken(line.first(colon)) || !isPlain(line.sliced(colon + 1), true))
            return WebStatus::BadRequest;
        if (++fields > mostRequestFields)
            return WebStatus::FieldsTooLarge;
        const QByteArrayView name = line.first(colon), value = line.sliced(colon + 1).trimmed();
        if (announcesContent(name, value))
            return WebStatus::BadRequest;
        if (name.compare("host", Qt::CaseInsensitive) == 0) {
            const auto host = hostAlone(value);
            if (!host || ++hosts > 1)
                return WebStatus::BadRequest;
            request.host = *host;
        } else if (name.compare("accept-language", Qt::CaseInsensitive) == 0) {
            request.language = value.toByteArray();
        }
    }
    return needsHost && hosts == 0 ? std::optional(WebStatus::BadRequest) : std::nullopt;
}

} // namespace

QByteArray statusLine(WebStatus status)
{
    const auto words = [status] {
        switch (status) {
        case WebStatus::Ok:
            return "OK";
        case WebStatus::BadRequest:
            return "Bad Request";
        case WebStatus::NotFound:
            return "Not Found";
        case WebStatus::MethodNotAllowed:
            return "Method Not Allowed";
        case WebStatus::RequestTimeout:
            return "Request Timeout";
        case WebStatus::UriTooLong:
            return "URI Too Long";
        case WebStatus::Misdirected:
            return "Misdirected Request";
        case WebStatus::FieldsTooLarge:
            return "Request Header Fields Too Large";
        case WebStatus::Unavailable:
            return "Service Unavailable";
        case WebStatus::VersionNotSupported:
            break;
        }
        return "HTTP Version Not Supported";
    };
    return QByteArray::number(static_cast<int>(status)) + ' ' + words();
}

RequestReading readRequest(QByteArrayView bytes)
{
    if (!bytes.isEmpty() && !isTokenCharacter(bytes.front()))
        return refused(WebStatus::BadRequest);
    const qsizetype lineEnd = bytes.indexOf("\r\n");
    if (lineEnd > longestRequestLine || (lineEnd < 0 && bytes.size() > longestRequestLine))
        return refused(WebStatus::UriTooLong);
    if (lineEnd < 0)
        return bytes.contains('\n') || bytes.contains('\0') ? refused(WebStatus::BadRequest)
                                                            : RequestReading();
    RequestReading reading;
    if (const auto refusal = readFirstLine(bytes.first(lineEnd), reading.request))
        return refused(*refusal);
    const bool needsHost = bytes.first(lineEnd).endsWith("1.1");
    const qsizetype end = bytes.indexOf("\r\n\r\n");
    if (end < 0 || end + 4 > longestRequest)
        return bytes.size() > longestRequest ? refused(WebStatus::FieldsTooLarge) : RequestReading();
    if (const auto refusal = readFields(bytes.sliced(lineEnd + 2, end - lineEnd), needsHost, reading.request))
        return refused(*refusal);
    reading.state = RequestReading::State::Complete;
    return reading;
}

} // namespace odo
