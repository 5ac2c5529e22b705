// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/internal/results_panel.h"

#include "core/files/output_file.h"
#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/workflow/trials/trial_table_reading.h"
#include "ui/history/internal/own_metrics_dialog.h"
#include "ui/history/internal/result_statistics_model.h"
#include "ui/history/internal/results_model.h"
#include "ui/history/internal/trial_list.h"
#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/table_list.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSplitter>
#include <QStandardPaths>
#include <QTimer>
#include <algorithm>
#include <array>
#include <set>
#include <span>

namespace odo {

namespace {

const QString shownMetricsKey = QStringLiteral("results/metrics"), groupKey = QStringLiteral("results/group");
const QString groupPrefix = QStringLiteral("variable:");
constexpr qsizetype usualMetrics = 5;

std::vector<int> selectedRows(const QTableView &table)
{
    std::vector<int> rows;
    for (const QModelIndex &index : table.selectionModel()->selectedRows())
        rows.push_back(index.row());
    std::ranges::sort(rows);
    return rows;
}

QTableView *makeTable(QAbstractItemModel &model, const QString &name)
{
    auto *table = new QTableView;
    table->setModel(&model);
    table->setAccessibleName(name);
    showAsList(*table);
    table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table->setWordWrap(false);
    table->setContextMenuPolicy(Qt::ActionsContextMenu);
    table->horizontalHeader()->setResizeContentsPrecision(0); // of what is on screen, not of thousands
    return table;
}

} // namespace

/// All that is shown, read at once.
struct ResultsPanel::Reading
{
    std::shared_ptr<const ResultTable> table;
    QStringList classes, tasks, metrics;
};

ResultsPanel::ResultsPanel(Project &project, QWidget *parent)
    : QWidget(parent), m_reader(new ProjectReader(project.file(), this)), m_project(project),
      m_model(new ResultsModel(this)), m_statistics(new ResultStatisticsModel(this)),
      m_metrics(QSettings().value(shownMetricsKey).toStringList()), m_card(new Card(tr("Results"), this)),
      m_class(makeChoice(tr("Class"), 8)), m_task(makeChoice(tr("Task"), 8)),
      m_groups(makeChoice(tr("Group by"), 10)), m_search(new QLineEdit),
      m_metricButton(new QPushButton(tr("Metrics"))), m_metricMenu(new QMenu(this)),
      m_table(makeTable(*m_model, tr("Results of the trials"))),
      m_statisticsTable(makeTable(*m_statistics, tr("Statistics"))), m_statisticsTitle(new QLabel),
      m_statisticsTimer(new QTimer(this))
{
    makeHeader();
    makeTables();
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_card);
    m_statisticsTimer->setSingleShot(true);
    m_statisticsTimer->setInterval(0); // once for all that a click changes
    connect(m_statisticsTimer, &QTimer::timeout, this, &ResultsPanel::showStatistics);
}

ResultsPanel::~ResultsPanel() = default;

