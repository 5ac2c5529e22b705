// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/gate_table.h"

#include "ui/testbed/tasks/floor_numbers.h"
#include "ui/views/plain_button.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>

namespace odo {
namespace {

enum Column { NameColumn, RoleColumn, FromXColumn, FromYColumn, ToXColumn, ToYColumn, ColumnCount };
constexpr int leastColumn = 50;
constexpr GateRole roles[] = {GateRole::Start, GateRole::Split, GateRole::Finish, GateRole::StartFinish};

double &numberOf(Gate &gate, int column)
{
    switch (column) {
    case FromXColumn:
        return gate.from.x();
    case FromYColumn:
        return gate.from.y();
    case ToXColumn:
        return gate.to.x();
    default:
        return gate.to.y();
    }
}

} // namespace

QString roleName(GateRole role)
{
    switch (role) {
    case GateRole::Start:
        return GateTable::tr("start");
    case GateRole::Finish:
        return GateTable::tr("finish");
    case GateRole::StartFinish:
        return GateTable::tr("start and finish");
    case GateRole::Split:
        break;
    }
    return GateTable::tr("split");
}

GateTable::GateTable(QWidget *parent)
    : QWidget(parent), m_table(new QTableWidget(0, ColumnCount)), m_remove(plainButton(tr("Remo&ve"))),
      m_turn(plainButton(tr("&Other way")))
{
    m_table->setHorizontalHeaderLabels(
        {tr("Gate"), tr("Role"), tr("x₁, mm"), tr("y₁, mm"), tr("x₂, mm"), tr("y₂, mm")});
    m_table->setAccessibleName(tr("Gates in the order in which they are passed"));
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    // Numbers are shown whole, however long they are; a long name is cut.
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    m_table->horizontalHeader()->setMinimumSectionSize(leastColumn);
    m_table->setMinimumHeight(120);
    auto *add = plainButton(tr("&Add gate"));
    m_turn->setToolTip(tr("The chosen gate is passed the other way"));
    auto *buttons = new QHBoxLayout;
    for (QPushButton *button : {add, m_remove, m_turn})
        buttons->addWidget(button);
    buttons->addStretch(1);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_table, 1);
    layout->addLayout(buttons);
    connect(add, &QPushButton::clicked, this, &GateTable::add);
    connect(m_remove, &QPushButton::clicked, this, &GateTable::remove);
    connect(m_turn, &QPushButton::clicked, this, &GateTable::turn);
    connect(m_table, &QTableWidget::cellChanged, this, &GateTable::readRow);
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (!m_isShowing)
            Q_EMIT currentChanged(row);
    });
    setGates({});
}

void GateTable::setGates(const std::vector<Gate> &gates)
{
    m_gates = gates;
    showAll();
}

void GateTable::setCurrent(int gate)
{
    m_isShowing = true;
    m_table->setCurrentCell(gate, std::max(0, m_table->currentColumn()));
    m_isShowing = false;
}

void GateTable::showAll()
{
    m_isShowing = true;
    const int row = m_table->currentRow();
    m_table->setRowCount(static_cast<int>(m_gates.size()));
    for (int i = 0; i < m_table->rowCount(); ++i)
        show(i);
    m_table->setCurrentCell(std::min(row, m_table->rowCount() - 1), std::max(0, m_table->currentColumn()));
    m_remove->setEnabled(!m_gates.empty());
    m_turn->setEnabled(!m_gates.empty());
    m_isShowing = false;
}

void GateTable::show(int row)
{
    Gate &gate = m_gates[static_cast<std::size_t>(row)];
    m_table->setItem(row, NameColumn, new QTableWidgetItem(QString::fromStdString(gate.name)));
    for (int column = FromXColumn; column < ColumnCount; ++column) {
        m_table->setItem(row, column, new QTableWidgetItem(placeText(numberOf(gate, column))));
        m_table->item(row, column)->setToolTip(placeText(numberOf(gate, column)));
    }
    auto *role = qobject_cast<QComboBox *>(m_table->cellWidget(row, RoleColumn));
    if (!role) {
        role = new QComboBox;
        for (const GateRole each : roles)
            role->addItem(roleName(each), static_cast<int>(each));
        role->setAccessibleName(tr("Role of the gate"));
        m_table->setCellWidget(row, RoleColumn, role);
        connect(role, &QComboBox::activated, this, [this, row] { readRow(row); });
    }
    role->setCurrentIndex(role->findData(static_cast<int>(gate.role)));
}

void GateTable::readRow(int row)
{
    if (m_isShowing)
        return;
    Gate &gate = m_gates[static_cast<std::size_t>(row)];
    gate.name = m_table->item(row, NameColumn)->text().trimmed().toStdString();
    gate.role = static_cast<GateRole>(
        qobject_cast<QComboBox *>(m_table->cellWidget(row, RoleColumn))->currentData().toInt());
    for (int column = FromXColumn; column < ColumnCount; ++column) {
        const QString text = m_table->item(row, column)->text();
        if (text != placeText(numberOf(gate, column))) // what was not touched keeps its last bit
            numberOf(gate, column) = placeOf(text);
    }
    Q_EMIT changed();
}

void GateTable::add()
{
    std::string name;
    const auto taken = [&] { return std::ranges::find(m_gates, name, &Gate::name) != m_gates.end(); };
    int number = 1;
    do
        name = tr("Split %1").arg(number++).toStdString();
    while (taken());
    Gate gate{name, GateRole::Split, {0.5, 0.5}, {0.5, 0.9}};
    const int current = m_table->currentRow();
    if (current >= 0) { // beside the chosen one, and passed after it
        const Gate &chosen = m_gates[static_cast<std::size_t>(current)];
        const Eigen::Vector2d along = (chosen.to - chosen.from).normalized();
        const Eigen::Vector2d aside = 0.2 * Eigen::Vector2d(along.y(), -along.x());
        gate.from = chosen.from + aside;
        gate.to = chosen.to + aside;
    }
    m_gates.insert(
        m_gates.begin() + (current < 0 ? static_cast<std::ptrdiff_t>(m_gates.size()) : current + 1), gate);
    showAll();
    setCurrent(current < 0 ? static_cast<int>(m_gates.size()) - 1 : current + 1);
    Q_EMIT changed();
    Q_EMIT currentChanged(m_table->currentRow());
}

void GateTable::remove()
{
    const int row = m_table->currentRow();
    if (row < 0)
        return;
    m_gates.erase(m_gates.begin() + row);
    showAll();
    Q_EMIT changed();
    Q_EMIT currentChanged(m_table->currentRow());
}

void GateTable::turn()
{
    const int row = m_table->currentRow();
    if (row < 0)
        return;
    Gate &gate = m_gates[static_cast<std::size_t>(row)];
    std::swap(gate.from, gate.to);
    showAll();
    Q_EMIT changed();
}

} // namespace odo
