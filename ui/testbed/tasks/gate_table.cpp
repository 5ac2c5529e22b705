// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/gate_table.h"

#include "ui/testbed/tasks/floor_numbers.h"
#include "ui/views/plain_button.h"

#include <QComboBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {
namespace {

struct GateColumn
{
    enum { Name, Role, FromX, FromY, ToX, ToY, Count };
};
constexpr int leastColumn = 50;
constexpr GateRole roles[] = {GateRole::Start, GateRole::Split, GateRole::Finish, GateRole::StartFinish};

double &numberOf(Gate &gate, int column)
{
    switch (column) {
    case GateColumn::FromX:
        return gate.from.x();
    case GateColumn::FromY:
        return gate.from.y();
    case GateColumn::ToX:
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
    : PartTable({tr("Gate"), tr("Role"), tr("x₁, mm"), tr("y₁, mm"), tr("x₂, mm"), tr("y₂, mm")},
                tr("Gates in the order in which they are passed"), plainButton(tr("Remo&ve")), parent),
      m_turn(plainButton(tr("&Other way")))
{
    // Numbers are shown whole, however long they are; a long name is cut.
    table().horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table().horizontalHeader()->setSectionResizeMode(GateColumn::Name, QHeaderView::Stretch);
    table().horizontalHeader()->setMinimumSectionSize(leastColumn);
    table().setMinimumHeight(120);
    auto *add = plainButton(tr("&Add gate"));
    enableWithParts(m_turn);
    m_turn->setToolTip(tr("The chosen gate is passed the other way"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(&table(), 1);
    layout->addLayout(rowOf({add, removeButton(), m_turn}));
    connect(add, &QPushButton::clicked, this, &GateTable::add);
    connect(m_turn, &QPushButton::clicked, this, &GateTable::turn);
    setGates({});
}

void GateTable::setGates(const std::vector<Gate> &gates)
{
    m_gates = gates;
    showAll();
}

void GateTable::showRow(int row)
{
    Gate &gate = m_gates[static_cast<std::size_t>(row)];
    table().setItem(row, GateColumn::Name, new QTableWidgetItem(QString::fromStdString(gate.name)));
    for (int column = GateColumn::FromX; column < GateColumn::Count; ++column) {
        table().setItem(row, column, new QTableWidgetItem(placeText(numberOf(gate, column))));
        table().item(row, column)->setToolTip(placeText(numberOf(gate, column)));
    }
    std::vector<std::pair<QString, int>> choices;
    for (const GateRole role : roles)
        choices.emplace_back(roleName(role), static_cast<int>(role));
    QComboBox *role = choiceIn(row, GateColumn::Role, tr("Role of the gate"), choices);
    role->setCurrentIndex(role->findData(static_cast<int>(gate.role)));
}

void GateTable::readRow(int row)
{
    Gate &gate = m_gates[static_cast<std::size_t>(row)];
    gate.name = table().item(row, GateColumn::Name)->text().trimmed().toStdString();
    gate.role = static_cast<GateRole>(
        qobject_cast<QComboBox *>(table().cellWidget(row, GateColumn::Role))->currentData().toInt());
    for (int column = GateColumn::FromX; column < GateColumn::Count; ++column) {
        const QString text = table().item(row, column)->text();
        if (text != placeText(numberOf(gate, column))) // what was not touched keeps its last bit
            numberOf(gate, column) = placeOf(text);
    }
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
    const int current = currentRow();
    if (current >= 0) { // beside the chosen one, and passed after it
        const Gate &chosen = m_gates[static_cast<std::size_t>(current)];
        const Eigen::Vector2d along = (chosen.to - chosen.from).normalized();
        const Eigen::Vector2d aside = 0.2 * Eigen::Vector2d(along.y(), -along.x());
        gate.from = chosen.from + aside;
        gate.to = chosen.to + aside;
    }
    m_gates.insert(
        m_gates.begin() + (current < 0 ? static_cast<std::ptrdiff_t>(m_gates.size()) : current + 1), gate);
    showAdded(current < 0 ? static_cast<int>(m_gates.size()) - 1 : current + 1);
}

void GateTable::turn()
{
    const int row = currentRow();
    if (row < 0)
        return;
    Gate &gate = m_gates[static_cast<std::size_t>(row)];
    std::swap(gate.from, gate.to);
    showAll();
    Q_EMIT changed();
}

} // namespace odo
