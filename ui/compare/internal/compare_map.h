// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/comparison_scene.h"
#include "ui/views/map/floor_image.h"
#include "ui/views/map/map_painting.h"

#include <optional>

namespace odo {

class Timeline;
class ZoomPan;

/// The floor from above with the paths of all runs, the robots at the shared time, and the gates of the
/// sectors, which can be dragged along the common path. With the focus: Up and Down choose a gate, Left and
/// Right move it by 10 mm, with Shift by 100 mm; Esc lets go. A click on a path goes there.
class CompareMap : public MapCanvas
{
    Q_OBJECT
public:
    explicit CompareMap(Timeline &timeline, QWidget *parent = nullptr);

    void setScene(ComparisonScenePtr scene);
    void setGates(std::vector<PathGate> gates);
    const std::vector<PathGate> &gates() const { return m_gates; }
    ZoomPan &zoom() const { return *m_zoom; }
    bool isSettled() const { return !m_maker.isRunning(); }
    QPointF fromWorld(const Eigen::Vector2d &point) const { return plan().fromWorld(point); }
    /// The middle of a gate.
    QPointF gatePosition(std::size_t gate) const;

    QSize sizeHint() const override { return {340, 300}; }
    QSize minimumSizeHint() const override { return {160, 140}; }

Q_SIGNALS:
    void gatesMoved(const std::vector<odo::PathGate> &gates);
    void settled();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    MapPlan fittedPlan() const;
    MapPlan plan() const;
    void showFloor();
    const ReferencePath &path() const { return m_scene->compared.comparison.path; }
    void paintStill(QPainter &painter) const override;
    void paintRobots(QPainter &painter) const;
    QLineF gateLine(std::size_t gate) const;
    std::optional<std::size_t> gateAt(const QPointF &position) const;
    void moveGate(std::size_t gate, double stationM);
    double nearestStation(const QPointF &position, double aroundM) const;
    void goToNearest(const QPointF &position);
    bool wants(const QKeyEvent &event) const;

    Timeline &m_timeline;
    ZoomPan *m_zoom;
    FloorImageMaker m_maker;
    ComparisonScenePtr m_scene;
    Eigen::AlignedBox2d m_bounds{Eigen::Vector2d(0, 0),
                                 Eigen::Vector2d(1, 1)}; ///< of the floor that must be seen
    FloorImage m_floor;
    std::vector<PathGate> m_gates;
    std::optional<std::size_t> m_chosen; ///< gate
    bool m_isDragged = false;
};

} // namespace odo
