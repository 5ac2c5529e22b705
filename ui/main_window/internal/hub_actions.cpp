// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/hub_actions.h"

#include "ui/main_window/workspace.h"
#include "ui/school/hub_dialog.h"
#include "ui/views/widgets/command_keys.h"

#include <QAction>
#include <QWidget>

namespace odo {

HubActions::HubActions(Workspace &workspace, QWidget &window)
    : QObject(&window), m_workspace(workspace), m_window(window), m_hub(new QAction(tr("School &hub…"), this))
{
    nameCommands({{m_hub, "schoolHub"}});
    m_hub->setEnabled(false);
    connect(m_hub, &QAction::triggered, this, &HubActions::showDialog);
    connect(&m_workspace, &Workspace::opened, this, [this] {
        m_exchange.setProject(m_workspace.project(), m_workspace.isReadOnly());
        m_hub->setEnabled(true);
    });
    connect(&m_workspace, &Workspace::aboutToClose, this, &HubActions::end);
    connect(&m_exchange, &HubExchange::changed, this, &HubActions::changed);
    connect(&m_exchange, &HubExchange::received, this, &HubActions::received);
    connect(&m_exchange, &HubExchange::conflictsFound, this, &HubActions::conflictsFound);
}

void HubActions::end()
{
    delete m_dialog;
    m_exchange.setProject(nullptr);
}

void HubActions::showDialog()
{
    if (!m_dialog)
        m_dialog = new HubDialog(m_exchange, &m_window);
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void HubActions::showConflicts()
{
    if (!m_exchange.conflicts().empty())
        HubDialog::showConflicts(m_exchange, m_dialog ? static_cast<QWidget *>(m_dialog) : &m_window);
}

} // namespace odo
