// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/platform/datagram_socket.h"
#include "ui/record/record_page.h"

#include <QSettings>

namespace odo {

namespace {

const QString onKey = QStringLiteral("sslVision/on"), addressKey = QStringLiteral("sslVision/address"),
              portKey = QStringLiteral("sslVision/port"),
              interfaceKey = QStringLiteral("sslVision/interface");

} // namespace

SentPositions SentPositions::chosen()
{
    const QSettings settings;
    const BroadcastTarget usual;
    SentPositions sent;
    sent.isOn = settings.value(onKey, false).toBool();
    sent.target.address =
        settings.value(addressKey, QString::fromStdString(usual.address)).toString().toStdString();
    const uint port = settings.value(portKey, usual.port).toUInt();
    sent.target.port = port > 0 && port <= 65535 ? static_cast<std::uint16_t>(port) : usual.port;
    sent.target.interface =
        settings.value(interfaceKey, QString::fromStdString(usual.interface)).toString().toStdString();
    return sent;
}

void SentPositions::choose() const
{
    QSettings settings;
    settings.setValue(onKey, isOn);
    settings.setValue(addressKey, QString::fromStdString(target.address));
    settings.setValue(portKey, target.port);
    settings.setValue(interfaceKey, QString::fromStdString(target.interface));
}

QStringList networkInterfaces()
{
    QStringList names{QString::fromStdString(BroadcastTarget().interface)};
    for (const std::string &name : networkInterfaceNames())
        if (!names.contains(QString::fromStdString(name)))
            names << QString::fromStdString(name);
    return names;
}

} // namespace odo
