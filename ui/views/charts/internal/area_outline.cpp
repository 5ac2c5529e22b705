// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/internal/area_outline.h"

#include "ui/views/charts/internal/chart_series.h"

#include <QAreaSeries>
#include <QChart>
#include <QLineSeries>
#include <algorithm>

namespace odo {

QAreaSeries *newArea(QChart &chart)
{
    auto *area = new QAreaSeries;
    area->setUpperSeries(new QLineSeries(area));
    area->setLowerSeries(new QLineSeries(area));
    chart.addSeries(area);
    area->setPen(Qt::NoPen);
    return area;
}

void setEdges(QAreaSeries &area, const QList<QPointF> &upper, const QList<QPointF> &lower)
{
    area.upperSeries()->replace(upper);
    area.lowerSeries()->replace(lower);
}

void AreaOutline::add(double x, double low, double high)
{
    m_upper.append({x, high});
    m_lower.append({x, low});
}

void AreaOutline::leap(double x, double low, double high)
{
    if (!m_upper.isEmpty()) {
        const double last = m_upper.last().x(), middle = (m_upper.last().y() + m_lower.last().y()) / 2;
        add(last, middle, middle);
        add(x, (low + high) / 2, (low + high) / 2);
    }
    add(x, low, high);
}

ColumnOutline::ColumnOutline(const ChartColumns &columns)
    : m_low(columns.plot.low * columns.perSi),
      m_step((columns.plot.high - columns.plot.low) * columns.perSi / columns.count()),
      m_least((columns.plot.values.high - columns.plot.values.low) /
              std::max(1.0, columns.plot.rect.height()))
{
}

void ColumnOutline::add(int index, bool isJoined, double low, double high)
{
    if (high - low < m_least) {
        const double middle = (low + high) / 2;
        low = middle - m_least / 2;
        high = middle + m_least / 2;
    }
    const double left = m_low + index * m_step;
    if (!isJoined || m_isFirst) {
        close();
        m_outline.leap(left, low, high);
    }
    m_outline.add(left + m_step / 2, low, high);
    m_isFirst = false;
    m_right = left + m_step;
    m_lastLow = low;
    m_lastHigh = high;
}

void ColumnOutline::setTo(QAreaSeries &area)
{
    close();
    m_outline.setTo(area);
}

void ColumnOutline::close()
{
    if (!m_isFirst)
        m_outline.add(m_right, m_lastLow, m_lastHigh);
}

} // namespace odo
