// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/trial_table.h"

#include "ui/models/trial_model.h"
#include "ui/views/table_list.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <algorithm>

namespace odo {

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
               {TrialModel::NameColumn, TrialModel::TeamColumn, TrialModel::ClassColumn, TrialModel::TaskColumn,
                TrialModel::RobotsColumn, TrialModel::TagsColumn});
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
