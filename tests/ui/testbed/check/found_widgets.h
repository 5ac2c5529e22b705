// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace odo::test {

/// A button by its words, without its mnemonic.
inline QPushButton *button(QWidget &window, const char *text)
{
    for (auto *each : window.findChildren<QPushButton *>())
        if (each->text().remove(QLatin1Char('&')) == QString::fromUtf8(text))
            return each;
    return nullptr;
}

/// Some label of the window has these words.
inline bool says(QWidget &window, const char *words)
{
    for (const QLabel *label : window.findChildren<QLabel *>())
        if (label->text().contains(QString::fromUtf8(words)))
            return true;
    return false;
}

/// A widget by its accessible name.
template <class Widget>
Widget *named(QWidget &window, const char *name)
{
    for (auto *each : window.findChildren<Widget *>())
        if (each->accessibleName() == QString::fromUtf8(name))
            return each;
    return nullptr;
}

} // namespace odo::test
