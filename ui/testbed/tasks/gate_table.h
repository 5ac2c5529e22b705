// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/task.h"

#include <QWidget>
#include <vector>

class QPushButton;
class QTableWidget;

namespace odo {

/// The gates of a task in the order in which they are passed: names, roles and the two ends in millimetres.
class GateTable : public QWidget
{
    Q_OBJECT
public:
    explicit GateTable(QWidget *parent = nullptr);
    /// Emits nothing.
    void setGates(const std::vector<Gate> &gates);
    void setCurrent(int gate);
    const std::vector<Gate> &gates() const { return m_gates; }

Q_SIGNALS:
    void currentChanged(int gate); ///< −1: none
    void changed();                ///< a person changed a gate, added or removed one

private:
    void show(int row);
    void showAll();
    void readRow(int row);
    void add();
    void remove();
    void turn();

    std::vector<Gate> m_gates;
    QTableWidget *m_table;
    QPushButton *m_remove, *m_turn;
    bool m_isShowing = false;
};

/// "start and finish"
QString roleName(GateRole role);

} // namespace odo
