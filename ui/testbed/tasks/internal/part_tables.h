// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/task.h"

#include <QWidget>
#include <utility>
#include <vector>

class QComboBox;
class QPushButton;
class QTableWidget;

namespace odo {

/// What the tables of a task's gates and of its zones do alike: a row each, which is shown, read when a
/// person has edited it, chosen, and removed. GUI thread.
class PartTable : public QWidget
{
    Q_OBJECT
public:
    /// Emits nothing.
    void setCurrent(int row);

Q_SIGNALS:
    void currentChanged(int row); ///< −1: none
    void changed();               ///< a person changed a part, added or removed one

protected:
    /// name: of the table, for a screen reader. remove: the button that removes the chosen part.
    PartTable(const QStringList &headings, const QString &name, QPushButton *remove, QWidget *parent);
    QTableWidget &table() const { return *m_table; }
    QPushButton *removeButton() const { return m_remove; }
    int currentRow() const;
    void showAll();
    /// To be called when a part was added: shows and chooses it.
    void showAdded(int row);
    /// The choice in a cell, made when it is not there; a person's choice is read as an edit of the row.
    QComboBox *choiceIn(int row, int column, const QString &name,
                        const std::vector<std::pair<QString, int>> &choices);
    /// The button works while there is a part.
    void enableWithParts(QPushButton *button) { m_ofParts.push_back(button); }
    /// A row of buttons, aligned at the start.
    QLayout *rowOf(const std::vector<QPushButton *> &buttons) const;

private:
    virtual int count() const = 0;
    virtual void showRow(int row) = 0;
    virtual void readRow(int row) = 0;
    virtual void eraseRow(int row) = 0;
    void takeEdit(int row);
    void removeCurrent();

    QTableWidget *m_table;
    QPushButton *m_remove;
    std::vector<QPushButton *> m_ofParts;
    bool m_isShowing = false;
};

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

/// The zones of a task: names, rules, and the corners in millimetres.
class ZoneTable : public PartTable
{
    Q_OBJECT
public:
    /// middle: where a new zone lies, metres.
    explicit ZoneTable(const Eigen::Vector2d &middle, QWidget *parent = nullptr);
    /// Emits nothing.
    void setZones(const std::vector<Zone> &zones);
    const std::vector<Zone> &zones() const { return m_zones; }

private:
    int count() const override { return static_cast<int>(m_zones.size()); }
    void showRow(int row) override;
    void readRow(int row) override;
    void eraseRow(int row) override { m_zones.erase(m_zones.begin() + row); }
    void add(ZoneRule rule);

    const Eigen::Vector2d m_middle;
    std::vector<Zone> m_zones;
};

/// "stay inside"
QString zoneRuleName(ZoneRule rule);
/// Corners as typed, millimetres: "0 0; 3000 0; 3000 2200", with decimals in the manner of the locale. An
/// invalid number is read as NaN, which checkZone reports.
QString cornersText(const std::vector<Eigen::Vector2d> &corners);
std::vector<Eigen::Vector2d> cornersOf(const QString &text);

} // namespace odo
