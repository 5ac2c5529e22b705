// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_page.h"

#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/job.h"
#include "core/workflow/track/stored_verdicts.h"
#include "ui/history/internal/mark_actions.h"
#include "ui/history/internal/results_panel.h"
#include "ui/history/internal/teams_panel.h"
#include "ui/history/internal/trial_columns.h"
#include "ui/history/internal/trial_list.h"
#include "ui/models/background_task.h"
#include "ui/models/shown_names.h"
#include "ui/models/trial_model.h"
#include "ui/school/hub_runs_panel.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

namespace odo {
namespace {

constexpr int rowsAtOnce = 300;             ///< that are read in far less than 50 ms
constexpr std::ptrdiff_t trialsAtOnce = 20; ///< whose verdicts are stored in one go

QToolButton *buttonOf(QAction *action)
{
    auto *button = new QToolButton;
    button->setDefaultAction(action);
    button->setProperty("flat", true);
    button->setToolButtonStyle(action->icon().isNull() ? Qt::ToolButtonTextOnly
                                                       : Qt::ToolButtonTextBesideIcon);
    button->setFocusPolicy(Qt::TabFocus);
    button->setVisible(false); // until it has a parent: a window of its own is not meant
    QObject::connect(action, &QAction::changed, button,
                     [button, action] { button->setVisible(action->isVisible()); });
    return button;
}

} // namespace

HistoryPage::HistoryPage(Project &project, bool readOnly, QWidget *parent)
    : QWidget(parent), m_project(project), m_readOnly(readOnly), m_trials(new TrialModel(this)),
      m_search(new QLineEdit(this)), m_compare(new QPushButton(tr("&Compare"), this)),
      m_filterBar(new TrialFilterBar(this)), m_marks(new MarkActions(project, *this)),
      m_pseudonyms(new QAction(tr("Teams by &pseudonym"), this)), m_table(new TrialTable(*m_trials, this)),
      m_columns(new TrialColumns(*m_trials, *m_table)), m_results(new ResultsPanel(project, this)),
      m_teams(new TeamsPanel(project, this)), m_hubRuns(new HubRunsPanel(this)), m_tabs(new QTabWidget(this)),
      m_detail(new TrialDetail(project, this)), m_checker(new ProjectReader(project.file(), this)),
      m_readTimer(new QTimer(this))
{
    setObjectName(QStringLiteral("page"));
    m_trials->setEditable(!readOnly);
    m_marks->setReadOnly(readOnly);

    auto *splitter = new QSplitter(this);
    splitter->setHandleWidth(8);
    splitter->setChildrenCollapsible(false);
    m_tabs->addTab(makeTable(), tr("Tr&ials"));
    m_tabs->addTab(m_results, tr("Res&ults"));
    m_tabs->addTab(m_teams, tr("Tea&ms"));
    m_tabs->addTab(m_hubRuns, tr("School hub"));
    setHub(std::nullopt);
    m_tabs->setDocumentMode(true);
    m_tabs->setAccessibleName(tr("Trials, results or teams"));
    splitter->addWidget(m_tabs);
    splitter->addWidget(m_detail);
    splitter->setStretchFactor(0, 1);
    splitter->setSizes({1000, 310});
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(splitter);

    m_readTimer->setInterval(0);
    connect(m_readTimer, &QTimer::timeout, this, &HistoryPage::readMore);
    connect(m_detail, &TrialDetail::openRequested, this, &HistoryPage::trialChosen);
    connect(m_detail, &TrialDetail::notesChanged, this, [this](const QString &trial) {
        if (const Result<TrialRecord> record = m_project.trials().find(trial.toStdString()))
            reload({qint64(record->id)});
        Q_EMIT notesChanged(trial);
    });
    connect(m_detail, &TrialDetail::failed, this, &HistoryPage::failed);
    connectMarks();
    connect(m_tabs, &QTabWidget::currentChanged, this, &HistoryPage::showChosenTab);
    connect(m_teams, &TeamsPanel::trialsWanted, this, &HistoryPage::giveTrialsToTeams);
    connect(m_teams, &TeamsPanel::failed, this, &HistoryPage::failed);
    connect(m_results, &ResultsPanel::failed, this, &HistoryPage::failed);
    connect(m_results, &ResultsPanel::saved, this, &HistoryPage::tableSaved);
    connect(m_results, &ResultsPanel::trialChosen, this, &HistoryPage::trialChosen);
    connect(m_results, &ResultsPanel::settled, this, &HistoryPage::showSettled);
    nameCommands({{m_pseudonyms, "pseudonyms"}});
    m_pseudonyms->setCheckable(true);
    m_pseudonyms->setChecked(arePseudonymsShown());
    connect(m_pseudonyms, &QAction::toggled, this, [this](bool shown) {
        showPseudonyms(shown);
        m_trials->updateTeams();
        m_results->updateTeams();
        offerFilters();
        filter();
        showChosenTab();
        Q_EMIT teamNamesChanged();
    });
}

HistoryPage::~HistoryPage() = default;

/// The list has the focus first. It is no focus proxy: the Tab key would go from the page to it, past the
/// search and the filters.
void HistoryPage::focusInEvent(QFocusEvent *event)
{
    m_table->setFocus(event->reason());
}

QWidget *HistoryPage::makeTable()
{
    connect(m_table, &TrialTable::opened, this, &HistoryPage::trialChosen);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        m_wanted.clear();
        showCurrent();
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &HistoryPage::showSelection);

