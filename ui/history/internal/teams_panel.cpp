// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/internal/teams_panel.h"

#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/compare/trial_metrics.h"
#include "ui/history/internal/trial_list.h"
#include "ui/models/background_task.h"
#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/views/charts/chart_axis.h"
#include "ui/views/charts/chart_image.h"
#include "ui/views/curves/comparison_curves.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/table_list.h"

#include <QComboBox>
#include <QHeaderView>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace odo {

/// What a choice gave, and what can be chosen.
struct TeamsPanel::Reading
{
    StandingsChoice choice;
    std::vector<ClassRecord> classes;
    std::vector<TaskRecord> tasks;
    bool isAnyScored = false;
    std::vector<std::string> metrics;
    std::vector<TrialMetric> trialMetrics;
    CountingGrounds grounds;
};

TeamsPanel::TeamsPanel(Project &project, QWidget *parent)
    : QWidget(parent), m_reader(new ProjectReader(project.file(), this)), m_model(new StandingsModel(this)),
      m_card(new Card(tr("Teams"), this)), m_table(new QTableView), m_chart(new TrendChart)
{
    m_class = addChoice(tr("Class"));
    m_class->addItem(tr("All classes"), QString());
    m_task = addChoice(tr("Task"));
    m_task->addItem(tr("Any task"), QString());
    m_metric = addChoice(tr("Metric"));
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("Standings"));
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
    for (QComboBox *each : {m_class, m_task, m_metric})
        connect(each, &QComboBox::currentIndexChanged, this, &TeamsPanel::refresh);
}

TeamsPanel::~TeamsPanel() = default;

bool TeamsPanel::isSettled() const
{
    return !m_reader->isRunning();
}

StandingsChoice TeamsPanel::choice() const
{
    return {chosenWord(*m_class), chosenWord(*m_task), chosenWord(*m_metric)};
}

/// On the reader's thread.
Result<TeamsPanel::Reading> TeamsPanel::readMetrics(Project &project, const StandingsChoice &choice)
{
    auto classes = project.classes().all();
    auto tasks = project.tasks().current();
    auto metrics = project.analyses().metricNames();
    auto grounds = countingGrounds(project, choice.className, choice.task);
    const auto scorings = project.tasks().scorings();
    auto trialMetrics = metricsOf(project, choice.metric);
    for (const auto &[isRead, error] :
         {std::pair{classes.has_value(), classes ? Error{} : classes.error()},
          std::pair{tasks.has_value(), tasks ? Error{} : tasks.error()},
          std::pair{metrics.has_value(), metrics ? Error{} : metrics.error()},
          std::pair{grounds.has_value(), grounds ? Error{} : grounds.error()},
          std::pair{scorings.has_value(), scorings ? Error{} : scorings.error()},
          std::pair{trialMetrics.has_value(), trialMetrics ? Error{} : trialMetrics.error()}})
        if (!isRead)
            return tl::unexpected(error);
    return Reading{choice,
                   std::move(*classes),
                   std::move(*tasks),
                   !scorings->empty(),
                   std::move(*metrics),
                   std::move(*trialMetrics),
                   std::move(*grounds)};
}

void TeamsPanel::refresh()
{
    m_reader->read<Reading>([wanted = choice()](Project &project) { return readMetrics(project, wanted); },
                            [this](Result<Reading> reading) { take(std::move(reading)); });
}

void TeamsPanel::take(Result<Reading> reading)
{
    if (!reading) {
        Q_EMIT failed(reading.error());
        return;
    }
    m_read = std::make_unique<Reading>(std::move(*reading));
    offer();
    const StandingsChoice now = choice();
    if (now.className != m_read->choice.className || now.task != m_read->choice.task ||
        now.metric != m_read->choice.metric)
        refresh(); // what was chosen is not there any more, or something can be chosen now
    else
        Q_EMIT trialsWanted();
}

QComboBox *TeamsPanel::addChoice(const QString &name)
{
    QComboBox *choice = makeChoice(name, 12);
    m_card->addToHeader(choice);
    return choice;
}

