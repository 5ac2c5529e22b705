// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/observation.h"
#include "core/video/image.h"
#include "ui/models/trial_scene.h"

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QRectF>
#include <QSize>
#include <QString>
#include <functional>

class QColor;
class QPainter;
class QPainterPath;

namespace odo {

/// From a recording's image (pixel centres) to where it is painted.
using ImageMap = std::function<QPointF(const QPointF &pixel)>;

/// The outline of what a view took for a robot, where it is painted: the polygon that its support lines
/// bound, or its ellipse where only that was measured. Closed; empty where it was not found. outside: so much
/// beyond its edge, where it is painted. Pure.
QPainterPath outlinePath(const Observation &observation, const ImageMap &map, double outside = 0);

/// A line just outside of that outline in a robot's colour, with a dark casing that shows it on any floor;
/// dashed where the image's border cuts the robot. The robot's name is beside it, also without the line.
/// Gives the middle of its upper side.
QPointF paintOutline(QPainter &painter, const Observation &observation, const QString &name,
                     const QColor &colour, const ImageMap &map, bool withLine = true);

/// What a mode adds to the image of a view in a frame.
using ImageOverlay =
    std::function<void(QPainter &painter, std::size_t view, std::int64_t frame, const ImageMap &map)>;

/// The rectangle of the markers with a line every round distance, seen by the camera.
void paintFloorGrid(QPainter &painter, const TrialScene &scene, const FloorView &view, const ImageMap &map);
/// O→U and O→V as lines and the markers' labels.
void paintAxes(QPainter &painter, const TrialScene &scene, const FloorView &view, const ImageMap &map);
/// A path on the floor at a height; broken where a position is missing.
void paintPath(QPainter &painter, const std::vector<std::optional<Eigen::Vector2d>> &positions,
               double heightM, const FloorView &view, const ImageMap &map, const QColor &colour);
/// A robot that was not there: its box on the floor, where it would be seen, dashed, with a name. A robot
/// whose size is not known is a box of 200 mm.
struct GhostRobot
{
    const RobotRecord *robot = nullptr;
    double heightM = 0; ///< 0: not known
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    double headingRad = 0;
    QColor colour;
    QString name;
};
void paintGhost(QPainter &painter, const GhostRobot &ghost, const FloorView &view, const ImageMap &map);
/// A robot's smoothed track at the height that its positions were computed for.
void paintTrail(QPainter &painter, const TrialScene &scene, std::size_t robot, const FloorView &view,
                const ImageMap &map, const QColor &colour);
/// Whether painting the trails takes more than a few milliseconds.
bool hasLongTrail(const TrialScene &scene);
/// How robots are drawn in images.
struct RobotMarkStyle
{
    /// of trails and outlines; empty: of each robot its own (colourOnImage)
    std::optional<QColor> colour = {};
    bool withOutlines = true;
};
/// What does not move in an image: the floor's grid, the trails of all robots, and the axes. Nothing where
/// the view is not registered.
void paintFloor(QPainter &painter, const TrialScene &scene, std::size_t view, const ImageMap &map,
                const RobotMarkStyle &style = {});
/// The outline of the detected robot in a frame of this view, its name, and the reason when it is a spike. If
/// it was not detected because it was hidden: its name and the reason at its expected position; otherwise
/// nothing.
void paintRobot(QPainter &painter, const TrialScene &scene, std::size_t view, std::size_t robot,
                std::int64_t frame, const ImageMap &map, const RobotMarkStyle &style = {});

/// Text legible on any image: it has a dark rim. The point is the left end of the base line.
void drawHaloText(QPainter &painter, const QPointF &baseline, const QString &text, const QColor &colour);

/// Text in a dark, slightly transparent box that is kept inside `frame`; a long one is cut off, so that it
/// leaves the image to be seen. The point is the middle of its left edge.
void drawTag(QPainter &painter, const QPointF &leftMiddle, const QString &text, const QColor &colour,
             const QRectF &frame);

/// One line of what is under the mouse, in a dark box at the lower left of a frame; a long one is cut off.
void drawReadOut(QPainter &painter, const QRectF &frame, const QString &text);

/// The position of an image of a size in pixels in a widget, as large as fits, on whole device pixels, so
/// that it is not resampled once more. All of the widget for an empty size.
QRectF fittedRect(const QSize &imagePx, const QSizeF &widget, double devicePixelRatio);

/// Where a pixel of it lies; pixel (0,0) is the centre of the top-left one.
QPointF fromImagePixel(const QPointF &pixel, const QSize &imagePx, const QRectF &fitted);
/// The other way.
QPointF toImagePixel(const QPointF &position, const QSize &imagePx, const QRectF &fitted);

/// Hands the pixels over to a QImage without copying them.
QImage toImage(ScreenImage &&image);

} // namespace odo