void ResultsPanel::makeHeader()
{
    m_class->addItem(tr("Any class"), QString());
    m_task->addItem(tr("Any task"), QString());
    m_groups->addItem(tr("No groups"), QString());
    for (QComboBox *each : {m_class, m_task})
        connect(each, &QComboBox::currentIndexChanged, this, &ResultsPanel::filter);
    connect(m_groups, &QComboBox::currentIndexChanged, this, [this] {
        QSettings().setValue(groupKey, m_groups->currentData());
        m_statisticsTimer->start();
    });
    m_search->setPlaceholderText(tr("Search…"));
    m_search->setAccessibleName(tr("Search the results"));
    m_search->setToolTip(tr("Trials, teams, robots, tags and variables with all of these words"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(themeIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    connect(m_search, &QLineEdit::textChanged, this, &ResultsPanel::filter);
    m_metricButton->setAutoDefault(false);
    m_metricButton->setToolTip(tr("Which metrics are shown"));
    m_metricButton->setAccessibleName(tr("Which metrics are shown"));
    m_metricButton->setFocusPolicy(Qt::StrongFocus);
    m_metricButton->setMenu(m_metricMenu);
    auto *save = new QPushButton(themeIcon(QStringLiteral("export")), tr("&Save table…"));
    save->setAutoDefault(false);
    connect(save, &QPushButton::clicked, this, &ResultsPanel::askSave);
    m_card->addToHeader(m_search);
    m_card->addToHeader(save);
}

void ResultsPanel::makeTables()
{
    m_table->setObjectName(QStringLiteral("results"));
    m_table->setItemDelegateForColumn(
        ResultsModel::VerdictColumn,
        new BadgeDelegate(ResultsModel::BadgeTextRole, ResultsModel::BadgeStateRole, m_table));
    m_table->sortByColumn(ResultsModel::DateColumn, Qt::DescendingOrder);
    for (QTableView *table : {m_table, m_statisticsTable}) {
        table->viewport()->installEventFilter(this);
        table->setSortingEnabled(true);
        table->installEventFilter(this);
        auto *copyAction = new QAction(tr("&Copy with headings"), table);
        copyAction->setShortcut(QKeySequence::Copy);
        copyAction->setShortcutContext(Qt::WidgetShortcut);
        connect(copyAction, &QAction::triggered, this, [this, table] { copy(*table); });
        table->addAction(copyAction);
    }
    m_statisticsTable->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    connect(m_table, &QTableView::doubleClicked, this,
            [this](const QModelIndex &index) { Q_EMIT trialChosen(m_model->trialAt(index.row())); });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, m_statisticsTimer,
            qOverload<>(&QTimer::start));
    auto *bar = new QWidget;
    auto *row = new QHBoxLayout(bar);
    row->setContentsMargins(10, 6, 10, 6);
    for (QComboBox *each : {m_class, m_task, m_groups}) {
        each->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(each);
    }
    row->addWidget(m_metricButton);
    m_statisticsTitle->setObjectName(QStringLiteral("quiet"));
    m_statisticsTitle->setContentsMargins(10, 6, 10, 4);
    m_statisticsTitle->setWordWrap(true);
    auto *lower = new QWidget;
    auto *column = new QVBoxLayout(lower);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_statisticsTitle);
    column->addWidget(m_statisticsTable, 1);
    auto *splitter = new QSplitter(Qt::Vertical);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(m_table);
    splitter->addWidget(lower);
    splitter->setStretchFactor(0, 2);
    splitter->setStretchFactor(1, 1);
    auto *content = new QWidget;
    auto *all = new QVBoxLayout(content);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addWidget(bar);
    all->addWidget(splitter, 1);
    m_card->setContent(content);
}

bool ResultsPanel::isSettled() const
{
    return !m_reader->isRunning() && !m_saving.isRunning() && !m_statisticsTimer->isActive();
}

void ResultsPanel::refresh()
{
    m_reader->read<Reading>(
        [own = storedOwnMetrics()](Project &project) -> Result<Reading> {
            Reading reading;
            const auto table = std::make_shared<ResultTable>(ODO_TRY(readTrialTable(project, {})));
            for (const OwnMetric &metric : own) // those that this project has nothing for are left out
                (void)addOwnMetrics(*table, std::span(&metric, 1));
            reading.table = table;
            std::set<std::string> classes, tasks, metrics;
            for (const TrialTableRow &row : reading.table->rows) {
                classes.insert(row.trial.className);
                tasks.insert(row.trial.task);
            }
            for (const std::string &name : classes)
                if (!name.empty())
                    reading.classes << QString::fromStdString(name);
            for (const std::string &name : tasks)
                if (!name.empty())
                    reading.tasks << QString::fromStdString(name);
            for (const TrialTableColumn &column : reading.table->columns)
                metrics.insert(column.metric);
            for (const std::string &name : informativeMetricNames({metrics.begin(), metrics.end()}))
                reading.metrics << QString::fromStdString(name);
            return reading;
        },
        [this](Result<Reading> reading) { take(std::move(reading)); });
}

void ResultsPanel::take(Result<Reading> reading)
{
    if (!reading) {
        Q_EMIT failed(reading.error());
        return;
    }
    m_model->setTable(reading->table);
    fillChoice(*m_class, reading->classes, reading->classes);
    fillChoice(*m_task, reading->tasks, reading->tasks);
    QStringList groups{QStringLiteral("team"), QStringLiteral("class"), QStringLiteral("task"),
                       QStringLiteral("robot")},
        shown{tr("By team"), tr("By class"), tr("By task"), tr("By robot")};
    for (const std::string &variable : reading->table->variables) {
        groups << groupPrefix + QString::fromStdString(variable);
        shown << tr("By %1").arg(QString::fromStdString(variable));
    }
    if (m_groups->count() == 1) { // the first time
        fillChoice(*m_groups, groups, shown);
        const QSignalBlocker quiet(m_groups);
        m_groups->setCurrentIndex(std::max(0, m_groups->findData(QSettings().value(groupKey))));
    } else {
        fillChoice(*m_groups, groups, shown);
    }
    if (m_metrics.isEmpty())
        m_metrics = reading->metrics.mid(0, usualMetrics);
    offerMetrics();
    showMetrics();
    filter();
    Q_EMIT settled();
}

/// All that the table has, as it has them.
void ResultsPanel::offerMetrics()
{
    m_metricMenu->clear();
    QStringList names;
    for (const TrialTableColumn &column : m_model->table()->columns)
        if (const QString name = QString::fromStdString(column.metric); !names.contains(name))
            names << name;
    for (const QString &name : names) {
        QAction *action =
            m_metricMenu->addAction(metricName(name.toStdString()).replace(u'&', QStringLiteral("&&")));
        action->setCheckable(true);
        action->setChecked(m_metrics.contains(name));
        connect(action, &QAction::toggled, this,
                [this, name](bool isChosen) { chooseMetric(name, isChosen); });
    }
    m_metricMenu->addSeparator();
    connect(m_metricMenu->addAction(tr("&Own metrics…")), &QAction::triggered, this,
            &ResultsPanel::askOwnMetrics);
}

/// New ones are shown.
void ResultsPanel::askOwnMetrics()
{
    const std::vector<OwnMetric> before = storedOwnMetrics();
    OwnMetricsDialog dialog(*m_model->table(), before, this);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const std::vector<OwnMetric> metrics = dialog.metrics();
    storeOwnMetrics(metrics);
    for (const OwnMetric &metric : metrics)
        if (const QString name = QString::fromStdString(metric.name);
            std::ranges::find(before, metric.name, &OwnMetric::name) == before.end() &&
            !m_metrics.contains(name))
            m_metrics << name;
    QSettings().setValue(shownMetricsKey, m_metrics);
    refresh();
}

void ResultsPanel::chooseMetric(const QString &name, bool isChosen)
{
    m_metrics.removeAll(name);
    if (isChosen)
        m_metrics << name;
    QSettings().setValue(shownMetricsKey, m_metrics);
    showMetrics();
}

void ResultsPanel::showMetrics()
{
    const std::vector<TrialTableColumn> &columns = m_model->table()->columns;
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (m_metrics.contains(QString::fromStdString(columns[i].metric)))
            shown.push_back(i);
    m_model->setMetrics(std::move(shown));
    fit();
    m_statisticsTimer->start();
}

void ResultsPanel::filter()
{
    m_model->setFilter({chosenWord(*m_class), chosenWord(*m_task), m_search->text()});
    const auto shown = static_cast<int>(m_model->shownRows().size());
    const auto all = static_cast<int>(m_model->table()->rows.size());
    m_card->setRemark(shown == all ? tr("%n run(s)", "", all) : tr("%1 of %n run(s)", "", all).arg(shown));
    fit();
    m_statisticsTimer->start();
}

ResultGrouping ResultsPanel::grouping() const
{
    using By = ResultGrouping::By;
    const QString word = m_groups->currentData().toString();
    if (word.startsWith(groupPrefix))
        return {By::Variable, word.mid(groupPrefix.size()).toStdString()};
    for (const auto &[name, by] : {std::pair{"team", By::Team}, std::pair{"class", By::Class},
                                   std::pair{"task", By::Task}, std::pair{"robot", By::Robot}})
        if (word == QLatin1String(name))
            return {by, {}};
    return {};
}

/// The selected ones, or all that are shown where no two are selected.
std::vector<std::size_t> ResultsPanel::countedRows() const
{
    const std::vector<int> selected = selectedRows(*m_table);
    if (selected.size() < 2)
        return m_model->shownRows();
    std::vector<std::size_t> rows;
    for (const int row : selected)
        rows.push_back(m_model->shownRows()[static_cast<std::size_t>(row)]);
    return rows;
}

void ResultsPanel::showStatistics()
{
    const std::vector<std::size_t> rows = countedRows();
    const ResultGrouping by = grouping();
    m_statistics->setStatistics(resultStatistics(*m_model->table(), rows, m_model->metrics(), by),
                                m_model->table()->columns, by.by == ResultGrouping::By::Team);
    m_statisticsTable->setColumnHidden(ResultStatisticsModel::GroupColumn,
                                       by.by == ResultGrouping::By::Nothing);
    fitStatistics();
    const auto count = static_cast<int>(rows.size());
    m_statisticsTitle->setText(rows.size() == m_model->shownRows().size()
                                   ? tr("Statistics of %n run(s) shown", "", count)
                                   : tr("Statistics of %n selected run(s)", "", count));
    Q_EMIT settled();
}

void ResultsPanel::fitStatistics()
{
    fitColumns(*m_statisticsTable, ResultStatisticsModel::MetricColumn,
               {ResultStatisticsModel::MetricColumn, ResultStatisticsModel::GroupColumn});
}

void ResultsPanel::updateTeams()
{
    m_model->setTable(m_model->table());
    showMetrics();
}

/// What is selected in a table, or all of it.
void ResultsPanel::copy(QTableView &table)
{
    std::vector<int> rows = selectedRows(table);
    if (rows.empty())
        for (int row = 0; row < table.model()->rowCount(); ++row)
            rows.push_back(row);
    QApplication::clipboard()->setText(&table == m_table ? m_model->tabbed(rows)
                                                         : m_statistics->tabbed(rows));
}

void ResultsPanel::askSave()
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    const QString csv = QStringLiteral("csv"), xlsx = QStringLiteral("xlsx");
    const auto chosen =
        askOutput(this, tr("Save the table"), folder.filePath(tr("Results") + QStringLiteral(".xlsx")),
                  {{tr("Workbook with statistics (*.xlsx)"), xlsx, FileKind::Xlsx, true},
                   {tr("CSV for programs (*.csv)"), csv, FileKind::Csv, true},
                   {tr("CSV for spreadsheets, 1.5 (*.csv)"), csv, FileKind::Csv, true},
                   {tr("CSV for spreadsheets, 1,5 (*.csv)"), csv, FileKind::Csv, true}});
    if (chosen)
        save(*chosen);
}

