// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/internal/trial_list.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/compare/trial_metrics.h"
#include "core/workflow/trials/trial_changes.h"
#include "ui/history/internal/trial_columns.h"
#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/models/shown_names.h"
#include "ui/models/trial_model.h"
#include "ui/models/verdict_mark.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/table_list.h"
#include "ui/views/widgets/theme.h"

#include <QComboBox>
#include <QDateEdit>
#include <QDateTime>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>

namespace odo {

namespace {

enum Dates { AnyDate, Today, LastWeek, LastMonth, LastYear, Between };

Instant startOf(const QDate &day)
{
    return Instant(std::chrono::milliseconds(day.startOfDay().toMSecsSinceEpoch()));
}

} // namespace

TrialFilterBar::TrialFilterBar(QWidget *parent)
    : QWidget(parent), m_from(new QDateEdit(this)), m_to(new QDateEdit(this)),
      m_starred(new QToolButton(this)), m_doubtful(new QToolButton(this)), m_lower(new QHBoxLayout)
{
    // Two rows, so that a window at 200 % still holds them.
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(10, 6, 10, 6);
    rows->setSpacing(6);
    auto *upper = new QHBoxLayout, *lower = m_lower;
    rows->addLayout(upper);
    rows->addLayout(lower);
    m_class = addChoice(*upper, tr("Class"), tr("Any class"));
    m_team = addChoice(*upper, tr("Team"), tr("Any team"));
    m_task = addChoice(*upper, tr("Task"), tr("Any task"));
    m_robot = addChoice(*upper, tr("Robot"), tr("Any robot"));
    m_dates = addChoice(*lower, tr("Date"), tr("Any date"));
    m_dates->setMinimumContentsLength(12);
    m_dates->addItems(
        {tr("Today"), tr("Last 7 days"), tr("Last 30 days"), tr("Last 12 months"), tr("Between…")});
    m_listSection = addChoice(*lower, tr("Where"), tr("Trials"));
    m_listSection->addItems({tr("Archive"), tr("Bin")});
    m_from->setAccessibleName(tr("From"));
    m_to->setAccessibleName(tr("To"));
    for (QDateEdit *edit : {m_from, m_to}) {
        edit->setCalendarPopup(true);
        edit->setDate(QDate::currentDate());
        edit->hide();
        lower->insertWidget(lower->indexOf(m_listSection), edit);
        connect(edit, &QDateEdit::dateChanged, this, &TrialFilterBar::changed);
    }
    makeSwitch(*m_starred, QStringLiteral("star"), tr("Starred"));
    m_starred->setAccessibleName(tr("Only starred trials"));
    m_starred->setToolTip(tr("Show only starred trials"));
    makeSwitch(*m_doubtful, QStringLiteral("warning"), tr("Doubtful"));
    m_doubtful->setObjectName(QStringLiteral("doubtfulOnly"));
    m_doubtful->setAccessibleName(tr("Only trials with doubtful or bad results"));
    m_doubtful->setToolTip(tr("Show only trials with doubtful or bad results"));
    for (QToolButton *button : {m_starred, m_doubtful}) {
        lower->addWidget(button);
        m_buttons << button;
        connect(button, &QToolButton::toggled, this, &TrialFilterBar::changed);
    }
    lower->addStretch(1);
    connect(m_dates, &QComboBox::currentIndexChanged, this, &TrialFilterBar::showDates);
}

void TrialFilterBar::makeSwitch(QToolButton &button, const QString &icon, const QString &text)
{
    button.setText(text);
    button.setIcon(themeIcon(icon));
    button.setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button.setCheckable(true);
    button.setFocusPolicy(Qt::TabFocus);
}

void TrialFilterBar::addAtEnd(QToolButton *button)
{
    m_lower->addWidget(button);
    m_buttons << button;
}

/// What the words beside the icons of all buttons take.
int TrialFilterBar::widthOfWords() const
{
    constexpr int besideIcon = 4;
    int width = 0;
    for (const QToolButton *button : m_buttons)
        if (!button->isHidden() && !button->icon().isNull())
            width += button->fontMetrics().horizontalAdvance(button->text().remove(u'&')) + besideIcon;
    return width;
}

QSize TrialFilterBar::minimumSizeHint() const
{
    QSize least = QWidget::minimumSizeHint();
    const bool areWordsShown = std::ranges::any_of(m_buttons, [](const QToolButton *button) {
        return button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon;
    });
    if (areWordsShown)
        least.rwidth() -= widthOfWords();
    return least;
}

void TrialFilterBar::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const bool isWide = width() >= minimumSizeHint().width() + widthOfWords();
    for (QToolButton *button : m_buttons)
        if (!button->icon().isNull())
            button->setToolButtonStyle(isWide ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
}

QComboBox *TrialFilterBar::addChoice(QLayout &row, const QString &name, const QString &any)
{
    QComboBox *choice = makeChoice(name, 7);
    choice->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    choice->addItem(any);
    row.addWidget(choice);
    connect(choice, &QComboBox::currentIndexChanged, this, &TrialFilterBar::changed);
    return choice;
}

void TrialFilterBar::setOffer(const FilterOffer &offer)
{
    fillChoice(*m_class, offer.classes, offer.classesShown);
    fillChoice(*m_team, offer.teams, offer.teamsShown);
    fillChoice(*m_task, offer.tasks, offer.tasks);
    fillChoice(*m_robot, offer.robots, offer.robots);
}

void TrialFilterBar::showDates()
{
    const bool between = m_dates->currentIndex() == Between;
    m_from->setVisible(between);
    m_to->setVisible(between);
}

TrialFilter TrialFilterBar::filter() const
{
    TrialFilter filter;
    filter.className = chosenWord(*m_class);
    filter.team = chosenWord(*m_team);
    filter.task = chosenWord(*m_task);
    filter.robot = chosenWord(*m_robot);
    filter.starred = m_starred->isChecked();
    filter.doubtful = m_doubtful->isChecked();
    filter.listSection = static_cast<TrialFilter::ListSection>(m_listSection->currentIndex());
    const QDate today = QDate::currentDate();
    switch (m_dates->currentIndex()) {
    case Today:
        filter.from = startOf(today);
        break;
    case LastWeek:
        filter.from = startOf(today.addDays(-6));
        break;
    case LastMonth:
        filter.from = startOf(today.addDays(-29));
        break;
    case LastYear:
        filter.from = startOf(today.addYears(-1));
        break;
    case Between:
        filter.from = startOf(m_from->date());
        filter.to = startOf(m_to->date().addDays(1));
        break;
    default:
        break;
    }
    return filter;
}

TrialTable::TrialTable(TrialModel &model, QWidget *parent)
    : QTableView(parent), m_cells(new TrialCellDelegate(this))
{
    setObjectName(QStringLiteral("trials"));
    setModel(&model);
    setAccessibleName(tr("Trials"));
    showAsList(*this);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setWordWrap(false);
    setSortingEnabled(true);
    sortByColumn(TrialModel::DateColumn, Qt::DescendingOrder);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    setItemDelegate(m_cells);
    setItemDelegateForColumn(TrialModel::VerdictColumn,
                             new BadgeDelegate(TrialModel::BadgeTextRole, TrialModel::BadgeStateRole, this));
    horizontalHeader()->setResizeContentsPrecision(0); // of what is on screen, not of thousands
    horizontalHeader()->moveSection(TrialModel::StarColumn, 0);
    horizontalHeader()->setSectionResizeMode(TrialModel::StarColumn, QHeaderView::Fixed);
    horizontalHeader()->resizeSection(TrialModel::StarColumn, 2 * fontMetrics().height());
    connect(this, &QTableView::doubleClicked, this, [this](const QModelIndex &index) {
        if (!isEditedByDoubleClick(index) && !(index.flags() & Qt::ItemIsUserCheckable))
            Q_EMIT opened(currentTrial());
    });
}

/// What is written often. A double click on the others opens the trial.
bool TrialTable::isEditedByDoubleClick(const QModelIndex &index)
{
    return index.column() >= TrialModel::TagsColumn && index.flags().testFlag(Qt::ItemIsEditable);
}

bool TrialTable::edit(const QModelIndex &index, EditTrigger trigger, QEvent *event)
{
    return (trigger != DoubleClicked || isEditedByDoubleClick(index)) &&
           QTableView::edit(index, trigger, event);
}

void TrialTable::setOffer(const FilterOffer &offer)
{
    m_cells->setOffer({{TrialModel::TeamColumn, offer.teamsShown},
                       {TrialModel::ClassColumn, offer.classes},
                       {TrialModel::TaskColumn, offer.tasks}});
}

QString TrialTable::currentTrial() const
{
    const QModelIndex current = currentIndex();
    return current.isValid() ? current.data(TrialModel::NameRole).toString() : QString();
}

QStringList TrialTable::selectedTrials() const
{
    QModelIndexList rows = selectionModel()->selectedRows();
    std::ranges::sort(rows, {}, &QModelIndex::row);
    QStringList trials;
    for (const QModelIndex &row : rows)
        trials << row.data(TrialModel::NameRole).toString();
    return trials;
}

void TrialTable::storeEdited()
{
    QWidget *editor = indexWidget(currentIndex());
    if (!editor)
        return;
    commitData(editor);
    closeEditor(editor, QAbstractItemDelegate::NoHint);
}

void TrialTable::rowsAboutToBeRemoved(const QModelIndex &parent, int first, int last)
{
    if (currentIndex().row() >= first && currentIndex().row() <= last)
        storeEdited();
    QTableView::rowsAboutToBeRemoved(parent, first, last);
}

void TrialTable::fit()
{
    QList<int> shrinkable{TrialModel::NameColumn, TrialModel::TeamColumn,   TrialModel::ClassColumn,
                          TrialModel::TaskColumn, TrialModel::RobotsColumn, TrialModel::TagsColumn,
                          TrialModel::NotesColumn};
    for (int column = TrialModel::ColumnCount; column < model()->columnCount(); ++column)
        shrinkable << column;
    shrinkable.removeIf([this](int column) { return isColumnHidden(column); });
    fitColumns(*this, TrialModel::TaskColumn, shrinkable);
}

void TrialTable::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    fit();
}

