// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_layout.h"

#include <Eigen/Core>
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
    Eigen::Vector2d lookAtInWorld; ///< where the middle of its picture meets the floor
};

/// The testbed from above: markers, world axes, a grid of half a metre, and where the cameras stand and look.
class FloorSketch : public QWidget
{
    Q_OBJECT
public:
    explicit FloorSketch(QWidget *parent = nullptr);
    void setTestbed(std::optional<MarkerLayout> layout, std::vector<SketchedCamera> cameras);
    QSize sizeHint() const override { return {340, 300}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    std::optional<MarkerLayout> m_layout;
    std::vector<SketchedCamera> m_cameras;
};

} // namespace odo
