// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/page_menus.h"

#include "ui/history/history_page.h"
#include "ui/main_window/mode_bar.h"
#include "ui/main_window/trial_actions.h"
#include "ui/main_window/view_actions.h"
#include "ui/models/timeline.h"
#include "ui/record/record_page.h"
#include "ui/review/review_page.h"
#include "ui/review/robot_pointing.h"
#include "ui/review/spike_actions.h"
#include "ui/review/trial_chooser.h"
#include "ui/testbed/testbed_page.h"

#include <QCoreApplication>
#include <QMenuBar>

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
    case WindowMode::Testbed:
        return fill(*m_tools, pages.testbed().toolActions());
    case WindowMode::Record:
        return fill(*m_record, pages.record().actions());
    case WindowMode::Review: {
        ReviewPage &review = pages.review();
        m_trial->insertActions(m_play->menuAction(),
                               {review.chooser().previousAction(), review.chooser().nextAction()});
        m_trial->insertAction(m_play->menuAction(), review.pointing().action());
        fill(*m_spikes, review.spikes().actions());
        return fill(*m_play, review.timeline().actions());
    }
    case WindowMode::Compare:
        return;
    case WindowMode::History:
        m_view->addAction(pages.history().pseudonyms());
        m_history->addActions(pages.history().listActions());
    }
}

void PageMenus::clear()
{
    for (QMenu *menu : {m_spikes, m_history, m_record, m_play, m_tools}) {
        menu->clear();
        menu->setEnabled(false);
    }
}

} // namespace odo