/// On a thread of its own: a workbook of ten thousand trials takes seconds.
void ResultsPanel::save(const ChosenOutput &output)
{
    const auto table = std::make_shared<ResultTable>(m_model->shownTable());
    table->statistics = m_statistics->statistics();
    for (ResultStatistics &each : table->statistics)
        each.column = static_cast<std::size_t>(std::ranges::find(m_model->metrics(), each.column) -
                                               m_model->metrics().begin());
    disconnect(&m_saving, &BackgroundTask::finished, this, nullptr);
    connect(&m_saving, &BackgroundTask::finished, this,
            [this, file = output.file](const std::optional<Error> &error) {
                if (error)
                    Q_EMIT failed(*error);
                else
                    Q_EMIT saved(file);
                Q_EMIT settled();
            });
    const bool started = m_saving.start([table, output](const JobControl &) -> Result<void> {
        constexpr std::array styles{CsvStyle::Analysis, CsvStyle::International, CsvStyle::Continental};
        if (output.format == 0)
            return writeTrialTableXlsx(*table, output.target);
        const CsvStyle style = styles.at(static_cast<std::size_t>(output.format) - 1);
        return writeOutput(output.target,
                           [&](const TextSink &sink) { return writeTrialTableCsv(*table, style, sink); });
    });
    if (!started)
        Q_EMIT failed({ErrorCode::InvalidInput, ODO_TEXT("ui.saving_table", "saving the table"),
                       ODO_TEXT("ui.table_being_saved", "another table is still being saved"),
                       ODO_TEXT("ui.save_again", "save it again in a moment")});
}

