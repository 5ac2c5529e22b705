// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/internal/trial_columns.h"

#include "ui/history/internal/trial_list.h"
#include "ui/models/trial_model.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"

#include <QAction>
#include <QCompleter>
#include <QDateTimeEdit>
#include <QHeaderView>
#include <QLineEdit>
#include <QSettings>

namespace odo {

QWidget *TrialCellDelegate::createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                                         const QModelIndex &index) const
{
    if (index.column() == TrialModel::DateColumn) {
        QDateTimeEdit *moment = makeMomentField(parent);
        moment->setFrame(false);
        return moment;
    }
    QWidget *editor = QStyledItemDelegate::createEditor(parent, option, index);
    if (auto *line = qobject_cast<QLineEdit *>(editor); line && m_offer.contains(index.column())) {
        auto *completer = new QCompleter(m_offer.value(index.column()), line);
        completer->setCaseSensitivity(Qt::CaseInsensitive);
        line->setCompleter(completer);
    }
    return editor;
}

namespace {

const QString columnsKey = QStringLiteral("history/columns");
const QString notesWord = QStringLiteral("notes"), variablePrefix = QStringLiteral("variable:");

} // namespace

TrialColumns::TrialColumns(TrialModel &trials, TrialTable &table)
    : QMenu(tr("&Columns"), &table), m_trials(trials), m_table(table),
      m_chosen(QSettings().value(columnsKey).toStringList())
{
    nameCommands({{menuAction(), "columns"}});
    connect(this, &QMenu::aboutToShow, this, &TrialColumns::fill);
    connect(&trials, &QAbstractItemModel::columnsInserted, this, &TrialColumns::showChosen);
    QHeaderView *header = table.horizontalHeader();
    header->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(header, &QWidget::customContextMenuRequested, this,
            [this, header](const QPoint &position) { popup(header->mapToGlobal(position)); });
    fill();
    showChosen();
}

QStringList TrialColumns::optional() const
{
    QStringList columns{notesWord};
    for (const QString &variable : m_trials.variables())
        columns << variablePrefix + variable;
    return columns;
}

void TrialColumns::fill()
{
    clear();
    const QStringList columns = optional();
    for (qsizetype i = 0; i < columns.size(); ++i) {
        const QString heading =
            m_trials.headerData(TrialModel::NotesColumn + static_cast<int>(i), Qt::Horizontal).toString();
        QAction *action = addAction(QString(heading).replace(u'&', QStringLiteral("&&")));
        action->setCheckable(true);
        action->setChecked(m_chosen.contains(columns.at(i)));
        connect(action, &QAction::toggled, this,
                [this, column = columns.at(i)](bool isShown) { choose(column, isShown); });
    }
}

void TrialColumns::choose(const QString &column, bool isShown)
{
    m_chosen.removeAll(column);
    if (isShown)
        m_chosen << column;
    QSettings().setValue(columnsKey, m_chosen);
    showChosen();
}

void TrialColumns::showChosen()
{
    const QStringList columns = optional();
    for (qsizetype i = 0; i < columns.size(); ++i)
        m_table.setColumnHidden(TrialModel::NotesColumn + static_cast<int>(i),
                                !m_chosen.contains(columns.at(i)));
    m_table.fit();
}

} // namespace odo
