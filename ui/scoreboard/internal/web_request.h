// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QByteArrayView>

namespace odo {

/// The answers of the standings' page, as HTTP numbers them.
enum class WebStatus {
    Ok = 200,
    BadRequest = 400,
    NotFound = 404,
    MethodNotAllowed = 405,
    RequestTimeout = 408,
    UriTooLong = 414,
    Misdirected = 421, ///< for another name than ours
    FieldsTooLarge = 431,
    Unavailable = 503,
    VersionNotSupported = 505,
};
/// "404 Not Found"
QByteArray statusLine(WebStatus status);

/// What a browser asks for. Plain value.
struct WebRequest
{
    QByteArray path;     ///< without its query: "/events"
    QByteArray host;     ///< without its port: "127.0.0.1", "[::1]"; empty: HTTP/1.0 may leave it out
    QByteArray language; ///< Accept-Language as it was sent; may be empty
};

/// The longest request, with its header; of that its first line; and how many lines the header may have.
constexpr qsizetype longestRequest = 8192, longestRequestLine = 2048;
constexpr int mostRequestFields = 64;

/// What has come of a request so far.
struct RequestReading
{
    enum class State { Incomplete, Complete, Refused } state = State::Incomplete;
    WebRequest request;                        ///< of a complete one
    WebStatus refusal = WebStatus::BadRequest; ///< of a refused one
};

/// Reads a request strictly (RFC 9110, RFC 9112): GET with a path, no body, lines that end with CR LF, no
/// field over several lines. Anything else is refused as soon as it shows. Pure.
RequestReading readRequest(QByteArrayView bytes);

} // namespace odo
