// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/curves/chart_content.h"

#include <QColor>
#include <QList>
#include <QPointF>

class QAbstractAxis;
class QAbstractSeries;
class QAreaSeries;
class QChart;
class QLineSeries;
class QPalette;
class QScatterSeries;

namespace odo {

/// Pixel columns of a plot.
struct ChartColumns
{
    ChartPlot plot;
    double perSi = 1;    ///< the axis below shows so many of its units for one of the SI's
    double fineness = 1; ///< columns to a pixel: more for print
    int count() const;
    double middleOf(int column) const; ///< on the axis below, in its unit
    /// No further apart than the eye would see.
    bool areAlike(double low, double high) const;
};

/// The series of Qt Charts that show one ChartCurve. Where more of its points are visible than there are
/// columns, the extremes of each column are joined; a band is an area. GUI thread.
class ChartSeries
{
public:
    /// The chart, which has the series as long as this lives, must outlive it; curve must live while it is
    /// shown.
    ChartSeries(QChart &chart, const ChartCurve &curve);
    ~ChartSeries();
    Q_DISABLE_COPY_MOVE(ChartSeries)
    void attach(QAbstractAxis *below, QAbstractAxis *left);
    /// Without points, so that a change of the axes costs nothing.
    void clear();
    /// Gives how many points that takes to draw.
    qsizetype show(const ChartColumns &columns);
    /// Lines of one pixel, without dashes: a tenth of the work.
    void setCoarse(bool isCoarse);
    void setPalette(const QPalette &palette);
    void setShown(bool isShown);
    const ChartCurve &curve() const { return *m_curve; }

private:
    qsizetype showLine(const ChartColumns &columns);
    qsizetype showDenseLine(const ChartColumns &columns);
    qsizetype showDensePoints(const ChartColumns &columns);
    void showDenseBand(const ChartColumns &columns);
    qsizetype showPoints(const ChartColumns &columns);
    qsizetype showSpikes(const ChartColumns &columns);
    qsizetype showBars(const ChartColumns &columns);
    QLineSeries *line(qsizetype index);
    void setPens();
    void setPen(QLineSeries &series) const;
    QList<QAbstractSeries *> all() const;

    QChart &m_chart;
    const ChartCurve *m_curve;
    QAbstractAxis *m_below = nullptr, *m_left = nullptr;
    QAreaSeries *m_band = nullptr; ///< or the bars
    QList<QLineSeries *> m_lines;  ///< one a run that is visible; of points the one that shows them
    QScatterSeries *m_spikes = nullptr;
    QColor m_colour, m_rim;
    bool m_isShown = true, m_isCoarse = false;
};

struct ChartColumns;

/// An area without an outline, for a colour to be filled with; of the chart. GUI thread, as all here.
QAreaSeries *newArea(QChart &chart);
/// Its upper and lower edge: as many points, of the same x.
void setEdges(QAreaSeries &area, const QList<QPointF> &upper, const QList<QPointF> &lower);

/// The outline of an area that may have gaps: across a gap it runs below the plot and has no height, so
/// nothing is filled. (Some programs paint a line where a page's area has no height.)
class AreaOutline
{
public:
    explicit AreaOutline(const ValueRange &values = {})
        : m_belowPlot(values.low - (values.high - values.low) / 4)
    {
    }
    void add(double x, double low, double high);
    /// Closes what was added before and opens the next piece at x.
    void leap(double x, double low, double high);
    void setTo(QAreaSeries &area) const { setEdges(area, m_upper, m_lower); }

private:
    QList<QPointF> m_upper, m_lower;
    double m_belowPlot;
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
