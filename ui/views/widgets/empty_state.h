// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

class QPushButton;
class QVBoxLayout;

namespace odo {

/// Shown while there is nothing to show yet: an icon, what is missing in words, and the buttons that add it.
class EmptyState : public QWidget
{
    Q_OBJECT
public:
    EmptyState(const QString &icon, const QString &headline, const QString &text, QWidget *parent = nullptr);
    /// The first button is the one that a person most likely wants.
    QPushButton *addButton(const QString &icon, const QString &text);
    /// Below the buttons.
    void addWidget(QWidget *widget);

private:
    QVBoxLayout *m_layout = nullptr;
    QVBoxLayout *m_buttons;
    bool m_hasButton = false;
};

} // namespace odo
