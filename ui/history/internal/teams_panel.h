// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/workflow/compare/trial_metrics.h"
#include "ui/views/charts/chart_view.h"

#include <QWidget>
#include <memory>
#include <set>
#include <string>

class QComboBox;
class QTableView;

namespace odo {

class Card;
class Project;
class ProjectReader;
struct CountedTrials;
class StandingsModel;
class TrendChart;

/// The standings of a class: best, median, repeatability and progress by a chosen metric, and the term of the
/// team that is selected. Reads the project on a thread of its own; the trials it is given.
class TeamsPanel : public QWidget
{
    Q_OBJECT
public:
    explicit TeamsPanel(Project &project, QWidget *parent = nullptr);
    ~TeamsPanel() override;
    /// Reads the project; trialsWanted follows.
    void refresh();
    /// trials: all that are known; they are used until this returns. In answer to trialsWanted.
    void showTrials(std::span<const TrialRecord *const> trials);
    /// Nothing is being read.
    bool isSettled() const;

Q_SIGNALS:
    /// What was chosen is read, and there are trials to be shown by it.
    void trialsWanted();
    void failed(const odo::Error &error);

private:
    struct Reading;
    static Result<Reading> readMetrics(Project &project, const StandingsChoice &choice);
    StandingsChoice choice() const;
    void take(Result<Reading> reading);
    QComboBox *addChoice(const QString &name);
    void offer();
    void showRemark(const CountedTrials &counted);
    void showTeam();

    ProjectReader *m_reader;
    std::unique_ptr<Reading> m_read; ///< null: nothing yet
    StandingsModel *m_model;
    Card *m_card;
    QComboBox *m_class = nullptr, *m_task = nullptr, *m_metric = nullptr;
    QTableView *m_table;
    TrendChart *m_chart;
    bool m_isTaskOffered = false;
    std::set<std::string> m_archived; ///< classes; their teams appear only if the class is chosen
};

/// A team's runs through the term: a point each, the line of progress through them, and the band of the
/// spread about it. Its accessible description says the same in words.
class TrendChart : public ChartView
{
    Q_OBJECT
public:
    explicit TrendChart(QWidget *parent = nullptr);
    /// nullptr: no team. name: the team's, as it is shown.
    void setTeam(const TeamStanding *team, const QString &name, const QString &progress);

    QSize sizeHint() const override { return {600, 190}; }
    QSize minimumSizeHint() const override { return {240, 120}; }

private:
    QString m_name;
};

} // namespace odo
