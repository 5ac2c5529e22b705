// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/sent_positions.h"

#include <QSettings>
#include <net/if.h>

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
    if (struct if_nameindex *all = if_nameindex()) {
        for (const struct if_nameindex *one = all; one->if_index != 0; ++one) {
            if (!names.contains(QString::fromUtf8(one->if_name)))
                names << QString::fromUtf8(one->if_name);
        }
        if_freenameindex(all);
    }
    return names;
}

} // namespace odo