/// Names may be long; numbers are never cut, the table scrolls instead. What all runs have in common needs no
/// column.
void ResultsPanel::fit()
{
    for (const int column : {ResultsModel::ClassColumn, ResultsModel::TaskColumn, ResultsModel::RobotColumn})
        m_table->setColumnHidden(column, m_model->isAlike(column));
    m_table->resizeColumnsToContents();
    QHeaderView &header = *m_table->horizontalHeader();
    const int widest = 22 * m_table->fontMetrics().averageCharWidth();
    for (int column = ResultsModel::TrialColumn; column <= ResultsModel::RobotColumn; ++column)
        header.resizeSection(column, std::min(header.sectionSize(column), widest));
    if (const int spare = m_table->viewport()->width() - header.length(); spare > 0)
        header.resizeSection(ResultsModel::TrialColumn,
                             header.sectionSize(ResultsModel::TrialColumn) + spare);
}

bool ResultsPanel::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_table->viewport() && event->type() == QEvent::Resize)
        fit();
    if (watched == m_statisticsTable->viewport() && event->type() == QEvent::Resize)
        fitStatistics(); // a scroll bar came
    if (watched == m_table && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        if ((key == Qt::Key_Return || key == Qt::Key_Enter) && m_table->currentIndex().isValid()) {
            Q_EMIT trialChosen(m_model->trialAt(m_table->currentIndex().row()));
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace odo
