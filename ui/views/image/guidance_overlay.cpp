// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/image/guidance_overlay.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

namespace odo {

namespace {

struct GuidanceWords
{
    Q_DECLARE_TR_FUNCTIONS(GuidanceWords)
};

// On images the colours do not follow the palette.
const QColor guideLine(255, 255, 255, 230), guideCasing(0, 0, 0, 190), guideDim(0, 0, 0, 120);

QPolygonF onImage(const std::vector<Eigen::Vector2d> &corners, const ImageMap &map)
{
    QPolygonF polygon;
    for (const Eigen::Vector2d &corner : corners)
        polygon << map({corner.x(), corner.y()});
    return polygon;
}

void strokeGuide(QPainter &painter, const QPainterPath &path, Qt::PenStyle style)
{
    painter.strokePath(path, QPen(guideCasing, 3.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(path, QPen(guideLine, 1.6, style, Qt::RoundCap, Qt::RoundJoin));
}

/// Two hatchings beside one another are seen on dark and on light floors.
void hatch(QPainter &painter, const QPolygonF &area)
{
    QPainterPath path;
    path.addPolygon(area);
    path.closeSubpath();
    painter.fillPath(path, guideDim);
    painter.fillPath(path, QBrush(QColor(255, 255, 255, 120), Qt::BDiagPattern));
    strokeGuide(painter, path, Qt::SolidLine);
}

void tagArea(QPainter &painter, const QPolygonF &area, const QString &text)
{
    drawTag(painter, QPointF(area.boundingRect().left() + 6, area.boundingRect().top() + 14), text, guideLine,
            painter.clipBoundingRect());
}

/// Dims all of the image but the areas.
void paintSearched(QPainter &painter, const std::vector<QPolygonF> &areas, const QRectF &image)
{
    if (areas.empty())
        return;
    QPainterPath searched;
    for (const QPolygonF &area : areas) {
        QPainterPath one;
        one.addPolygon(area);
        one.closeSubpath();
        searched = searched.united(one);
    }
    QPainterPath all;
    all.addRect(image);
    painter.fillPath(all.subtracted(searched), guideDim);
    strokeGuide(painter, searched, Qt::DashLine);
    for (const QPolygonF &area : areas)
        tagArea(painter, area, GuidanceWords::tr("searched"));
}

/// A cross at a position, which covers nothing of it.
void paintMark(QPainter &painter, const QPointF &at, const QString &text)
{
    constexpr double inner = 4, outer = 11;
    QPainterPath cross;
    for (const QPointF &direction : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        cross.moveTo(at + inner * direction);
        cross.lineTo(at + outer * direction);
    }
    strokeGuide(painter, cross, Qt::SolidLine);
    drawTag(painter, at + QPointF(outer + 4, outer), text, guideLine, painter.clipBoundingRect());
}

QString nameOf(const TrialScene &scene, RecordId robot)
{
    for (const SceneRobot &one : scene.robots)
        if (one.robot.id == robot)
            return QString::fromStdString(one.robot.name);
    return {};
}

} // namespace

void paintGuidance(QPainter &painter, const TrialScene &scene, std::size_t view, std::int64_t frame,
                   const ImageMap &map)
{
    const RecordingRecord &recording = scene.views[view].recording;
    std::vector<QPolygonF> searched;
    for (const GuidanceItem &item : scene.guidance)
        if (item.recording == recording.id && item.kind == GuidanceItem::Kind::Search)
            searched.push_back(onImage(item.pointsPx, map));
    paintSearched(painter, searched,
                  {map({-0.5, -0.5}), map({recording.widthPx - 0.5, recording.heightPx - 0.5})});
    for (const GuidanceItem &item : scene.guidance) {
        if (item.recording != recording.id || item.kind != GuidanceItem::Kind::Ignore)
            continue;
        const QPolygonF area = onImage(item.pointsPx, map);
        hatch(painter, area);
        tagArea(painter, area, GuidanceWords::tr("ignored"));
    }
    for (const GuidanceItem &item : scene.guidance) {
        if (item.recording != recording.id || frame < item.fromFrame || frame > item.toFrame)
            continue;
        if (item.kind == GuidanceItem::Kind::Point)
            paintMark(painter, map({item.pointsPx.front().x(), item.pointsPx.front().y()}),
                      GuidanceWords::tr("%1 set by hand").arg(nameOf(scene, item.robot)));
        else if (item.kind == GuidanceItem::Kind::Hidden)
            drawTag(painter, map({8, 16}),
                    item.robot == 0
                        ? GuidanceWords::tr("no robot visible, by hand")
                        : GuidanceWords::tr("%1 not visible, by hand").arg(nameOf(scene, item.robot)),
                    guideLine, painter.clipBoundingRect());
    }
    for (const PointedOutRobot &seed : scene.pointedOut)
        if (seed.recording == recording.id && seed.frame == frame)
            paintMark(painter, map({seed.pixel.x(), seed.pixel.y()}),
                      GuidanceWords::tr("%1 marked here").arg(nameOf(scene, seed.robot)));
}

void paintDrawnArea(QPainter &painter, GuidanceItem::Kind kind, const QPolygonF &corners,
                    const std::optional<QPointF> &mouse, const ImageMap &map)
{
    QPolygonF shown;
    for (const QPointF &corner : corners)
        shown << map(corner);
    if (mouse)
        shown << map(*mouse);
    if (shown.isEmpty())
        return;
    if (kind == GuidanceItem::Kind::Ignore && shown.size() > 2) {
        hatch(painter, shown);
    } else {
        QPainterPath path;
        path.addPolygon(shown);
        strokeGuide(painter, path, Qt::DashLine);
    }
    constexpr double cornerRadius = 3.5;
    painter.setPen(QPen(guideCasing, 1));
    painter.setBrush(guideLine);
    for (const QPointF &corner : corners)
        painter.drawEllipse(map(corner), cornerRadius, cornerRadius);
}

} // namespace odo
