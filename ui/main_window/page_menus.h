// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/main_window/project_pages.h"

#include <QMenu>

class QMenuBar;

namespace odo {

class ModeBar;
class TrialActions;
class ViewActions;

/// The menus View, Trial and Tools: what is always in them, and the actions of the pages, which come when a
/// page is made and go with it. GUI thread.
class PageMenus
{
public:
    /// The bar owns the menus, and must outlive them.
    PageMenus(QMenuBar &bar, const ModeBar &modes, ViewActions &views, TrialActions &trials);
    /// Of a page that was made.
    void add(ProjectPages &pages, WindowMode mode);
    /// What works on the list of trials can be chosen only where that is seen.
    void setShown(WindowMode mode) { m_history->setEnabled(mode == WindowMode::History); }
    /// Before the pages go.
    void clear();

private:
    QMenu *m_view, *m_trial, *m_spikes, *m_history, *m_record, *m_play, *m_tools;
};

} // namespace odo
