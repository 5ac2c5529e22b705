// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/workflow/standings.h"

#include <QWidget>
#include <set>
#include <string>

class QComboBox;
class QTableView;

namespace odo {

class Card;
class Project;
class StandingsModel;
class TrendChart;

/// How the teams of a class stand: best, median, repeatability and progress by a figure that is chosen, and
/// the term of the team that is selected. Uses the project on its own thread.
class TeamsPanel : public QWidget
{
    Q_OBJECT
public:
    explicit TeamsPanel(Project &project, QWidget *parent = nullptr);
    /// trials: all that are known; they are used until this returns.
    void showTrials(std::span<const TrialRecord *const> trials);

Q_SIGNALS:
    /// Another class, task or figure was chosen: the trials are wanted again.
    void choiceChanged();
    void failed(const odo::Error &error);

private:
    QComboBox *addChoice(const QString &name);
    void offer();
    void showRemark(int leftOut);
    void showTeam();

    Project &m_project;
    StandingsModel *m_model;
    Card *m_card;
    QComboBox *m_class = nullptr, *m_task = nullptr, *m_metric = nullptr;
    QTableView *m_table;
    TrendChart *m_chart;
    bool m_isTaskOffered = false;
    std::set<std::string> m_archived; ///< classes, whose teams stand nowhere unless theirs is chosen
};

} // namespace odo
