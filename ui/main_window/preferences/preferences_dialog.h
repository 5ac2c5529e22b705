// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/main_window/appearance.h"

#include <QDialog>

class QTabWidget;

namespace odo {

class CommandKeys;

/// What a person can set for all projects. Every change counts at once; there is nothing to confirm.
class PreferencesDialog : public QDialog
{
    Q_OBJECT
public:
    enum Page { General, Reports, Keys };
    PreferencesDialog(CommandKeys &keys, Theme theme, QWidget *parent = nullptr);
    void turnTo(Page page);

Q_SIGNALS:
    void themeChosen(odo::Theme theme);
    void lookChanged(); ///< what is on the screen must be made anew

private:
    QTabWidget *m_tabs;
};

} // namespace odo
