// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <memory>

namespace odo::test {

/// What a stream of events has sent so far.
struct Listener
{
    Listener(QNetworkAccessManager &network, const QString &url)
        : reply(network.get(QNetworkRequest(QUrl(url + QStringLiteral("events")))))
    {
        QObject::connect(reply.get(), &QNetworkReply::readyRead, reply.get(),
                         [this] { got += reply->readAll(); });
    }
    QJsonObject newest() const
    {
        const qsizetype end = got.lastIndexOf("\n\n"), begin = got.lastIndexOf("data: ");
        return end < begin ? QJsonObject()
                           : QJsonDocument::fromJson(got.mid(begin + 6, end - begin - 6)).object();
    }
    qsizetype teams() const { return newest()[QStringLiteral("teams")].toArray().size(); }

    std::unique_ptr<QNetworkReply> reply;
    QByteArray got;
};

} // namespace odo::test
