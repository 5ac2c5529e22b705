// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QSignalBlocker>
#include <QStringList>
#include <algorithm>
#include <string>

namespace odo {

/// A choice of words that may be long: it is as wide as so many letters, or wider.
inline QComboBox *makeChoice(const QString &name, int letters)
{
    auto *choice = new QComboBox;
    choice->setAccessibleName(name);
    choice->setToolTip(name);
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(letters);
    return choice;
}

/// Puts words (shown as others) behind the first so many entries of a choice; keeps what is chosen where it
/// is still there, and tells nobody.
inline void fillChoice(QComboBox &choice, const QStringList &words, const QStringList &shown, int kept = 1)
{
    const QString current = choice.currentData().toString();
    const QSignalBlocker quiet(&choice);
    while (choice.count() > kept)
        choice.removeItem(choice.count() - 1);
    for (int i = 0; i < words.size(); ++i)
        choice.addItem(shown.at(i), words.at(i));
    choice.setCurrentIndex(std::max(0, choice.findData(current)));
}

/// The word that is chosen; empty: that of the first entry.
inline std::string chosenWord(const QComboBox &choice)
{
    return choice.currentData().toString().toStdString();
}

} // namespace odo
