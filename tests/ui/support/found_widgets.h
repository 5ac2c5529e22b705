// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <algorithm>

// What a test finds in a window, as a person would: by words. What must be there and is not ends the test.
namespace odo::test {

/// A button by its words, with its mnemonic or without.
inline QPushButton *button(const QWidget &window, const char *text)
{
    const auto buttons = window.findChildren<QPushButton *>();
    const QString words = QString::fromUtf8(text);
    for (QPushButton *each : buttons) // two may differ by their mnemonics alone
        if (each->text() == words)
            return each;
    for (QPushButton *each : buttons)
        if (each->text().remove(QLatin1Char('&')) == words)
            return each;
    qFatal("there is no button %s", text);
}

/// A widget by its accessible name.
template <class Widget>
Widget *named(const QWidget &window, const char *name)
{
    for (Widget *each : window.findChildren<Widget *>())
        if (each->accessibleName() == QString::fromUtf8(name))
            return each;
    qFatal("there is no widget %s", name);
}

/// An action by its words without its mnemonic; nullptr: there is none (yet).
inline QAction *actionOf(const QWidget &window, const char *text)
{
    for (QAction *each : window.findChildren<QAction *>())
        if (each->text().remove(QLatin1Char('&')) == QString::fromUtf8(text))
            return each;
    return nullptr;
}

/// Triggers the action of a dialog that has these keys.
inline void pressKeys(const QWidget &dialog, const QKeySequence &keys)
{
    for (QAction *each : dialog.actions())
        if (each->shortcut() == keys)
            return each->trigger();
    qFatal("%s does nothing", qPrintable(keys.toString()));
}

/// Some label of the window has these words.
inline bool says(const QWidget &window, const char *words)
{
    return std::ranges::any_of(window.findChildren<QLabel *>(), [&](const QLabel *label) {
        return label->text().contains(QString::fromUtf8(words));
    });
}

} // namespace odo::test
