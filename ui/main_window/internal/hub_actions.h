// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/school/hub_exchange.h"

#include <QObject>
#include <QPointer>
#include <functional>

class QAction;
class QWidget;

namespace odo {

class HubDialog;
class Workspace;

/// The open project's tie to the school's hub, and the dialog for it. Owns the action. GUI thread.
class HubActions : public QObject
{
    Q_OBJECT
public:
    HubActions(Workspace &workspace, QWidget &window);
    QAction *hub() const { return m_hub; }
    /// As HubExchange::setMayPublish.
    void setMayPublish(std::function<bool()> mayPublish) { m_exchange.setMayPublish(std::move(mayPublish)); }
    /// For the foot of the window; empty where the project is not connected.
    QString words() const { return hubStateWords(m_exchange.state()); }
    /// As HubExchange.
    std::optional<HubAddress> address() const { return m_exchange.hub(); }
    void showDialog();
    void showConflicts();
    /// Before the project goes.
    void end();

Q_SIGNALS:
    void changed();        ///< what words() says
    void received();       ///< the project has what others published
    void conflictsFound(); ///< showConflicts() has them

private:
    Workspace &m_workspace;
    QWidget &m_window;
    QAction *m_hub;
    HubExchange m_exchange;
    QPointer<HubDialog> m_dialog; ///< while it is open
};

} // namespace odo
