// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace odo {

/// Whether live positions are sent on the network, and to where. What is chosen, and can be sent to, is kept in the settings at once; who sends asks for it when the preferences are closed.
class NetworkPage : public QWidget
{
    Q_OBJECT
public:
    explicit NetworkPage(QWidget *parent = nullptr);

private:
    void choose();
    void tell();

    QCheckBox *m_on;
    QLineEdit *m_address;
    QSpinBox *m_port;
    QComboBox *m_interface;
    QLabel *m_words;
};

} // namespace odo