    for (QAction *action : {m_marks->star(), m_marks->archive(), m_marks->bin(), m_marks->emptyBin()}) {
        QToolButton *button = buttonOf(action);
        m_filterBar->addAtEnd(button);
        button->setVisible(action->isVisible());
        m_table->addAction(action);
    }
    addTrialActions();
    makeHeader();
    auto *content = new QWidget(m_tableCard);
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_filterBar);
    column->addWidget(m_table, 1);
    m_tableCard->setContent(content);
    return m_tableCard;
}

void HistoryPage::addTrialActions()
{
    auto *measureAgain = new QAction(themeIcon(QStringLiteral("track")), tr("Rea&nalyse"), m_table);
    measureAgain->setEnabled(!m_readOnly);
    connect(measureAgain, &QAction::triggered, this,
            [this] { Q_EMIT reprocessRequested(m_table->selectedTrials()); });
    auto *exportAll = new QAction(themeIcon(QStringLiteral("export")), tr("E&xport…"), m_table);
    connect(exportAll, &QAction::triggered, this,
            [this] { Q_EMIT exportRequested(m_table->selectedTrials()); });
    auto *report = new QAction(themeIcon(QStringLiteral("print")), tr("&Report…"), m_table);
    connect(report, &QAction::triggered, this, [this] { Q_EMIT reportRequested(m_table->selectedTrials()); });
    auto *videos = new QAction(tr("Export &videos…"), m_table);
    connect(videos, &QAction::triggered, this, [this] { Q_EMIT videosRequested(m_table->selectedTrials()); });
    nameCommands({{measureAgain, "measureAgain"},
                  {exportAll, "exportTrials"},
                  {videos, "exportVideos"},
                  {report, "reportTrials"}});
    const QList<QAction *> work{measureAgain, exportAll, videos, report};
    m_table->addActions(work);
    m_listActions << m_columns->menuAction();
    m_listActions << m_marks->star() << m_marks->archive() << m_marks->bin() << m_marks->emptyBin() << work;
}

void HistoryPage::setHub(const std::optional<HubAddress> &hub)
{
    m_hubRuns->setHub(hub);
    m_tabs->setTabVisible(m_tabs->indexOf(m_hubRuns), hub.has_value());
}

/// Only what is seen is computed. What is known of one trial is beside the list of them.
void HistoryPage::showChosenTab()
{
    m_detail->setVisible(m_tabs->currentWidget() == m_tableCard);
    if (m_tabs->currentWidget() == m_teams)
        m_teams->refresh();
    if (m_tabs->currentWidget() == m_results)
        m_results->refresh();
}

