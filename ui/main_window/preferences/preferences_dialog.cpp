// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/preferences/preferences_dialog.h"

#include "ui/main_window/preferences/general_page.h"
#include "ui/main_window/preferences/keys_page.h"

#include <QDialogButtonBox>
#include <QTabWidget>
#include <QVBoxLayout>

namespace odo {

PreferencesDialog::PreferencesDialog(CommandKeys &keys, Theme theme, QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("Preferences"));
    auto *general = new GeneralPage(theme);
    auto *tabs = new QTabWidget;
    tabs->setAccessibleName(tr("Kinds of preferences"));
    tabs->addTab(general, tr("&General"));
    tabs->addTab(new KeysPage(keys), tr("&Keys"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(tabs, 1);
    layout->addWidget(buttons);
    resize(560, 520);
    connect(general, &GeneralPage::themeChosen, this, &PreferencesDialog::themeChosen);
    connect(general, &GeneralPage::lookChanged, this, &PreferencesDialog::lookChanged);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

} // namespace odo
