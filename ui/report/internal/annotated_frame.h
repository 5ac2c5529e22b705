// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/charts/trial_curves.h"
#include "ui/views/map/floor_image.h"
#include "ui/views/map/map_painting.h"

#include <QFont>
#include <QImage>
#include <QPalette>
#include <vector>

namespace odo {

/// How an annotated image looks.
struct AnnotationStyle
{
    QSize sizePx{1920, 1080};
    QPalette palette; ///< lightPalette() or darkPalette()
    QFont font;       ///< of the window; its size is chosen to fit
    double speed = 1; ///< of playback, shown beside the time
};

/// What a view shows at a moment.
struct ViewMoment
{
    QImage image;            ///< of AnnotatedFrame::viewSizePx; null: none
    std::int64_t frame = -1; ///< of the recording; -1: the camera was not recording then
};

/// A trial at a moment as one image: all views with outline, trail and name, the floor from above, and the
/// speed with a cursor; painted by what paints Review. What is not known (no registration, not tracked) is
/// omitted, and the rest is larger. Any thread, one at a time; text needs a QGuiApplication.
class AnnotatedFrame
{
public:
    AnnotatedFrame(TrialScenePtr scene, AnnotationStyle style);

    /// Where the floor is shown: how large, and which part of it, for makeFloorImage; no side: there is no
    /// map.
    int floorSidePx() const;
    Eigen::AlignedBox2d floorExtent() const;
    /// Of the floor from above; before the first paint.
    void setFloor(FloorImage floor) { m_floor = std::move(floor); }

    /// The size at which the image of a view is shown.
    QSize viewSizePx(std::size_t view) const;
    /// Where things lie in it, in its pixels: a pixel of a recording, a point of the floor on the map, and a
    /// time and speed (in the unit that is shown) in the chart.
    QPointF fromImagePixels(std::size_t view, const QPointF &pixel) const;
    QPointF fromWorld(const Eigen::Vector2d &point) const;
    QPointF fromChart(Nanoseconds time, double speed) const;
    bool hasMap() const { return !m_map.isEmpty(); }
    bool hasChart() const { return !m_chart.isEmpty(); }

    /// The whole image at a time of the first view (Format_RGB32). One moment a view.
    QImage paint(Nanoseconds time, const std::vector<ViewMoment> &views);

private:
    void layOut();
    std::size_t columns() const;
    double viewsHeight(double width) const;
    void layOutViews(const QRectF &area);
    QRectF imageRect(std::size_t view) const;
    QPointF inView(std::size_t view, const QPointF &pixel) const;
    QFont font(double sizePx, bool isBold = false) const;
    QRect pixels(const QRectF &rect) const;
    void paintStill();
    void paintFloorLayer();
    void paintHeader(QPainter &painter) const;
    void paintMapStill(QPainter &painter) const;
    void paintChartStill(QPainter &painter);
    void paintTime(QPainter &painter, Nanoseconds time) const;
    void paintView(QPainter &painter, std::size_t view, const ViewMoment &moment) const;

    TrialScenePtr m_scene;
    AnnotationStyle m_style;
    double m_scale = 1;              ///< pixels of the image to one that is painted in
    QRectF m_header, m_map, m_chart; ///< empty: left out
    std::vector<QRectF> m_views;
    MapPlan m_plan;
    TrialCurves m_curves;
    ChartPlot m_plot; ///< within the chart, once it was painted
    double m_topSpeedMps = 0;
    FloorImage m_floor;
    QImage m_still; ///< what does not move; null: to be painted
    /// what does not move over the images of the views: grid, trails, axes, and their names
    QImage m_floorLayer;
};

} // namespace odo
