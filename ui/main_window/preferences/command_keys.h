// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QWidget>
#include <optional>
#include <vector>

class QAction;
class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QMenu;
class QMenuBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace odo {

/// The keys of the window's commands: what they usually are, and what a person made of them, which is kept in
/// the settings. A command is an action of the menus with an object name. GUI thread.
class CommandKeys : public QObject
{
    Q_OBJECT
public:
    struct Command
    {
        QString name;  ///< of the action, and in the settings
        QString group; ///< the menu it is in
        QString words;
        QList<QKeySequence> usual, keys;
        QPointer<QAction> action; ///< null: it went with its project
    };

    using QObject::QObject;

    /// Gives the commands of the menus their keys; those that are new to it become known. To be called again
    /// when the menus have new actions.
    void adopt(const QMenuBar &menus);
    /// In the order of the menus.
    const std::vector<Command> &commands() const { return m_commands; }
    /// The command that answers to a key.
    const Command *commandOf(const QKeySequence &key) const;

    /// An empty key: none. Another command that has it loses it.
    void setKey(const QString &name, const QKeySequence &key);
    /// All commands get their usual keys back.
    void forgetAll();

Q_SIGNALS:
    void changed();

private:
    void adoptMenu(const QMenu &menu, const QString &group);
    void adoptAction(QAction &action, const QString &group);
    void give(Command &command, const QList<QKeySequence> &keys);
    Command *find(const QString &name);

    std::vector<Command> m_commands;
};

/// The text of an action without what is there for its menu: mnemonics and dots.
QString plainWords(const QString &actionText);

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
