// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/outline_painting.h"

#include "core/geometry/support.h"
#include "ui/views/halo_text.h"

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <QTransform>
#include <numbers>

namespace odo {

namespace {

constexpr double lineWidth = 1.6, casingWidth = 3.6;
const QColor casing(0, 0, 0, 170);

QPainterPath ellipsePath(const Ellipse &ellipse, const PictureMap &map, double scale, double outside)
{
    const QPointF centre = map({ellipse.centrePx.x(), ellipse.centrePx.y()});
    QPainterPath path;
    path.addEllipse(QPointF(0, 0), ellipse.semiMajorPx * scale + outside, ellipse.semiMinorPx * scale + outside);
    QTransform turned;
    turned.translate(centre.x(), centre.y());
    turned.rotate(ellipse.angleRad * 180 / std::numbers::pi);
    return turned.map(path);
}

} // namespace

QPainterPath outlinePath(const Observation &observation, const PictureMap &map, double outside)
{
    const double scale = map({1, 0}).x() - map({0, 0}).x();
    if (!observation.found || scale <= 0)
        return {};
    const std::vector<float> &support = observation.supportPx;
    if (supportPolygon(support, observation.ellipse.centrePx).empty())
        return ellipsePath(observation.ellipse, map, scale, outside);
    std::vector<float> wider;
    for (const float reach : support)
        wider.push_back(reach + float(outside / scale));
    const std::vector<Eigen::Vector2d> corners = supportPolygon(wider, observation.ellipse.centrePx);
    QPolygonF polygon;
    for (const Eigen::Vector2d &corner : corners)
        polygon << map({corner.x(), corner.y()});
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    return path;
}

QPointF paintOutline(QPainter &painter, const Observation &observation, const QString &name, const QColor &colour, const PictureMap &map,
                     bool withLine)
{
    const QPainterPath path = outlinePath(observation, map, casingWidth / 2); // beside the robot, which may be small, not on it
    if (path.isEmpty())
        return map({observation.ellipse.centrePx.x(), observation.ellipse.centrePx.y()});
    if (withLine) {
        QPen line(colour, lineWidth, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
        if (observation.touchesBorder)
            line.setDashPattern({3, 2.5});
        painter.strokePath(path, QPen(casing, casingWidth, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
        painter.strokePath(path, line);
    }
    constexpr double clearance = 6; // beside the line
    const QRectF box = path.boundingRect();
    drawTag(painter, QPointF(box.right() + clearance, box.center().y()), name, colour, painter.clipBoundingRect());
    return {box.center().x(), box.top() - clearance / 2};
}

} // namespace odo
