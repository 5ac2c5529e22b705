// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/zone.h"
#include "ui/testbed/tasks/part_table.h"

namespace odo {

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
/// Corners as a person writes them, millimetres: "0 0; 3000 0; 3000 2200", with decimals in the manner of the locale. A number that is
/// none is read as NaN, which checkZone tells.
QString cornersText(const std::vector<Eigen::Vector2d> &corners);
std::vector<Eigen::Vector2d> cornersOf(const QString &text);

} // namespace odo