bool HistoryPage::isSettled() const
{
    return !m_reading && m_unchecked.empty() && m_teams->isSettled() && m_results->isSettled();
}

void HistoryPage::showSettled()
{
    if (isSettled())
        Q_EMIT settled();
}

void HistoryPage::giveTrialsToTeams()
{
    std::vector<const TrialRecord *> trials;
    for (const TrialRow &row : m_trials->allRows())
        trials.push_back(&row.trial);
    m_teams->showTrials(trials);
    showSettled();
}

void HistoryPage::makeHeader()
{
    m_search->setPlaceholderText(tr("Search trials, teams, tasks, tags, notes…"));
    m_search->setObjectName(QStringLiteral("search"));
    m_search->setAccessibleName(tr("Search the trials"));
    m_search->setClearButtonEnabled(true);
    m_search->setMinimumWidth(160);
    m_search->addAction(themeIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    m_search->installEventFilter(this);
    connect(m_search, &QLineEdit::textChanged, this, &HistoryPage::filter);
    connect(m_filterBar, &TrialFilterBar::changed, this, &HistoryPage::filter);
    auto *find = new QAction(themeIcon(QStringLiteral("search")), tr("Searc&h"), this);
    nameCommands({{find, "searchTrials"}});
    m_listActions.prepend(find);
    find->setShortcut(QKeySequence::Find);
    find->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(find, &QAction::triggered, m_search, [this] { m_search->setFocus(Qt::ShortcutFocusReason); });
    addAction(find);
    m_tableCard = new Card(tr("Trials"), this);
    m_tableCard->addToHeader(m_compare);
    m_tableCard->addToHeader(m_search);
    m_compare->setIcon(themeIcon(QStringLiteral("compare")));
    connect(m_compare, &QPushButton::clicked, this,
            [this] { Q_EMIT compareRequested(m_table->selectedTrials()); });
    showSelection();
}

void HistoryPage::connectMarks()
{
    connect(m_trials, &TrialModel::starWanted, m_marks,
            [this](qint64 trial, bool starred) { m_marks->setStarred(trial, starred); });
    connect(m_trials, &TrialModel::editWanted, m_marks, [this](qint64 trial, const TrialEdit &edit) {
        m_marks->edit(trial, edit);
        offerFilters();
        Q_EMIT trialsChanged({});
    });
    connect(m_marks, &MarkActions::marked, this, &HistoryPage::reload);
    connect(m_marks, &MarkActions::emptyBinRequested, this, &HistoryPage::emptyBinRequested);
    connect(m_marks, &MarkActions::failed, this, &HistoryPage::failed);
}

void HistoryPage::refresh()
{
    m_table->storeEdited();
    m_reading = std::make_unique<TrialRows>(m_project);
    m_read.clear();
    m_readTimer->start();
    readMore();
    // Shows the newest ones at once; an existing list stays until the new one is complete.
    if (m_reading && m_trials->allCount() == 0) {
        m_trials->setRows(m_read);
        selectTrial({});
        showCount();
    }
}

void HistoryPage::readMore()
{
    Result<std::vector<TrialRow>> rows = m_reading->next(rowsAtOnce);
    if (!rows) {
        endReading({});
        Q_EMIT failed(rows.error());
        return;
    }
    const bool isLast = static_cast<int>(rows->size()) < rowsAtOnce;
    std::ranges::move(*rows, std::back_inserter(m_read));
    if (isLast)
        endReading(std::exchange(m_read, {}));
}

void HistoryPage::endReading(std::vector<TrialRow> rows)
{
    m_readTimer->stop();
    m_reading.reset();
    m_read.clear();
    const std::set<RecordId> selected = selectedIds();
    const QModelIndex current = m_table->currentIndex();
    const RecordId currentId = current.isValid() ? m_trials->row(current.row()).trial.id : 0;
    const QString wanted = std::exchange(m_wanted, {});
    m_trials->setRows(std::move(rows));
    m_columns->showChosen();
    offerFilters();
    if (m_archivedClasses != m_trials->filter().archivedClasses)
        filter();
    m_table->setColumnHidden(TrialModel::ScoreColumn,
                             std::ranges::none_of(m_trials->allRows(), &TrialRow::isScored));
    m_table->fit();
    if (wanted.isEmpty())
        selectAgain(selected, currentId);
    else
        selectTrial(wanted);
    showCount();
    showCurrent();
    showChosenTab();
    m_unchecked = m_trials->unchecked();
    checkMore();
    showSettled();
}

/// Verdicts that are not stored are computed on another thread, some at a time, and stored here; but a window
/// that is only painted leaves the project as it is.
void HistoryPage::checkMore()
{
    if (m_unchecked.empty())
        return;
    const auto end = m_unchecked.begin() + std::min(std::ssize(m_unchecked), trialsAtOnce);
    const std::vector<RecordId> trials(m_unchecked.begin(), end);
    m_checker->read<std::vector<StoredVerdict>>(
        [trials](Project &project) { return computeVerdicts(project, trials); },
        [this, count = trials.size()](Result<std::vector<StoredVerdict>> verdicts) {
            m_unchecked.erase(m_unchecked.begin(), m_unchecked.begin() + std::ptrdiff_t(count));
            takeVerdicts(std::move(verdicts));
        });
}

void HistoryPage::takeVerdicts(Result<std::vector<StoredVerdict>> verdicts)
{
    if (verdicts && !m_readOnly && !window()->testAttribute(Qt::WA_DontShowOnScreen)) {
        if (const Result<void> stored = storeVerdicts(m_project, *verdicts); !stored)
            verdicts = tl::unexpected(stored.error());
    }
    if (!verdicts) {
        m_unchecked.clear();
        Q_EMIT failed(verdicts.error());
    } else {
        for (const StoredVerdict &one : *verdicts)
            m_trials->updateVerdict(one);
    }
    checkMore();
    if (m_unchecked.empty()) {
        if (m_trials->filter().doubtful) // some may have to appear
            filter();
        m_table->fit();
        showCurrent();
        showCount();
    }
    callLater(this, [this] { showSettled(); }); // once the facts have their place
}

void HistoryPage::offerFilters()
{
    FilterOffer offer;
    m_archivedClasses.clear();
    for (const ClassRecord &each : m_project.classes().all().value_or(std::vector<ClassRecord>())) {
        const QString name = QString::fromStdString(each.name);
        offer.classes << name;
        offer.classesShown << (each.archived ? tr("%1 (archived)").arg(name) : name);
        if (each.archived)
            m_archivedClasses.insert(each.name);
    }
    for (const TeamRecord &team : m_project.teams().all().value_or(std::vector<TeamRecord>())) {
        offer.teams << QString::fromStdString(team.name);
        offer.teamsShown << shownTeam(team);
    }
    for (const TaskRecord &task : m_project.tasks().current().value_or(std::vector<TaskRecord>()))
        offer.tasks << QString::fromStdString(task.name);
    for (const RobotRecord &robot : m_project.robots().all().value_or(std::vector<RobotRecord>()))
        offer.robots << QString::fromStdString(robot.name);
    m_filterBar->setOffer(offer);
    m_table->setOffer(offer);
}

void HistoryPage::selectTrial(const QString &name)
{
    const int listSection = m_trials->indexOf(name);
    if (m_trials->rowCount() > 0)
        m_table->setCurrentIndex(m_trials->index(std::max(0, listSection), 0));
    if (m_reading && listSection < 0)
        m_wanted = name;
}

std::set<RecordId> HistoryPage::selectedIds() const
{
    std::set<RecordId> trials;
    for (const QModelIndex &row : m_table->selectionModel()->selectedRows())
        trials.insert(m_trials->row(row.row()).trial.id);
    return trials;
}

/// By their ids: they may have other names now.
void HistoryPage::selectAgain(const std::set<RecordId> &trials, RecordId current)
{
    selectTrial({});
    QItemSelection rows;
    int currentRow = -1;
    for (int row = 0; row < m_trials->rowCount(); ++row) {
        const RecordId trial = m_trials->row(row).trial.id;
        if (trial == current)
            currentRow = row;
        if (trials.contains(trial))
            rows.select(m_trials->index(row, 0), m_trials->index(row, 0));
    }
    if (currentRow < 0)
        return;
    m_table->setCurrentIndex(m_trials->index(currentRow, 0));
    m_table->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

QStringList HistoryPage::selectedTrials() const
{
    return m_table->selectedTrials();
}

void HistoryPage::addEditAction(QAction *action)
{
    m_table->insertAction(m_table->actions().value(0), action);
}

void HistoryPage::saveNotes()
{
    m_detail->saveNotes();
}

void HistoryPage::showSelection()
{
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    m_compare->setEnabled(rows.size() >= 2);
    m_compare->setToolTip(rows.size() >= 2 ? tr("Compare the selected trials")
                                           : tr("Select two or more trials (Ctrl+click or Shift+click)"));
    std::vector<TrialRecord> trials;
    for (const QModelIndex &row : rows)
        trials.push_back(m_trials->row(row.row()).trial);
    m_marks->setTrials(std::move(trials));
    Q_EMIT selectionChanged(m_table->selectedTrials());
}

void HistoryPage::filter()
{
    const QString selected = m_table->currentTrial();
    TrialFilter filter = m_filterBar->filter();
    filter.text = m_search->text();
    filter.archivedClasses = m_archivedClasses;
    m_marks->setBinShown(filter.listSection == TrialFilter::ListSection::Bin);
    m_trials->setFilter(std::move(filter));
    selectTrial(selected);
    showSelection();
    showCount();
    showCurrent();
}

/// A row that goes has notes and tags stored that are being written, which asks for more to be reloaded: that
/// waits its turn, for the list is changing.
void HistoryPage::reload(const QList<qint64> &trials)
{
    const bool isReloading = !m_changed.isEmpty();
    m_changed += trials;
    if (isReloading)
        return;
    const int listSection = m_table->currentIndex().row(), before = m_trials->rowCount();
    for (; !m_changed.isEmpty(); m_changed.removeFirst()) {
        Result<TrialRow> row = loadTrialRow(m_project, m_changed.front());
        if (!row) {
            m_changed.clear();
            Q_EMIT failed(row.error());
            return;
        }
        m_trials->updateRow(std::move(*row));
    }
    const bool isElsewhere = m_trials->rowCount() != before;
    if (isElsewhere && m_trials->rowCount() > 0)
        m_table->setCurrentIndex(m_trials->index(std::clamp(listSection, 0, m_trials->rowCount() - 1), 0));
    showSelection();
    showCount();
    showCurrent();
    if (isElsewhere)
        Q_EMIT trialsChanged({});
}

void HistoryPage::showCurrent()
{
    const QModelIndex current = m_table->currentIndex();
    if (current.isValid())
        m_detail->showTrial(m_trials->row(current.row()));
    else
        m_detail->showNone(m_trials->allCount() == 0);
}

void HistoryPage::showCount()
{
    const int all = m_trials->allCount(), shown = m_trials->rowCount();
    m_tableCard->setRemark(shown == all ? tr("%n trial(s)", "", all)
                                        : tr("%1 of %n trial(s)", "", all).arg(shown));
}

/// Of the search: Enter opens the chosen trial, Down goes to the list.
bool HistoryPage::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent *>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        if (const QString trial = m_table->currentTrial(); !trial.isEmpty())
            Q_EMIT trialChosen(trial);
        return true;
    }
    if (key == Qt::Key_Down) {
        m_table->setFocus(Qt::TabFocusReason);
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace odo
