// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace odo {

/// A text for a label that breaks lines: a word of more than forty letters may be broken after each forty, so that a name of ten thousand
/// does not ask for a window as wide as itself.
inline QString breakable(const QString &text)
{
    constexpr int longest = 40;
    const QChar breakHere(0x200b); // zero width space
    QString broken;
    int run = 0;
    for (const QChar c : text) {
        run = c.isSpace() ? 0 : run + 1;
        if (run > longest && !c.isLowSurrogate() && !c.isMark()) {
            broken += breakHere;
            run = 1;
        }
        broken += c;
    }
    return broken;
}

} // namespace odo
