// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/resources.h"

#include <QFile>

namespace odo {

QByteArray resourceBytes(const QString &name)
{
    QFile file(QStringLiteral(":/odograph/") + name);
    const bool opened = file.open(QIODevice::ReadOnly);
    Q_ASSERT_X(opened, "resourceBytes", qPrintable(name));
    return opened ? file.readAll() : QByteArray();
}

} // namespace odo
