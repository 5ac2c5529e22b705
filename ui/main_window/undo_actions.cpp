// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/undo_actions.h"

#include "core/project/project.h"
#include "ui/main_window/workspace.h"
#include "ui/models/core_words.h"
#include "ui/views/command_names.h"

#include <QAction>
#include <QMenu>

namespace odo {
namespace {

/// So that words with an ampersand in them are shown, not taken as a key.
QString inMenu(QString words)
{
    constexpr int longest = 60;
    if (words.size() > longest)
        words = words.left(longest - 1) + u'…';
    return words.replace(u'&', QStringLiteral("&&"));
}

} // namespace

UndoActions::UndoActions(Workspace &workspace, QObject *parent)
    : QObject(parent), m_workspace(workspace), m_undo(new QAction(this)), m_redo(new QAction(this))
{
    nameCommands({{m_undo, "undo"}, {m_redo, "redo"}});
    m_undo->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Z));
    m_redo->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    connect(m_undo, &QAction::triggered, this, [this] { apply(&Project::undo, tr("Undone: %1.")); });
    connect(m_redo, &QAction::triggered, this, [this] { apply(&Project::redo, tr("Made again: %1.")); });
    m_undo->setText(tr("&Undo"));
    m_redo->setText(tr("&Redo"));
}

void UndoActions::fillMenu(QMenu &menu)
{
    menu.addActions({m_undo, m_redo});
    connect(&menu, &QMenu::aboutToShow, this, &UndoActions::showWords);
    // A disabled action has no key, and nobody says when there is something to undo again.
    connect(&menu, &QMenu::aboutToHide, this, [this] {
        m_undo->setEnabled(true);
        m_redo->setEnabled(true);
    });
}

void UndoActions::showWords()
{
    Q_EMIT aboutToLook();
    const Project *project = m_workspace.project();
    const QString undoWords = project ? shownWords(project->undoWords()) : QString();
    const QString redoWords = project ? shownWords(project->redoWords()) : QString();
    m_undo->setText(undoWords.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(inMenu(undoWords)));
    m_redo->setText(redoWords.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(inMenu(redoWords)));
    m_undo->setEnabled(!undoWords.isEmpty());
    m_redo->setEnabled(!redoWords.isEmpty());
}

void UndoActions::apply(Result<std::string> (Project::*what)(), const QString &sentence)
{
    Q_EMIT aboutToLook();
    Project *project = m_workspace.project();
    if (!project)
        return;
    if (m_workspace.isBusy()) {
        Q_EMIT failed({ErrorCode::InvalidInput, tr("undo").toStdString(),
                       tr("a job is running on the project").toStdString(),
                       tr("wait until it is done, or cancel it").toStdString()});
        return;
    }
    if (const Result<std::string> words = (project->*what)())
        Q_EMIT changed(sentence.arg(shownWords(*words)));
    else
        Q_EMIT failed(words.error());
}

} // namespace odo
