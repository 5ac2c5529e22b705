// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_layout.h"
#include "ui/testbed/check/expected_accuracy.h"

#include <Eigen/Geometry>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

namespace odo {

/// A camera seen from above.
struct SketchedCamera
{
    QString name;
    Eigen::Vector3d pointInWorld;  ///< metres
    Eigen::Vector2d lookAtInWorld; ///< where the middle of its image meets the floor
    bool isPlanned = false;        ///< drawn dashed, and can be dragged, as can where it looks at
};

/// The testbed from above: markers, world axes, a grid of half a metre, camera positions and directions, and
/// the expected accuracy.
class FloorSketch : public QWidget
{
    Q_OBJECT
public:
    explicit FloorSketch(QWidget *parent = nullptr);
    void setTestbed(std::optional<MarkerLayout> layout, std::vector<SketchedCamera> cameras);
    void setAccuracy(std::optional<SketchedAccuracy> accuracy);
    QSize sizeHint() const override { return {340, 300}; }

    QPointF fromWorld(const Eigen::Vector2d &point) const;

Q_SIGNALS:
    void picked(int camera); ///< a planned one was taken hold of
    void cameraDragged(int camera, const Eigen::Vector2d &pointInWorld);
    void aimDragged(int camera, const Eigen::Vector2d &pointInWorld);

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    enum class Held { Nothing, Camera, Aim };
    void fit();
    bool paintGrid(QPainter &painter) const; ///< whether there are lines to be seen
    void paintCamera(QPainter &painter, const SketchedCamera &camera, const QColor &colour) const;
    void paintMarkers(QPainter &painter) const;

    std::optional<MarkerLayout> m_layout;
    std::vector<SketchedCamera> m_cameras;
    std::optional<SketchedAccuracy> m_accuracy;
    double m_pixelsPerMetre = 100;
    QPointF m_origin; ///< of the world, on the widget
    Held m_held = Held::Nothing;
    int m_heldCamera = -1;
};

} // namespace odo
