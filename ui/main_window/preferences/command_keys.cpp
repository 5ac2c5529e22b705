// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/preferences/command_keys.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <algorithm>

namespace odo {
namespace {

const QString settingsGroup = QStringLiteral("keys");

QString settingOf(const QString &name)
{
    return settingsGroup + u'/' + name;
}

/// nullopt: none are kept, or no keys of this world.
std::optional<QList<QKeySequence>> keptKeys(const QString &name)
{
    const QVariant kept = QSettings().value(settingOf(name));
    if (!kept.isValid())
        return std::nullopt;
    if (kept.toString().isEmpty())
        return QList<QKeySequence>();
    const QKeySequence key = QKeySequence::fromString(kept.toString(), QKeySequence::PortableText);
    const bool isKey = !key.isEmpty() && key[0].key() != Qt::Key_unknown;
    return isKey ? std::optional(QList{key}) : std::nullopt;
}

} // namespace

QString plainWords(const QString &actionText)
{
    static const QRegularExpression mnemonic(QStringLiteral("&(?=.)"));
    QString words = actionText;
    words.remove(mnemonic);
    while (words.endsWith(u'.') || words.endsWith(QChar(0x2026)))
        words.chop(1);
    return words;
}

void CommandKeys::adopt(const QMenuBar &menus)
{
    for (const QAction *title : menus.actions())
        if (const QMenu *menu = title->menu())
            adoptMenu(*menu, plainWords(title->text()));
    Q_EMIT changed();
}

void CommandKeys::adoptMenu(const QMenu &menu, const QString &group)
{
    for (QAction *action : menu.actions()) {
        if (const QMenu *sub = action->menu())
            adoptMenu(*sub, plainWords(action->text()));
        else if (!action->objectName().isEmpty())
            adoptAction(*action, group);
    }
}

void CommandKeys::adoptAction(QAction &action, const QString &group)
{
    Command *command = find(action.objectName());
    if (!command) {
        m_commands.push_back({action.objectName(), group, plainWords(action.text()), action.shortcuts(), {}, {}});
        command = &m_commands.back();
    }
    command->action = &action;
    give(*command, keptKeys(command->name).value_or(command->usual));
}

void CommandKeys::give(Command &command, const QList<QKeySequence> &keys)
{
    command.keys = keys;
    if (command.action)
        command.action->setShortcuts(keys);
}

CommandKeys::Command *CommandKeys::find(const QString &name)
{
    const auto found = std::ranges::find(m_commands, name, &Command::name);
    return found == m_commands.end() ? nullptr : &*found;
}

const CommandKeys::Command *CommandKeys::commandOf(const QKeySequence &key) const
{
    const auto found =
        std::ranges::find_if(m_commands, [&](const Command &command) { return command.keys.contains(key); });
    return found == m_commands.end() || key.isEmpty() ? nullptr : &*found;
}

void CommandKeys::setKey(const QString &name, const QKeySequence &key)
{
    Command *command = find(name);
    if (!command)
        return;
    if (const Command *other = commandOf(key); other && other != command)
        setKey(other->name, {});
    QSettings().setValue(settingOf(name), key.toString(QKeySequence::PortableText));
    give(*command, key.isEmpty() ? QList<QKeySequence>() : QList{key});
    Q_EMIT changed();
}

void CommandKeys::forgetAll()
{
    QSettings().remove(settingsGroup);
    for (Command &command : m_commands)
        give(command, command.usual);
    Q_EMIT changed();
}

} // namespace odo
