// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace odo {

/// One of our line icons ("icons/NAME.svg"), drawn in the palette's text colour at whatever size and scale it
/// is asked for, so that it follows light and dark. With a colour given, always in that one.
QIcon themeIcon(const QString &name, const QColor &colour = {});

} // namespace odo
