// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/main_window/appearance.h"

#include <QWidget>

class QComboBox;
class QLabel;

namespace odo {

/// How everything looks and is told: language, units, theme, colours of maps. What is chosen is in force, and kept in the
/// settings, at once.
class GeneralPage : public QWidget
{
    Q_OBJECT
public:
    explicit GeneralPage(Theme theme, QWidget *parent = nullptr);

    /// What the settings hold comes into force, but for the theme, which is the window's own.
    static void applySettings();

Q_SIGNALS:
    void themeChosen(odo::Theme theme);
    void lookChanged(); ///< what is on the screen must be made anew

private:
    QComboBox *makeLanguages();
    QComboBox *makeUnits();
    QComboBox *makeThemes(Theme theme);
    QComboBox *makeScales();

    QLabel *m_languageWords; ///< hidden until another language is chosen
};

} // namespace odo
