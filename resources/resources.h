// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace odo {

/// The bytes of a file compiled into the program, e.g. resourceBytes("icons/track.svg"). A name that is not
/// there is a fault of the program: it asserts, and gives nothing.
QByteArray resourceBytes(const QString &name);

} // namespace odo
