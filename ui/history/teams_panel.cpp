// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/teams_panel.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/history/filter_choice.h"
#include "ui/history/trend_chart.h"
#include "ui/models/figure_text.h"
#include "ui/models/metric_choice.h"
#include "ui/models/standings_model.h"
#include "ui/views/card.h"
#include "ui/views/table_list.h"

#include <QComboBox>
#include <QHeaderView>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {
TeamsPanel::TeamsPanel(Project &project, QWidget *parent)
    : QWidget(parent), m_project(project), m_model(new StandingsModel(this)),
      m_card(new Card(tr("Teams"), this)), m_table(new QTableView), m_chart(new TrendChart)
{
    m_class = addChoice(tr("Class"));
    m_class->addItem(tr("All classes"), QString());
    m_task = addChoice(tr("Task"));
    m_task->addItem(tr("Any task"), QString());
    m_metric = addChoice(tr("Figure"));
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("How the teams stand"));
    showAsList(*m_table);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setStretchLastSection(true);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &TeamsPanel::showTeam);
    auto *splitter = new QSplitter(Qt::Vertical);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(m_table);
    splitter->addWidget(m_chart);
    splitter->setStretchFactor(0, 1);
    m_card->setContent(splitter);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_card);
}

QComboBox *TeamsPanel::addChoice(const QString &name)
{
    auto *choice = new QComboBox;
    choice->setAccessibleName(name);
    choice->setToolTip(name);
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(12);
    m_card->addToHeader(choice);
    connect(choice, &QComboBox::currentIndexChanged, this, &TeamsPanel::choiceChanged);
    return choice;
}

void TeamsPanel::offer()
{
    QStringList classes, tasks, metrics, metricNames;
    for (const std::string &name : m_project.teams().classes().value_or(std::vector<std::string>()))
        classes << QString::fromStdString(name);
    for (const TaskRecord &task : m_project.tasks().all().value_or(std::vector<TaskRecord>()))
        tasks << QString::fromStdString(task.name);
    std::vector<Metric> known;
    for (const std::string &name : m_project.analyses().metricNames().value_or(std::vector<std::string>()))
        known.push_back({name, {}, 0, {}});
    for (const Metric &metric : tellingMetrics(known, known.size())) {
        metrics << QString::fromStdString(metric.name);
        metricNames << metricName(metric.name);
    }
    fillChoice(*m_class, classes, classes, 1);
    fillChoice(*m_task, tasks, tasks, 1);
    fillChoice(*m_metric, metrics, metricNames, 0);
}

void TeamsPanel::showTrials(std::span<const TrialRecord *const> trials, bool pseudonyms)
{
    offer();
    const QModelIndex current = m_table->currentIndex();
    const std::string selected = current.isValid() ? m_model->team(current.row()).team : std::string();
    const StandingsChoice choice{chosenWord(*m_class), chosenWord(*m_task), chosenWord(*m_metric)};
    const auto figures = m_project.analyses().figures(choice.metric, Instant::min(), Instant::max());
    if (!figures) {
        Q_EMIT failed(figures.error());
        return;
    }
    m_model->setStandings(standingsOf(trials, *figures, choice), pseudonyms);
    m_table->resizeColumnsToContents();
    const auto &teams = m_model->standings().teams;
    const auto same = std::ranges::find(teams, selected, &TeamStanding::team);
    if (!teams.empty())
        m_table->setCurrentIndex(
            m_model->index(same == teams.end() ? 0 : static_cast<int>(same - teams.begin()), 0));
    m_card->setRemark(teams.empty() ? tr("No team has a tracked trial here")
                                    : tr("%1 teams").arg(teams.size()));
    showTeam();
}

void TeamsPanel::showTeam()
{
    const QModelIndex current = m_table->currentIndex();
    if (!current.isValid()) {
        m_chart->setTeam(nullptr, {}, {});
        return;
    }
    const TeamStanding &team = m_model->team(current.row());
    m_chart->setTeam(&team, m_model->teamName(current.row()), progressText(team, m_model->standings()));
}

} // namespace odo
