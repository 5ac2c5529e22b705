// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/school/hub_address.h"
#include "ui/school/hub_exchange.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace odo {

class FactList;

/// What is entered to connect a project: the hub's address, a password if it is not in ~/.pgpass, and a
/// folder for recordings if the school has one. GUI thread.
class ConnectForm : public QWidget
{
    Q_OBJECT
public:
    explicit ConnectForm(QWidget *parent = nullptr);
    Result<HubAddress> address() const;
    QString password() const;
    QString folder() const;
    void clearPassword();
    void setOpen(bool isOpen); ///< for entering
    /// What Enter presses.
    QPushButton *connectButton() const { return m_connect; }

Q_SIGNALS:
    void connectRequested();

private:
    void browse();
    QLineEdit *m_address, *m_password, *m_folder;
    QPushButton *m_browse, *m_connect;
};

/// How a project is connected, and what can be done with that. GUI thread.
class HubPanel : public QWidget
{
    Q_OBJECT
public:
    explicit HubPanel(QWidget *parent = nullptr);
    void showState(const HubExchange &exchange);
    QString password() const;
    QPushButton *publishButton() const { return m_publish; }

Q_SIGNALS:
    void publishRequested(odo::WithRecordings recordings);
    void pullRequested(odo::WithRecordings recordings);
    void conflictsRequested();
    void disconnectRequested();
    void passwordEntered(const QString &password);

private:
    WithRecordings recordings() const;
    void enterPassword();

    FactList *m_facts;
    QWidget *m_login;
    QLineEdit *m_password;
    QCheckBox *m_recordings;
    QPushButton *m_publish, *m_pull, *m_conflicts, *m_disconnect;
    QString m_shown; ///< what the facts were made of
};

} // namespace odo
