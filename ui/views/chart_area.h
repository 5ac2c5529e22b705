// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/chart_painting.h"
#include "ui/views/profile_chart.h"
#include "ui/views/profile_curve.h"

#include <QPixmap>
#include <QtCharts/QChartView>

class QAreaSeries;
class QLineSeries;
class QScatterSeries;
class QValueAxis;

namespace odo {

class Timeline;

/// The plot of one quantity; inside ProfileChart. What does not change with the time is kept as a picture, so
/// that moving the cursor costs a copy. Raster only.
class ChartArea : public QChartView
{
    Q_OBJECT
public:
    ChartArea(Timeline &timeline, Quantity quantity, QWidget *parent = nullptr);
    ~ChartArea() override;

    void setScene(TrialScenePtr scene);
    void setQuantity(Quantity quantity);
    /// Where a time and a value lie, in widget coordinates.
    QPointF positionOf(Nanoseconds time, double value) const;

    QSize sizeHint() const override { return {640, 180}; }
    QSize minimumSizeHint() const override { return {220, 110}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void drawBackground(QPainter *painter, const QRectF &rect) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    /// One stretch of one robot's curve: full data, and the series that show it.
    struct Run
    {
        int robot;
        CurveRun data;
        QLineSeries *line, *upper, *lower;
        QAreaSeries *band;
    };
    void clearSeries();
    void addRobot(int robot, const Profile &profile);
    void addSpikes(const Profile &profile);
    void setRanges();
    void refill();
    void applyColours();
    void forget();
    QRectF plotRect() const;
    ChartPlot plot() const;
    void drawPoints(QPainter &painter) const;
    void drawCursor(QPainter &painter) const;
    void goTo(double x);

    Timeline &m_timeline;
    Quantity m_quantity;
    TrialScenePtr m_scene;
    std::vector<Run> m_runs;
    std::vector<QList<QPointF>> m_measured; ///< a robot
    QList<QScatterSeries *> m_spikes;
    QValueAxis *m_timeAxis, *m_valueAxis;
    AxisTicks m_valueTicks;
    double m_startS = 0, m_endS = 1;
    QPixmap m_still; ///< null: to be rendered
};

} // namespace odo