void TrialTable::keyPressEvent(QKeyEvent *event)
{
    const bool endsWriting = state() == EditingState; // a cell passes on the key that it is left by
    if (endsWriting || (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter))
        return QTableView::keyPressEvent(event);
    if (const QString trial = currentTrial(); !trial.isEmpty())
        Q_EMIT opened(trial);
}

namespace {

constexpr std::chrono::milliseconds saveAfter{500};

QList<Fact> factsOf(const TrialRow &row, const std::vector<AnalysisRecord> &analyses,
                    const std::vector<TrialScore> &scores)
{
    const TrialRecord &trial = row.trial;
    QList<Fact> facts;
    if (row.verdict)
        facts.append({TrialDetail::tr("Verdict"), verdictText(*row.verdict), verdictBadge(*row.verdict)});
    const auto add = [&facts](const QString &name, const QString &value) {
        if (!value.isEmpty())
            facts.append({name, value, {}});
    };
    add(TrialDetail::tr("Team"), shownTeam(trial));
    add(TrialDetail::tr("Class"), QString::fromStdString(trial.className));
    add(TrialDetail::tr("Task"), QString::fromStdString(trial.task));
    add(TrialDetail::tr("Date"), shortDate(trial.date));
    add(TrialDetail::tr("Views"), trial.viewCount > 0 || analyses.empty()
                                      ? QLocale().toString(trial.viewCount)
                                      : TrialDetail::tr("none: the track was imported"));
    for (const auto &[name, value] : trial.variables)
        add(QString::fromStdString(name), QString::fromStdString(value));
    for (const AnalysisRecord &analysis : analyses) {
        if (analyses.size() > 1)
            add(TrialDetail::tr("Robot"), QString::fromStdString(analysis.robotName));
        for (const Metric &metric : analysis.profile.metrics)
            facts.append({metricName(metric.name),
                          metricNumber(metric).text(),
                          {},
                          explainMetric(metric, analysisInputs(trial, analysis))});
    }
    for (const TrialScore &run : scores) {
        if (run.trial != trial.id)
            continue;
        if (run.score)
            facts.append({TrialDetail::tr("Score"), scoreText(*run.score), {}, explainScore(*run.score)});
        else
            add(TrialDetail::tr("Score"),
                TrialDetail::tr(
                    "none: analysed with a different course than its task has now. Reanalyse the trial"));
    }
    if (analyses.empty())
        facts.append({TrialDetail::tr("Result"), TrialDetail::tr("none yet: open it and choose Track"), {}});
    return facts;
}

} // namespace

