// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QKeySequence>
#include <QLabel>
#include <QMap>
#include <QMenuBar>
#include <QStringList>
#include <QTabBar>

namespace odo::test {

/// The keys with Alt by which more than one thing in a window is reached, with their words: pressed, they
/// would only go from one to the next. What is hidden or in a menu does not count.
inline QStringList sharedMnemonics(const QWidget &window)
{
    QMap<QString, QStringList> words;
    const auto add = [&words](const QString &text) {
        if (const QKeySequence key = QKeySequence::mnemonic(text); !key.isEmpty())
            words[key.toString()] << text;
    };
    for (const auto *bar : window.findChildren<QMenuBar *>())
        for (const QAction *action : bar->actions())
            add(action->text());
    for (const auto *button : window.findChildren<QAbstractButton *>())
        if (button->isVisibleTo(&window))
            add(button->text());
    for (const auto *label : window.findChildren<QLabel *>())
        if (label->buddy() && label->isVisibleTo(&window))
            add(label->text());
    for (const auto *tabs : window.findChildren<QTabBar *>())
        for (int tab = 0; tabs->isVisibleTo(&window) && tab < tabs->count(); ++tab)
            add(tabs->tabText(tab));
    QStringList shared;
    for (auto key = words.cbegin(); key != words.cend(); ++key)
        if (key->size() > 1)
            shared << key.key() + QStringLiteral(": ") + key->join(QStringLiteral(", "));
    return shared;
}

} // namespace odo::test
