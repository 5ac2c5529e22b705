// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/hub_address.h"

#include <QUrl>
#include <QUrlQuery>
#include <algorithm>
#include <array>

namespace odo {

namespace {

constexpr std::array sslModes{"disable", "allow", "prefer", "require", "verify-ca", "verify-full"};

Message addressForm()
{
    return ODO_TEXT("school.address_form", "give it as postgresql://user@host/database");
}

tl::unexpected<Error> noAddress(Message why, Message advice = addressForm())
{
    return fail(ErrorCode::InvalidInput, ODO_TEXT("school.address", "address of the school hub"),
                std::move(why), std::move(advice));
}

/// What a connection string can hold without being taken for something else.
bool isPlain(const QString &text)
{
    return std::ranges::none_of(
        text, [](QChar c) { return c.unicode() < 0x20 || c == u';' || c == u'\'' || c == u'\\'; });
}

Result<void> readOption(const QString &key, const QString &value, HubAddress &into)
{
    if (key == QLatin1String("sslmode")) {
        into.sslMode = value.toStdString();
        if (std::ranges::find(sslModes, into.sslMode) == sslModes.end())
            return noAddress(ODO_TEXT("school.sslmode_unknown", "sslmode '%1' is not known")(into.sslMode),
                             ODO_TEXT("school.sslmode_choices",
                                      "use disable, allow, prefer, require, verify-ca or "
                                      "verify-full"));
    } else if (key == QLatin1String("sslrootcert")) {
        into.sslRootCert = value.toStdString();
    } else if (key == QLatin1String("host")) {
        into.host = value.toStdString();
    } else if (key == QLatin1String("port")) {
        into.port = value.toInt();
    } else {
        return noAddress(ODO_TEXT("school.option_unknown", "its option '%1' is not known")(key.toStdString()),
                         ODO_TEXT("school.options_known", "use sslmode, sslrootcert, host or port"));
    }
    return {};
}

Result<void> checkParts(const HubAddress &address)
{
    for (const std::string &part : {address.user, address.host, address.database, address.sslRootCert}) {
        if (!isPlain(QString::fromStdString(part)))
            return noAddress(
                ODO_TEXT("school.address_characters",
                         "it holds a quotation mark, a backslash, a semicolon or a control character"));
    }
    if (address.database.empty())
        return noAddress(ODO_TEXT("school.no_database", "it names no database"));
    return {};
}

} // namespace

Result<HubAddress> HubAddress::parse(const std::string &text)
{
    const QUrl url(QString::fromStdString(text), QUrl::StrictMode);
    const bool isOurs =
        url.scheme() == QLatin1String("postgresql") || url.scheme() == QLatin1String("postgres");
    if (!url.isValid() || !isOurs)
        return noAddress(ODO_TEXT("school.no_url", "it is no address of a PostgreSQL database"));
    const QUrlQuery query(url);
    if (!url.password().isEmpty() || query.hasQueryItem(QStringLiteral("password")))
        return noAddress(ODO_TEXT("school.password_in_url", "it holds a password, which others could read"),
                         ODO_TEXT("school.password_elsewhere",
                                  "leave it out, and put the password into ~/.pgpass or PGPASSWORD"));
    HubAddress address;
    address.user = url.userName(QUrl::FullyDecoded).toStdString();
    address.host = url.host(QUrl::FullyDecoded).toStdString();
    address.port = std::max(url.port(), 0);
    address.database = url.path(QUrl::FullyDecoded).mid(1).toStdString();
    address.sslMode = "prefer";
    for (const auto &[key, value] : query.queryItems(QUrl::FullyDecoded))
        ODO_TRY(readOption(key, value, address));
    ODO_TRY(checkParts(address));
    return address;
}

std::string HubAddress::url() const
{
    QUrl url;
    url.setScheme(QStringLiteral("postgresql"));
    url.setUserName(QString::fromStdString(user), QUrl::DecodedMode);
    const bool isSocket = !host.empty() && host.front() == '/';
    url.setHost(isSocket ? QString() : QString::fromStdString(host));
    if (port > 0 && !isSocket && !host.empty())
        url.setPort(port);
    url.setPath(QStringLiteral("/") + QString::fromStdString(database), QUrl::DecodedMode);
    QUrlQuery query;
    if (isSocket)
        query.addQueryItem(QStringLiteral("host"), QString::fromStdString(host));
    if (port > 0 && (isSocket || host.empty()))
        query.addQueryItem(QStringLiteral("port"), QString::number(port));
    if (sslMode != "prefer")
        query.addQueryItem(QStringLiteral("sslmode"), QString::fromStdString(sslMode));
    if (!sslRootCert.empty())
        query.addQueryItem(QStringLiteral("sslrootcert"), QString::fromStdString(sslRootCert));
    if (!query.isEmpty())
        url.setQuery(query);
    QString text = url.toString(QUrl::FullyEncoded);
    if (user.empty() && text.startsWith(QLatin1String("postgresql:/")) &&
        !text.startsWith(QLatin1String("postgresql://")))
        text.insert(11, QStringLiteral("//")); // what QUrl leaves out where there is no host
    return text.toStdString();
}

Message HubAddress::subject() const
{
    return ODO_TEXT("school.hub_subject", "school hub '%1'")((host.empty() ? "" : host + "/") + database);
}

namespace {

const MessageText &passwordWanted()
{
    return ODO_TEXT("school.password_wanted", "the server asks for the password of the login");
}

const MessageText &passwordRefused()
{
    return ODO_TEXT("school.password_refused", "the server does not accept this login with this password");
}

} // namespace

tl::unexpected<Error> needsPassword(Message subject, bool gotOne)
{
    return fail(ErrorCode::NotFound, std::move(subject), gotOne ? passwordRefused() : passwordWanted(),
                ODO_TEXT("school.password_place", "put the correct one into ~/.pgpass or PGPASSWORD"));
}

bool isPasswordNeeded(const Error &error)
{
    return error.why.code() == passwordWanted().code || error.why.code() == passwordRefused().code;
}

} // namespace odo
