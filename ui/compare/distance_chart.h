// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/comparison_curves.h"
#include "ui/views/card.h"
#include "ui/views/chart_painting.h"
#include "ui/views/still_layer.h"

#include <QStringList>

namespace odo {

class ChartBubbles;
class SeriesKey;
class Timeline;

/// The plot of one quantity of all runs against the distance; inside DistanceChart. The cursor stands where
/// the first run is at the shared time; a click, a drag or the arrow keys move it.
class DistanceArea : public QWidget
{
    Q_OBJECT
public:
    DistanceArea(Timeline &timeline, Compared what, QWidget *parent = nullptr);

    void setScene(ComparisonScenePtr scene);
    QPointF positionOf(double distanceM, double value) const { return plot().at(distanceM, value); }

    QSize sizeHint() const override { return {640, 180}; }
    QSize minimumSizeHint() const override { return {220, 90}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;

private:
    const ChartPlot &plot() const { return m_plot; }
    void setRanges();
    void paintCursor(QPainter &painter) const;
    void goTo(double x);

    Timeline &m_timeline;
    Compared m_what;
    ChartBubbles *m_bubbles;
    ComparisonScenePtr m_scene;
    std::vector<DistanceCurve> m_curves;
    ChartPlot m_plot;
    StillLayer m_still; ///< of plot
};

/// One quantity of all runs against the distance along the common path, with 95 % bands.
class DistanceChart : public Card
{
    Q_OBJECT
public:
    DistanceChart(Timeline &timeline, Compared what, QWidget *parent = nullptr);
    void setScene(ComparisonScenePtr scene);
    DistanceArea &area() const { return *m_area; }

private:
    Compared m_what;
    DistanceArea *m_area;
    QStringList m_names; ///< of the runs
    SeriesKey *m_key; ///< of the speed alone; the other chart stands below it
};

} // namespace odo
