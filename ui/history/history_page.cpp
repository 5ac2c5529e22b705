// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_page.h"

#include "core/project/project.h"
#include "ui/history/trial_detail.h"
#include "ui/models/trial_model.h"
#include "ui/views/card.h"
#include "ui/views/theme_icon.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTableView>
#include <algorithm>

namespace odo {

HistoryPage::HistoryPage(Project &project, QWidget *parent)
    : QWidget(parent), m_project(project), m_trials(new TrialModel(this)),
      m_sorted(new QSortFilterProxyModel(this)), m_search(new QLineEdit(this)),
      m_compare(new QPushButton(tr("&Compare"), this)), m_table(new QTableView(this)),
      m_detail(new TrialDetail(project, this))
{
    setObjectName(QStringLiteral("page"));
    setFocusProxy(m_table);
    m_sorted->setSourceModel(m_trials);
    m_sorted->setSortRole(TrialModel::SortRole);
    m_sorted->setFilterRole(TrialModel::SearchRole);
    m_sorted->setFilterKeyColumn(0);
    m_sorted->setFilterCaseSensitivity(Qt::CaseInsensitive);
    m_sorted->setSortCaseSensitivity(Qt::CaseInsensitive);
    m_sorted->setSortLocaleAware(true);

    auto *splitter = new QSplitter(this);
    splitter->setHandleWidth(8);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(makeTable());
    splitter->addWidget(m_detail);
    splitter->setStretchFactor(0, 1);
    splitter->setSizes({1000, 310});
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(splitter);

    connect(m_detail, &TrialDetail::openRequested, this, &HistoryPage::trialChosen);
    connect(m_detail, &TrialDetail::notesChanged, this, &HistoryPage::notesChanged);
    connect(m_detail, &TrialDetail::failed, this, &HistoryPage::failed);
}

QWidget *HistoryPage::makeTable()
{
    m_table->setModel(m_sorted);
    m_table->setAccessibleName(tr("Trials"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(TrialModel::DateColumn, Qt::DescendingOrder);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setSectionResizeMode(TrialModel::TaskColumn, QHeaderView::Stretch);
    m_table->installEventFilter(this);
    connect(m_table, &QTableView::doubleClicked, this, [this] { Q_EMIT trialChosen(currentTrial()); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &HistoryPage::showCurrent);

    m_search->setPlaceholderText(tr("Search trials, teams, tasks, notes…"));
    m_search->setAccessibleName(tr("Search the trials"));
    m_search->setClearButtonEnabled(true);
    m_search->setMinimumWidth(260);
    m_search->addAction(themeIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    m_search->installEventFilter(this);
    connect(m_search, &QLineEdit::textChanged, this, &HistoryPage::filter);
    auto *find = new QAction(this);
    find->setShortcut(QKeySequence::Find);
    find->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(find, &QAction::triggered, m_search, [this] { m_search->setFocus(Qt::ShortcutFocusReason); });
    addAction(find);

    m_tableCard = new Card(tr("Trials"), this);
    m_tableCard->setContent(m_table);
    m_tableCard->addToHeader(m_compare);
    m_tableCard->addToHeader(m_search);
    m_compare->setIcon(themeIcon(QStringLiteral("compare")));
    connect(m_compare, &QPushButton::clicked, this, [this] { Q_EMIT compareRequested(selectedTrials()); });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &HistoryPage::showSelection);
    setTabOrder(m_search, m_compare);
    setTabOrder(m_compare, m_table);
    showSelection();
    return m_tableCard;
}

void HistoryPage::refresh()
{
    const QString selected = currentTrial();
    Result<std::vector<TrialRow>> rows = loadTrialRows(m_project);
    if (!rows) {
        Q_EMIT failed(rows.error());
        return;
    }
    m_trials->setRows(std::move(*rows));
    m_table->resizeColumnsToContents();
    selectTrial(selected);
    showCount();
    showCurrent();
}

void HistoryPage::selectTrial(const QString &name)
{
    int row = 0;
    for (int i = 0; i < m_sorted->rowCount(); ++i)
        if (m_sorted->index(i, 0).data(TrialModel::NameRole).toString() == name)
            row = i;
    if (m_sorted->rowCount() > 0)
        m_table->setCurrentIndex(m_sorted->index(row, 0));
}

QString HistoryPage::currentTrial() const
{
    const QModelIndex current = m_table->currentIndex();
    return current.isValid() ? current.siblingAtColumn(0).data(TrialModel::NameRole).toString() : QString();
}

QStringList HistoryPage::selectedTrials() const
{
    QModelIndexList rows = m_table->selectionModel()->selectedRows();
    std::ranges::sort(rows, {}, &QModelIndex::row);
    QStringList trials;
    for (const QModelIndex &row : rows)
        trials << row.data(TrialModel::NameRole).toString();
    return trials;
}

void HistoryPage::showSelection()
{
    const bool isEnough = m_table->selectionModel()->selectedRows().size() >= 2;
    m_compare->setEnabled(isEnough);
    m_compare->setToolTip(isEnough ? tr("Compare the selected trials") : tr("Select two trials or more (Ctrl or Shift and a click)"));
}

void HistoryPage::filter(const QString &text)
{
    m_sorted->setFilterFixedString(text);
    if (!m_table->currentIndex().isValid() && m_sorted->rowCount() > 0)
        m_table->setCurrentIndex(m_sorted->index(0, 0));
    showCount();
    showCurrent();
}

void HistoryPage::showCurrent()
{
    const QModelIndex current = m_table->currentIndex();
    if (current.isValid())
        m_detail->showTrial(m_trials->row(m_sorted->mapToSource(current).row()));
    else
        m_detail->showNone(m_trials->rowCount() == 0);
}

void HistoryPage::showCount()
{
    const int all = m_trials->rowCount(), shown = m_sorted->rowCount();
    m_tableCard->setRemark(shown == all ? (all == 1 ? tr("1 trial") : tr("%1 trials").arg(all))
                                        : tr("%1 of %2 trials").arg(shown).arg(all));
}

bool HistoryPage::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent *>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        if (const QString trial = currentTrial(); !trial.isEmpty())
            Q_EMIT trialChosen(trial);
        return true;
    }
    if (watched == m_search && key == Qt::Key_Down) {
        m_table->setFocus(Qt::TabFocusReason);
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace odo
