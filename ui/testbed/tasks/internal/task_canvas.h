// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/task.h"
#include "core/calibration/marker_layout.h"
#include "ui/views/map/map_painting.h"

#include <optional>

namespace odo {

/// A task on the floor from above, with the markers of a layout. A gate is moved by dragging its line, turned
/// and widened by dragging an end; a zone is moved by an edge, and a corner of it by itself. Keys: Page Up
/// and Down choose a gate or a zone; arrows move it by 10 mm, with Shift by 100 mm, with Ctrl by 1 mm; < and
/// > turn it by 5°, + and − change its width by 20 mm. Changes nothing itself: it asks by gateMoved and
/// zoneMoved.
class TaskCanvas : public MapCanvas
{
    Q_OBJECT
public:
    explicit TaskCanvas(QWidget *parent = nullptr);

    /// What is not to be changed: it only shows.
    void setEditable(bool editable) { m_editable = editable; }
    void setLayout(const std::optional<MarkerLayout> &layout);
    void setTask(const Task &task);
    void setCurrentGate(int gate); ///< −1: none; no zone is chosen then
    int currentGate() const { return m_current; }
    void setCurrentZone(int zone); ///< −1: none; no gate is chosen then
    int currentZone() const { return m_zone; }
    QPointF fromWorld(const Eigen::Vector2d &point) const { return plan().fromWorld(point); }

    QSize sizeHint() const override { return {560, 460}; }
    QSize minimumSizeHint() const override { return {240, 200}; }

Q_SIGNALS:
    void gatePicked(int gate);
    void gateMoved(int gate, const Eigen::Vector2d &from, const Eigen::Vector2d &to);
    void zonePicked(int zone);
    void zoneMoved(int zone, const std::vector<Eigen::Vector2d> &corners);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    enum class Part { None, From, To, Line, Corner, Zone };
    MapPlan plan() const;
    void fit();
    void paintStill(QPainter &painter) const override;
    void paintCurrent(QPainter &painter) const;
    void paintCurrentZone(QPainter &painter) const;
    void pick(int gate);
    bool grabGate(const QPointF &position);
    bool grabZone(const QPointF &position);
    void choose(int by);
    void describe();
    bool moveByKey(const QKeyEvent &event);

    std::optional<MarkerLayout> m_layout;
    Task m_task;
    Eigen::AlignedBox2d m_bounds;    ///< of the floor that must be seen
    int m_current = -1, m_zone = -1; ///< one of them at most is chosen
    bool m_editable = true;
    Part m_dragged = Part::None;
    Eigen::Vector2d m_grabbedAt = Eigen::Vector2d::Zero();
    Gate m_grabbed; ///< as it was when it was taken
    std::vector<Eigen::Vector2d> m_grabbedCorners;
    std::size_t m_grabbedCorner = 0;
};

} // namespace odo
