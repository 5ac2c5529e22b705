// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/charts/internal/chart_plot.h"

#include <QColor>
#include <QList>

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

} // namespace odo
