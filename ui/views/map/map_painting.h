// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/task.h"
#include "core/calibration/marker_layout.h"
#include "core/project/records.h"
#include "ui/views/charts/chart_image.h"

#include <Eigen/Geometry>
#include <QColor>
#include <QPointF>
#include <QSizeF>
#include <QWidget>
#include <functional>
#include <optional>

class QPainter;
class QPalette;

namespace odo {

/// Where the floor lies in a map seen from above: X to the right, Y up.
struct MapPlan
{
    static constexpr double sideMargin = 26, topMargin = 24;
    static constexpr double footHeight = 30; ///< for the scale and the legend

    Eigen::AlignedBox2d bounds{Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)}; ///< that must be seen, metres
    QSizeF size;                                                              ///< of the widget
    double zoom = 1; ///< so many times larger than where all of it is seen
    QPointF shift{}; ///< as ZoomState

    /// Where it is shown as large as it can be: a millimetre is four pixels.
    double mostZoom() const;
    /// What is seen of it, with room for the width of lines.
    QRectF seen() const;
    double scalePx() const; ///< logical pixels a metre
    QPointF fromWorld(const Eigen::Vector2d &point) const;
    Eigen::Vector2d toWorld(const QPointF &position) const;
};

/// A line every round distance, and the distance at the foot.
void drawMapGrid(QPainter &painter, const MapPlan &plan, const QPalette &palette, bool overImage);
/// The foot is kept calm, so that scale and legend can be read over any floor.
void drawMapFoot(QPainter &painter, const MapPlan &plan, const QPalette &palette);
/// The markers of a layout with their labels, outside of the field.
void drawMapMarkers(QPainter &painter, const MapPlan &plan, const MarkerLayout &layout,
                    const QPalette &palette);

/// A robot where it is now.
struct MapRobot
{
    const RobotRecord *robot = nullptr;
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    double sigmaXM = 0, sigmaYM = 0;
    std::optional<double> headingRad; ///< empty: not known
    QColor colour;
    QString label; ///< may be empty
    /// What the position is of: forward and left from the footprint's centre. Zero: of the centre itself.
    Eigen::Vector2d referenceM = Eigen::Vector2d::Zero();
};
/// A haze of two σ, and the robot's footprint where it is known and large enough, else a dot, with a point
/// towards the heading. A reference point that is not the centre has a cross, with the footprint beside it if
/// the heading is known.
void drawMapRobot(QPainter &painter, const MapPlan &plan, const MapRobot &robot, const QPalette &palette);

/// A robot from above, heading to the right, with the point of it that is measured.
class RobotFootprint : public QWidget
{
    Q_OBJECT
public:
    explicit RobotFootprint(QWidget *parent = nullptr);

    /// Its size, reference point and colour count. One without a size is drawn with a usual one, which
    /// words() say.
    void setRobot(const RobotRecord &robot);
    QString words() const;

    QSize sizeHint() const override { return {220, 150}; }
    QSize minimumSizeHint() const override { return {120, 130}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    RobotRecord m_robot; ///< with a size
    bool m_isSizeGiven = false;
};

/// From a point of the floor, metres, to the screen.
using FloorToScreen = std::function<QPointF(const Eigen::Vector2d &)>;

/// The course to follow, dashed to distinguish it from one that was driven.
void drawReferencePath(QPainter &painter, const ReferencePath &path, const FloorToScreen &toScreen,
                       const QPalette &palette);
/// Each zone as an outline with its name: one to keep out of is hatched, of one to stay in the edge has teeth
/// on its outer side.
void drawZones(QPainter &painter, const std::vector<Zone> &zones, const FloorToScreen &toScreen,
               const QPalette &palette);
/// Each gate as a line between two posts with its name, and an arrow the way it is passed; start and finish
/// are heavier than splits.
void drawGates(QPainter &painter, const std::vector<Gate> &gates, const FloorToScreen &toScreen,
               const QPalette &palette);

/// A map of the floor of which all but the robots is painted once and kept, until size, palette or font
/// change. What is kept begins with the colour of the ground.
class MapCanvas : public QWidget
{
    Q_OBJECT
protected:
    explicit MapCanvas(QWidget *parent);

    /// All but what moves.
    virtual void paintStill(QPainter &painter) const = 0;
    /// Paints what is kept.
    void drawStill(QPainter &painter);
    /// Adds to what is kept, if anything is yet.
    void addToStill(const std::function<void(QPainter &)> &paint);
    /// It is repainted.
    void forgetStill();

    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    StillLayer m_still;
};

} // namespace odo
