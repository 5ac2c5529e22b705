// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/help/help_actions.h"

#include "ui/main_window/help/first_lesson.h"
#include "ui/main_window/help/help_dialogs.h"
#include "ui/main_window/help/help_panel.h"
#include "ui/main_window/project_pages.h"
#include "ui/models/timeline.h"
#include "ui/review/review_page.h"
#include "ui/views/command_names.h"

#include <QMenu>

namespace odo {

HelpActions::HelpActions(const CommandKeys &keys, HelpPanel &panel, QWidget &window)
    : QObject(&window), m_keys(keys), m_panel(panel), m_window(window), m_lesson(new Lesson(this)),
      m_help(new QAction(tr("&Help on this page"), this)), m_learn(new QAction(tr("&First lesson"), this)), m_showKeys(new QAction(tr("&Keys"), this)),
      m_about(new QAction(tr("&About Odograph"), this))
{
    nameCommands({{m_help, "help"}, {m_learn, "lesson"}, {m_showKeys, "keys"}});
    m_help->setCheckable(true);
    m_help->setShortcut(QKeySequence(Qt::Key_F1));
    m_showKeys->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_F1));
    m_panel.hide();
    connect(m_help, &QAction::toggled, &m_panel, &QWidget::setVisible);
    connect(&m_panel, &HelpPanel::closed, this, [this] { m_help->setChecked(false); });
    connect(m_learn, &QAction::triggered, this, &HelpActions::beginLesson);
    connect(m_showKeys, &QAction::triggered, this, [this] { showKeys(m_keys, m_window); });
    connect(m_about, &QAction::triggered, this, [this] { showAbout(m_window); });
    showPage();
}

void HelpActions::fillMenu(QMenu &menu)
{
    menu.addActions({m_help, m_learn, m_showKeys});
    menu.addSeparator();
    menu.addAction(m_about);
}

void HelpActions::setPages(const ProjectPages *pages)
{
    m_pages = pages;
    showPage();
    if (!pages) {
        m_lesson->stop();
        return;
    }
    connect(pages, &ProjectPages::shown, this, &HelpActions::showPage);
    connect(pages, &ProjectPages::shown, m_lesson, &Lesson::look, Qt::QueuedConnection); // it stands there then
    connect(&pages->review(), &ReviewPage::trialShown, m_lesson, &Lesson::look);
    connect(&pages->review().timeline(), &Timeline::currentChanged, m_lesson, &Lesson::look);
}

void HelpActions::showPage()
{
    m_panel.showPage(m_pages ? modeWord(m_pages->mode()) : QStringLiteral("welcome"));
}

void HelpActions::beginLesson()
{
    if (m_pages)
        m_lesson->start(firstLesson(*m_pages));
    else
        Q_EMIT demoWanted();
}

} // namespace odo
