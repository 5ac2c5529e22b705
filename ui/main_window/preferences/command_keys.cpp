// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/preferences/command_keys.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QTreeWidget>
#include <QVBoxLayout>
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
        m_commands.push_back(
            {action.objectName(), group, plainWords(action.text()), action.shortcuts(), {}, {}});
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

namespace {

enum Column { WordsColumn, KeyColumn };
constexpr int nameRole = Qt::UserRole;

} // namespace

KeysPage::KeysPage(CommandKeys &keys, QWidget *parent)
    : QWidget(parent), m_keys(keys), m_search(new QLineEdit), m_list(new QTreeWidget),
      m_key(new QKeySequenceEdit), m_assign(new QPushButton(tr("&Use this key"))),
      m_none(new QPushButton(tr("&No key"))), m_usual(new QPushButton(tr("Reset &all"))),
      m_warning(new QLabel)
{
    m_search->setPlaceholderText(tr("Search for a command or a key"));
    m_search->setAccessibleName(tr("Search for a command or a key"));
    m_search->setClearButtonEnabled(true);
    m_list->setAccessibleName(tr("Commands and their keys"));
    m_list->setHeaderLabels({tr("Command"), tr("Key")});
    m_list->header()->setSectionResizeMode(WordsColumn, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(KeyColumn, QHeaderView::ResizeToContents);
    m_list->header()->setStretchLastSection(false);
    m_list->setRootIsDecorated(false);
    m_key->setAccessibleName(tr("New key for the selected command"));
    m_warning->setObjectName(QStringLiteral("quiet"));
    m_warning->setWordWrap(true);
    m_warning->setTextFormat(Qt::PlainText);
    auto *row = new QHBoxLayout;
    row->addWidget(m_key, 1);
    row->addWidget(m_assign);
    row->addWidget(m_none);
    row->addWidget(m_usual);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_search);
    layout->addWidget(m_list, 1);
    layout->addLayout(row);
    layout->addWidget(m_warning);
    connect(m_search, &QLineEdit::textChanged, this, &KeysPage::filter);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &KeysPage::showChosen);
    connect(m_key, &QKeySequenceEdit::keySequenceChanged, this, &KeysPage::warn);
    connect(m_assign, &QPushButton::clicked, this, &KeysPage::assign);
    connect(m_none, &QPushButton::clicked, this, [this] { m_keys.setKey(chosen(), {}); });
    connect(m_usual, &QPushButton::clicked, this, [this] { m_keys.forgetAll(); });
    connect(&m_keys, &CommandKeys::changed, this, &KeysPage::fill);
    fill();
}

void KeysPage::fill()
{
    const QString before = chosen();
    m_list->clear();
    for (const CommandKeys::Command &command : m_keys.commands()) {
        const QString keys = QKeySequence::listToString(command.keys, QKeySequence::NativeText);
        auto *item = new QTreeWidgetItem(groupOf(command.group), {command.words, keys});
        item->setData(WordsColumn, nameRole, command.name);
        if (command.name == before)
            m_list->setCurrentItem(item);
    }
    filter();
    showChosen();
}

QTreeWidgetItem *KeysPage::groupOf(const QString &words)
{
    for (int g = 0; g < m_list->topLevelItemCount(); ++g)
        if (m_list->topLevelItem(g)->text(WordsColumn) == words)
            return m_list->topLevelItem(g);
    auto *group = new QTreeWidgetItem(m_list, {words});
    group->setFlags(Qt::ItemIsEnabled);
    group->setFirstColumnSpanned(true);
    group->setExpanded(true);
    return group;
}

void KeysPage::filter()
{
    const QString wanted = m_search->text().trimmed();
    for (int g = 0; g < m_list->topLevelItemCount(); ++g) {
        QTreeWidgetItem *group = m_list->topLevelItem(g);
        int shown = 0;
        for (int i = 0; i < group->childCount(); ++i) {
            QTreeWidgetItem *item = group->child(i);
            const bool hit = item->text(WordsColumn).contains(wanted, Qt::CaseInsensitive) ||
                             item->text(KeyColumn).contains(wanted, Qt::CaseInsensitive);
            item->setHidden(!hit);
            shown += hit;
        }
        group->setHidden(shown == 0);
    }
}

QString KeysPage::chosen() const
{
    const QTreeWidgetItem *item = m_list->currentItem();
    return item ? item->data(WordsColumn, nameRole).toString() : QString();
}

void KeysPage::showChosen()
{
    m_key->clear();
    warn();
}

void KeysPage::warn()
{
    const QKeySequence key = m_key->keySequence();
    const CommandKeys::Command *other = m_keys.commandOf(key);
    const bool isOther = other && other->name != chosen();
    m_key->setEnabled(!chosen().isEmpty());
    m_none->setEnabled(!chosen().isEmpty());
    m_assign->setEnabled(!chosen().isEmpty() && !key.isEmpty());
    if (chosen().isEmpty())
        m_warning->setText(tr("Select a command to change its key."));
    else if (isOther)
        m_warning->setText(tr("%1 is the key of “%2”. That command would lose it.")
                               .arg(key.toString(QKeySequence::NativeText), other->words));
    else
        m_warning->setText(key.isEmpty() ? tr("Press the new key in the field.") : QString());
}

void KeysPage::assign()
{
    const QKeySequence key = m_key->keySequence();
    m_keys.setKey(chosen(), key[0]); // one chord: two in a row are beyond anybody in a hurry
}

} // namespace odo
