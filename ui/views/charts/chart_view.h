// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/charts/chart_image.h"
#include "ui/views/charts/internal/chart.h"

#include <QChartView>
#include <optional>

namespace odo {

class AxisSpan;

/// A chart on the screen: a part of its axis below, chosen by hand (ChartGestures) and shared with other
/// charts; a crosshair under the mouse with its values; colours of the palette, the font of the widget. What
/// does not move is kept as an image, so that moving a cursor costs a copy. Derived classes add what the
/// chart is about. GUI thread, raster only.
class ChartView : public QChartView
{
    Q_OBJECT
public:
    /// span: shared with other charts; must outlive this.
    ChartView(AxisSpan &span, const ChartAxes &axes, QWidget *parent = nullptr);
    ~ChartView() override;

    AxisSpan &span() const { return m_span; }
    /// Where values lie, in widget coordinates.
    ChartPlot plot() const { return m_chart->chartPlot(); }
    /// Values chosen by hand; nullopt: all.
    void showValues(std::optional<ValueRange> values);
    /// Everything, of both axes.
    void showAll();
    /// Curves of a group (ChartCurve::group) come and go, whatever the content.
    void setGroupShown(int group, bool isShown);
    bool isGroupShown(int group) const { return m_chart->isGroupShown(group); }
    /// The whole view for an image: without focus and crosshair.
    void paintImage(QPainter &painter);

    QSize sizeHint() const override { return {640, 180}; }
    QSize minimumSizeHint() const override { return {220, 90}; }

protected:
    /// All values are shown then; setContent must follow.
    void setAxes(const ChartAxes &axes);
    /// Values chosen by hand stay so.
    void setContent(ChartContentPtr content, std::vector<ChartStretch> stretches = {});
    void setOverlay(std::vector<ChartCurve> curves);
    void showAllGroups();

    /// What moves over the curves.
    virtual void paintOver(QPainter &painter) { Q_UNUSED(painter); }
    /// The left button was pressed at a position of the axis below, and was dragged on to another.
    virtual void goTo(double x) { Q_UNUSED(x); }
    virtual void dragTo(double from, double x)
    {
        Q_UNUSED(from);
        goTo(x);
    }
    /// The tool tip of a position.
    virtual QString wordsAt(const QPoint &position) const;

    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool viewportEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void refresh();
    void forget();
    void paintStill(QPainter &painter);
    void paintCrosshair(QPainter &painter) const;

    AxisSpan &m_span;
    Chart *m_chart;                     ///< of the scene
    std::optional<ValueRange> m_values; ///< chosen by hand
    std::optional<double> m_pressedX;   ///< of the left button
    bool m_isDragged = false;
    std::optional<QPointF> m_mouse; ///< within the plot
    StillLayer m_still;
};

} // namespace odo
