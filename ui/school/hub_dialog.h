// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace odo {

class ConnectForm;
class HubExchange;
class HubPanel;

/// Connects the open project to the school's hub, shows how it is connected, publishes and pulls when asked.
/// It can stay open beside the window; what it began goes on without it. Deletes itself when it is closed.
/// GUI thread.
class HubDialog : public QDialog
{
    Q_OBJECT
public:
    /// exchange must outlive it, with a project.
    explicit HubDialog(HubExchange &exchange, QWidget *parent = nullptr);

    /// The changes that were made here and elsewhere, in a dialog of their own.
    static void showConflicts(HubExchange &exchange, QWidget *parent);

private:
    void connectProject();
    void disconnectProject();
    void showState();

    HubExchange &m_exchange;
    ConnectForm *m_form;
    HubPanel *m_panel;
    QStackedWidget *m_pages;
    QLabel *m_words;
    QProgressBar *m_progress;
    QPushButton *m_cancel;
    QString m_notice; ///< what is wrong with what was entered
};

} // namespace odo