TrialDetail::TrialDetail(Project &project, QWidget *parent)
    : QWidget(parent), m_project(project), m_facts(new FactList(FactList::Badges::Beneath)),
      m_notes(new QPlainTextEdit), m_open(new QPushButton(tr("Open in Review"))),
      m_saveTimer(new QTimer(this))
{
    auto *scroll = scrolled(m_facts, tr("Facts of the trial"));

    m_notes->setAccessibleName(tr("Notes of the trial"));
    m_notes->setPlaceholderText(tr("What did you change on the robot? What do you want to remember?"));
    m_notes->setTabChangesFocus(true);
    m_notes->setFixedHeight(110);
    m_open->setProperty("primary", true);
    auto *notesTitle = new QLabel(tr("&Notes"));
    notesTitle->setBuddy(m_notes);
    auto *footer = new QWidget;
    auto *footerLayout = new QVBoxLayout(footer);
    footerLayout->setContentsMargins(10, 6, 10, 10);
    footerLayout->addWidget(notesTitle);
    footerLayout->addWidget(m_notes);
    footerLayout->addWidget(m_open);

    auto *content = new QWidget;
    auto *contentLayout = new QVBoxLayout(content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    contentLayout->addWidget(scroll, 1);
    contentLayout->addWidget(footer);
    m_card = new Card(tr("Trial"), this);
    m_card->setContent(content);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_card);
    setMinimumWidth(280);

    m_saveTimer->setSingleShot(true);
    m_saveTimer->setInterval(saveAfter);
    connect(m_saveTimer, &QTimer::timeout, this, &TrialDetail::saveNotes);
    connect(m_notes, &QPlainTextEdit::textChanged, m_saveTimer, qOverload<>(&QTimer::start));
    connect(m_open, &QPushButton::clicked, this, [this] { Q_EMIT openRequested(m_name); });
    showNone(true);
}

