// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/part_table.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>

namespace odo {

PartTable::PartTable(const QStringList &headings, const QString &name, QPushButton *remove, QWidget *parent)
    : QWidget(parent), m_table(new QTableWidget(0, static_cast<int>(headings.size()))), m_remove(remove), m_ofParts{remove}
{
    m_table->setHorizontalHeaderLabels(headings);
    m_table->setAccessibleName(name);
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    connect(m_remove, &QPushButton::clicked, this, &PartTable::removeCurrent);
    connect(m_table, &QTableWidget::cellChanged, this, &PartTable::takeEdit);
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (!m_isShowing)
            Q_EMIT currentChanged(row);
    });
}

int PartTable::currentRow() const { return m_table->currentRow(); }

void PartTable::setCurrent(int row)
{
    m_isShowing = true;
    m_table->setCurrentCell(row, std::max(0, m_table->currentColumn()));
    m_isShowing = false;
}

void PartTable::showAll()
{
    m_isShowing = true;
    const int current = m_table->currentRow();
    m_table->setRowCount(count());
    for (int row = 0; row < m_table->rowCount(); ++row)
        showRow(row);
    m_table->setCurrentCell(std::min(current, m_table->rowCount() - 1), std::max(0, m_table->currentColumn()));
    for (QPushButton *button : m_ofParts)
        button->setEnabled(m_table->rowCount() > 0);
    m_isShowing = false;
}

void PartTable::showAdded(int row)
{
    showAll();
    setCurrent(row);
    Q_EMIT changed();
    Q_EMIT currentChanged(m_table->currentRow());
}

QComboBox *PartTable::choiceIn(int row, int column, const QString &name,
                               const std::vector<std::pair<QString, int>> &choices)
{
    auto *choice = qobject_cast<QComboBox *>(m_table->cellWidget(row, column));
    if (choice)
        return choice;
    choice = new QComboBox;
    for (const auto &[words, value] : choices)
        choice->addItem(words, value);
    choice->setAccessibleName(name);
    m_table->setCellWidget(row, column, choice);
    connect(choice, &QComboBox::activated, this, [this, row] { takeEdit(row); });
    return choice;
}

QLayout *PartTable::rowOf(const std::vector<QPushButton *> &buttons) const
{
    auto *row = new QHBoxLayout;
    for (QPushButton *button : buttons)
        row->addWidget(button);
    row->addStretch(1);
    return row;
}

void PartTable::takeEdit(int row)
{
    if (m_isShowing)
        return;
    readRow(row);
    Q_EMIT changed();
}

void PartTable::removeCurrent()
{
    const int row = m_table->currentRow();
    if (row < 0)
        return;
    eraseRow(row);
    showAll();
    Q_EMIT changed();
    Q_EMIT currentChanged(m_table->currentRow());
}

} // namespace odo
