// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/task.h"
#include "ui/testbed/tasks/part_table.h"

namespace odo {

/// The gates of a task in the order in which they are passed: names, roles and the two ends in millimetres.
class GateTable : public PartTable
{
    Q_OBJECT
public:
    explicit GateTable(QWidget *parent = nullptr);
    /// Emits nothing.
    void setGates(const std::vector<Gate> &gates);
    const std::vector<Gate> &gates() const { return m_gates; }

private:
    int count() const override { return static_cast<int>(m_gates.size()); }
    void showRow(int row) override;
    void readRow(int row) override;
    void eraseRow(int row) override { m_gates.erase(m_gates.begin() + row); }
    void add();
    void turn();

    std::vector<Gate> m_gates;
    QPushButton *m_turn;
};

/// "start and finish"
QString roleName(GateRole role);

} // namespace odo