TrialDetail::~TrialDetail()
{
    const QSignalBlocker quiet(this); // who listens is going away as well
    saveNotes();
}

void TrialDetail::showTrial(const TrialRow &row)
{
    const TrialRecord &trial = row.trial;
    if (trial.id != m_trial)
        saveNotes();
    const QString notes = QString::fromStdString(trial.notes);
    const bool sameTrial = m_trial == trial.id;
    m_trial = trial.id;
    m_name = QString::fromStdString(trial.name);
    m_card->setTitle(m_name);
    const Result<std::vector<AnalysisRecord>> analyses = m_project.analyses().currentMetrics(trial.id);
    const Result<std::vector<TrialScore>> scores = trialScores(m_project, trial.date, trial.date);
    if (!analyses || !scores)
        Q_EMIT failed(analyses ? scores.error() : analyses.error());
    m_facts->setFacts(factsOf(row, analyses.value_or(std::vector<AnalysisRecord>()),
                              scores.value_or(std::vector<TrialScore>())));
    if (!sameTrial || notes != m_savedNotes) {
        m_savedNotes = notes;
        m_notes->setPlainText(notes);
        m_saveTimer->stop();
    }
    m_notes->setEnabled(true);
    m_open->setEnabled(true);
}

void TrialDetail::showNone(bool noTrials)
{
    saveNotes();
    m_trial = 0;
    m_name.clear();
    m_card->setTitle(noTrials ? tr("No trials yet") : tr("No trial selected"));
    m_facts->setFacts({});
    m_notes->clear();
    m_saveTimer->stop();
    m_notes->setEnabled(false);
    m_open->setEnabled(false);
}

void TrialDetail::saveNotes()
{
    m_saveTimer->stop();
    const QString notes = m_notes->toPlainText();
    if (m_trial == 0 || notes == m_savedNotes)
        return;
    const auto saved = editTrial(m_project, m_trial, {.notes = notes.toStdString()});
    if (!saved) {
        Q_EMIT failed(saved.error());
        return;
    }
    m_savedNotes = notes;
    Q_EMIT notesChanged(m_name);
}

} // namespace odo
