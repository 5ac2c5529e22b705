// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace odo {

class CommandKeys;

/// The commands with their keys, searched as one types, each of which can be given another one. Every change
/// counts at once.
class KeysPage : public QWidget
{
    Q_OBJECT
public:
    explicit KeysPage(CommandKeys &keys, QWidget *parent = nullptr);

private:
    void fill();
    QTreeWidgetItem *groupOf(const QString &words);
    void filter();
    void showChosen();
    void warn();
    void assign();
    QString chosen() const;

    CommandKeys &m_keys;
    QLineEdit *m_search;
    QTreeWidget *m_list;
    QKeySequenceEdit *m_key;
    QPushButton *m_assign, *m_none, *m_usual;
    QLabel *m_warning;
};

} // namespace odo
