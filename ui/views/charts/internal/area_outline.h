// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPointF>

class QAreaSeries;
class QChart;

namespace odo {

struct ChartColumns;

/// An area without an outline, for a colour to be filled with; of the chart. GUI thread, as all here.
QAreaSeries *newArea(QChart &chart);
/// Its upper and lower edge: as many points, of the same x.
void setEdges(QAreaSeries &area, const QList<QPointF> &upper, const QList<QPointF> &lower);

/// The outline of an area that may have gaps: across a gap it has no height, so that nothing is filled.
class AreaOutline
{
public:
    void add(double x, double low, double high);
    /// Closes what was added before and opens the next piece at x.
    void leap(double x, double low, double high);
    void setTo(QAreaSeries &area) const { setEdges(area, m_upper, m_lower); }

private:
    QList<QPointF> m_upper, m_lower;
};

/// Columns as an outline, none of them lower than a pixel. A column that is not joined to the one before it
/// is as wide as a column is.
class ColumnOutline
{
public:
    explicit ColumnOutline(const ChartColumns &columns);
    void add(int index, bool isJoined, double low, double high);
    void setTo(QAreaSeries &area);

private:
    void close();

    AreaOutline m_outline;
    double m_low, m_step, m_least;
    bool m_isFirst = true;
    double m_right = 0, m_lastLow = 0, m_lastHigh = 0;
};

} // namespace odo
