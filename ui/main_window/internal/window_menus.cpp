// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/window_menus.h"

#include "core/project/project.h"
#include "core/project/project_words.h"
#include "ui/history/history_page.h"
#include "ui/main_window/internal/trial_actions.h"
#include "ui/main_window/internal/window_bars.h"
#include "ui/main_window/workspace.h"
#include "ui/models/shown_message.h"
#include "ui/models/timeline.h"
#include "ui/record/record_page.h"
#include "ui/review/corrections.h"
#include "ui/review/guidance_tool.h"
#include "ui/review/range_actions.h"
#include "ui/review/review_page.h"
#include "ui/testbed/testbed_page.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/dock_desk.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>

namespace odo {

namespace {

class PageMenusWords
{
    Q_DECLARE_TR_FUNCTIONS(PageMenus)
};

void fill(QMenu &menu, const QList<QAction *> &actions)
{
    menu.addActions(actions);
    menu.setEnabled(true);
}

} // namespace

PageMenus::PageMenus(QMenuBar &bar, const ModeBar &modes, ViewActions &views, TrialActions &trials)
    : m_view(bar.addMenu(PageMenusWords::tr("&View"))), m_trial(bar.addMenu(PageMenusWords::tr("T&rial")))
{
    m_view->addActions(modes.modeActions());
    m_view->addSeparator();
    views.fillMenu(*m_view);
    m_view->addSeparator();
    trials.fillMenu(*m_trial);
    m_trial->addSeparator();
    m_range = m_trial->addMenu(PageMenusWords::tr("Ran&ge"));
    m_spikes = m_trial->addMenu(PageMenusWords::tr("&Spikes"));
    m_history = m_trial->addMenu(PageMenusWords::tr("&History"));
    m_record = m_trial->addMenu(PageMenusWords::tr("Re&cord"));
    m_play = m_trial->addMenu(PageMenusWords::tr("&Play"));
    m_tools = bar.addMenu(PageMenusWords::tr("&Tools"));
    clear();
}

void PageMenus::add(ProjectPages &pages, WindowMode mode)
{
    switch (mode) {
    case WindowMode::Start:
    case WindowMode::Compare:
        return;
    case WindowMode::Testbed:
        return fill(*m_tools, pages.testbed().toolActions());
    case WindowMode::Record:
        return fill(*m_record, pages.record().actions());
    case WindowMode::Review: {
        ReviewPage &review = pages.review();
        m_trial->insertActions(m_play->menuAction(),
                               {review.chooser().previousAction(), review.chooser().nextAction()});
        m_trial->insertAction(m_play->menuAction(), review.pointing().action());
        m_trial->insertActions(m_play->menuAction(), review.guidance().actions());
        fill(*m_range, review.range().actions());
        fill(*m_spikes, review.spikeActions());
        return fill(*m_play, review.timeline().actions());
    }
    case WindowMode::History:
        m_view->addAction(pages.history().pseudonyms());
        m_history->addActions(pages.history().listActions());
    }
}

void PageMenus::clear()
{
    for (QMenu *menu : {m_range, m_spikes, m_history, m_record, m_play, m_tools}) {
        menu->clear();
        menu->setEnabled(false);
    }
}

namespace {
const QString themeKey = QStringLiteral("theme");
}

ViewActions::ViewActions(QMainWindow &window)
    : QObject(&window), m_window(window), m_themes(new QActionGroup(this)),
      m_resetLayout(new QAction(tr("&Reset layout"), this)),
      m_fullScreen(new QAction(tr("&Full screen"), this)),
      m_theme(themeFromName(QSettings().value(themeKey).toString()))
{
    const auto addTheme = [this](Theme theme, const QString &text) {
        QAction *action = m_themes->addAction(text);
        action->setCheckable(true);
        action->setChecked(theme == m_theme);
        connect(action, &QAction::triggered, this, [this, theme] { chooseTheme(theme); });
    };
    addTheme(Theme::System, tr("Colours of the &desktop"));
    addTheme(Theme::Light, tr("&Light"));
    addTheme(Theme::Dark, tr("Da&rk"));
    nameCommands({{m_fullScreen, "fullScreen"}, {m_resetLayout, "resetLayout"}});
    m_fullScreen->setShortcut(QKeySequence(Qt::Key_F11));
    m_fullScreen->setCheckable(true);
    connect(m_fullScreen, &QAction::toggled, this,
            [this](bool full) { full ? m_window.showFullScreen() : m_window.showNormal(); });
    m_resetLayout->setEnabled(false);
    connect(m_resetLayout, &QAction::triggered, this, [this] { m_desk->resetLayout(); });
    if (m_theme != Theme::System)
        applyAppearance(*qApp, m_theme);
}

void ViewActions::fillMenu(QMenu &menu)
{
    m_menu = &menu;
    menu.addSeparator();
    menu.addActions({m_resetLayout, m_fullScreen});
    menu.addSeparator();
    menu.addActions(m_themes->actions());
}

void ViewActions::addAction(QAction *action)
{
    m_menu->insertAction(m_fullScreen, action);
}

void ViewActions::setDesk(DockDesk *desk, const QList<QAction *> &more)
{
    m_desk = desk;
    m_resetLayout->setEnabled(desk != nullptr);
    for (QAction *action : m_deskActions)
        m_menu->removeAction(action);
    m_deskActions = desk ? desk->dockActions() + more : QList<QAction *>();
    m_menu->insertActions(m_resetLayout, m_deskActions);
}

void ViewActions::chooseTheme(Theme theme)
{
    m_theme = theme;
    m_themes->actions().at(static_cast<int>(theme))->setChecked(true);
    QSettings().setValue(themeKey, themeName(theme));
    applyAppearance(*qApp, theme);
}

void ViewActions::followDesktop()
{
    if (m_theme == Theme::System)
        applyAppearance(*qApp, Theme::System);
}

namespace {

/// An ampersand in the text must be shown, not become a mnemonic.
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
    connect(m_redo, &QAction::triggered, this, [this] { apply(&Project::redo, tr("Redone: %1.")); });
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
    Q_EMIT aboutToSearch();
    const Project *project = m_workspace.project();
    const QString undoWords = project ? shownWords(project->undoWords()) : QString();
    const QString redoWords = project ? shownWords(project->redoWords()) : QString();
    m_undo->setText(undoWords.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(inMenu(undoWords)));
    m_redo->setText(redoWords.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(inMenu(redoWords)));
    m_undo->setEnabled(!undoWords.isEmpty());
    m_redo->setEnabled(!redoWords.isEmpty());
}

void UndoActions::apply(Result<Message> (Project::*what)(), const QString &sentence)
{
    Q_EMIT aboutToSearch();
    Project *project = m_workspace.project();
    if (!project)
        return;
    if (m_workspace.isBusy()) {
        Q_EMIT failed({ErrorCode::InvalidInput, undoSubject(),
                       ODO_TEXT("ui.job_runs_on_project", "a job is running on the project"),
                       waitOrCancel()});
        return;
    }
    if (const Result<Message> words = (project->*what)())
        Q_EMIT changed(sentence.arg(shownWords(*words)));
    else
        Q_EMIT failed(words.error());
}

} // namespace odo
