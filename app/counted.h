// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace odo {

/// "1 page", "2 pages": for nouns whose plural ends in s.
template <class Number>
QString counted(Number count, const QString &noun)
{
    return QString::number(count) + u' ' + noun + (count == 1 ? QString() : QStringLiteral("s"));
}

} // namespace odo
