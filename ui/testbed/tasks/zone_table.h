// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/zone.h"

#include <QWidget>
#include <vector>

class QPushButton;
class QTableWidget;

namespace odo {

/// The zones of a task: names, rules, and the corners in millimetres.
class ZoneTable : public QWidget
{
    Q_OBJECT
public:
    /// middle: where a new zone lies, metres.
    explicit ZoneTable(const Eigen::Vector2d &middle, QWidget *parent = nullptr);
    /// Emits nothing.
    void setZones(const std::vector<Zone> &zones);
    void setCurrent(int zone);
    const std::vector<Zone> &zones() const { return m_zones; }

Q_SIGNALS:
    void currentChanged(int zone); ///< −1: none
    void changed();                ///< a person changed a zone, added or removed one

private:
    void show(int row);
    void showAll();
    void readRow(int row);
    void add(ZoneRule rule);
    void remove();

    const Eigen::Vector2d m_middle;
    std::vector<Zone> m_zones;
    QTableWidget *m_table;
    QPushButton *m_remove;
    bool m_isShowing = false;
};

/// "stay inside"
QString zoneRuleName(ZoneRule rule);
/// Corners as a person writes them, millimetres: "0 0; 3000 0; 3000 2200", with decimals in the manner of the locale. A number that is
/// none is read as NaN, which checkZone tells.
QString cornersText(const std::vector<Eigen::Vector2d> &corners);
std::vector<Eigen::Vector2d> cornersOf(const QString &text);

} // namespace odo
