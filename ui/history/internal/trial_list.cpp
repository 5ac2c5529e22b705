// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/internal/trial_list.h"

#include "ui/models/trial_model.h"
#include "ui/views/widgets/table_list.h"
#include "ui/views/widgets/theme.h"

#include <QComboBox>
#include <QDateEdit>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QToolButton>
#include <algorithm>

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
      m_starred(new QToolButton(this)), m_lower(new QHBoxLayout)
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
    m_starred->setText(tr("Starred"));
    m_starred->setIcon(themeIcon(QStringLiteral("star")));
    m_starred->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_starred->setCheckable(true);
    m_starred->setFocusPolicy(Qt::TabFocus);
    m_starred->setAccessibleName(tr("Only starred trials"));
    m_starred->setToolTip(tr("Show only starred trials"));
    lower->addWidget(m_starred);
    lower->addStretch(1);
    connect(m_starred, &QToolButton::toggled, this, &TrialFilterBar::changed);
    connect(m_dates, &QComboBox::currentIndexChanged, this, &TrialFilterBar::showDates);
}

void TrialFilterBar::addAtEnd(QWidget *widget)
{
    m_lower->addWidget(widget);
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

TrialTable::TrialTable(TrialModel &model, QWidget *parent) : QTableView(parent)
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
    horizontalHeader()->setResizeContentsPrecision(0); // of what is on screen, not of thousands
    horizontalHeader()->moveSection(TrialModel::StarColumn, 0);
    horizontalHeader()->setSectionResizeMode(TrialModel::StarColumn, QHeaderView::Fixed);
    horizontalHeader()->resizeSection(TrialModel::StarColumn, 2 * fontMetrics().height());
    connect(this, &QTableView::doubleClicked, this, [this](const QModelIndex &index) {
        if (!(index.flags() & (Qt::ItemIsEditable | Qt::ItemIsUserCheckable)))
            Q_EMIT opened(currentTrial());
    });
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
    fitColumns(*this, TrialModel::TaskColumn,
               {TrialModel::NameColumn, TrialModel::TeamColumn, TrialModel::ClassColumn,
                TrialModel::TaskColumn, TrialModel::RobotsColumn, TrialModel::TagsColumn});
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

} // namespace odo