void TeamsPanel::offer()
{
    QStringList classes, classesShown, tasks, metrics, metricNames;
    m_archived.clear();
    for (const ClassRecord &each : m_read->classes) {
        classes << QString::fromStdString(each.name);
        classesShown << (each.archived ? tr("%1 (archived)").arg(classes.back()) : classes.back());
        if (each.archived)
            m_archived.insert(each.name);
    }
    for (const TaskRecord &task : m_read->tasks)
        tasks << QString::fromStdString(task.name);
    if (m_read->isAnyScored) {
        metrics << QString::fromLatin1(scoreMetric);
        metricNames << metricName(scoreMetric);
    }
    for (const std::string &name : informativeMetricNames(m_read->metrics)) {
        metrics << QString::fromStdString(name);
        metricNames << metricName(name);
    }
    fillChoice(*m_class, classes, classesShown, 1);
    fillChoice(*m_task, tasks, tasks, 1);
    fillChoice(*m_metric, metrics, metricNames, 0);
    if (!std::exchange(m_isTaskOffered, m_isTaskOffered || !tasks.isEmpty()) && m_task->count() > 1) {
        const QSignalBlocker quiet(m_task);
        m_task->setCurrentIndex(1); // a ranking needs one task
    }
}

void TeamsPanel::showTrials(std::span<const TrialRecord *const> trials)
{
    if (!m_read)
        return;
    const QModelIndex current = m_table->currentIndex();
    const std::string selected = current.isValid() ? m_model->team(current.row()).team : std::string();
    const StandingsChoice &choice = m_read->choice;
    std::vector<const TrialRecord *> present(trials.begin(), trials.end());
    if (choice.className.empty())
        std::erase_if(present,
                      [this](const TrialRecord *trial) { return m_archived.contains(trial->className); });
    const CountedTrials counted = countedTrials(present, choice.className, choice.task, m_read->grounds);
    m_model->setStandings(standingsOf(counted.trials, m_read->trialMetrics, choice, counted.doubtful));
    m_table->resizeColumnsToContents();
    const auto &teams = m_model->standings().teams;
    const auto same = std::ranges::find(teams, selected, &TeamStanding::team);
    if (!teams.empty())
        m_table->setCurrentIndex(
            m_model->index(same == teams.end() ? 0 : static_cast<int>(same - teams.begin()), 0));
    showRemark(counted);
    showTeam();
}

/// What is seen, and what of it is not.
void TeamsPanel::showRemark(const CountedTrials &counted)
{
    const auto count = static_cast<int>(m_model->standings().teams.size());
    QStringList words(count == 0 ? tr("No team has a result for this metric") : tr("%n team(s)", "", count));
    if (!m_model->standings().isRanked() && count > 0)
        words << tr("choose a task to rank them: runs of different tasks cannot be compared");
    if (m_model->standings().isRanked() && count > 1)
        words << tr("teams that do not differ significantly share a rank");
    if (counted.leftOut > 0)
        words << tr("%n trial(s) not counted: analysed with a different course. Reanalyse them", "",
                    counted.leftOut);
    if (counted.bad > 0)
        words << tr("%n trial(s) not counted: bad results", "", counted.bad);
    m_card->setRemark(words.join(QStringLiteral(" · ")));
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

TrendChart::TrendChart(QWidget *parent) : ChartView(*new AxisSpan, {}, parent)
{
    span().setParent(this);
    setAccessibleName(tr("Progress of the team"));
    new ChartImage(*this, [this] { return ImageHeading{accessibleName(), {m_name}, {}}; });
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void TrendChart::setTeam(const TeamStanding *team, const QString &name, const QString &progress)
{
    m_name = name;
    setAccessibleDescription(
        team ? tr("%1: %2 trials, progress: %3").arg(name).arg(team->runs.size()).arg(progress)
             : tr("No team is selected"));
    if (!team || team->runs.empty()) {
        auto nothing = std::make_shared<ChartContent>();
        nothing->emptyWords = tr("Select a team to see its results over the term.");
        showValues(std::nullopt);
        setContent(std::move(nothing));
        return;
    }
    const ChartDrawing trend = trendDrawing(*team);
    span().setWhole(trend.low, trend.high);
    setAxes(trend.axes);
    setContent(trend.content);
}

} // namespace odo
