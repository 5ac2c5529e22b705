// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/preferences/preferences_dialog.h"

#include "ui/main_window/preferences/general_page.h"
#include "ui/main_window/preferences/keys_page.h"
#include "ui/main_window/preferences/network_page.h"
#include "ui/main_window/preferences/reports_page.h"

#include <QDialogButtonBox>
#include <QTabWidget>
#include <QVBoxLayout>

namespace odo {

PreferencesDialog::PreferencesDialog(CommandKeys &keys, Theme theme, QWidget *parent)
    : QDialog(parent), m_tabs(new QTabWidget)
{
    setWindowTitle(tr("Preferences"));
    auto *general = new GeneralPage(theme);
    m_tabs->setAccessibleName(tr("Kinds of preferences"));
    m_tabs->addTab(general, tr("&General"));
    m_tabs->addTab(new ReportsPage, tr("&Reports"));
    m_tabs->addTab(new KeysPage(keys), tr("&Keys"));
    m_tabs->addTab(new NetworkPage, tr("&Network"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_tabs, 1);
    layout->addWidget(buttons);
    resize(560, 520);
    connect(general, &GeneralPage::themeChosen, this, &PreferencesDialog::themeChosen);
    connect(general, &GeneralPage::lookChanged, this, &PreferencesDialog::lookChanged);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void PreferencesDialog::turnTo(Page page)
{
    m_tabs->setCurrentIndex(page);
}

} // namespace odo
