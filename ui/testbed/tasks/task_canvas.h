// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_layout.h"
#include "core/trajectory/task.h"
#include "ui/views/map_canvas.h"
#include "ui/views/map_painting.h"

#include <optional>

namespace odo {

/// A task on the floor from above, with the markers of a layout. A gate is moved by dragging its line, turned
/// and widened by dragging an end. Keys: Page Up and Down choose a gate; arrows move it by 10 mm, with Shift
/// by 100 mm, with Ctrl by 1 mm; < and > turn it by 5°, + and − change its width by 20 mm. Changes nothing
/// itself: it asks by gateMoved.
class TaskCanvas : public MapCanvas
{
    Q_OBJECT
public:
    explicit TaskCanvas(QWidget *parent = nullptr);

    /// What is not to be changed: it only shows.
    void setEditable(bool editable) { m_editable = editable; }
    void setLayout(const std::optional<MarkerLayout> &layout);
    void setTask(const Task &task);
    void setCurrentGate(int gate); ///< −1: none
    int currentGate() const { return m_current; }
    QPointF fromWorld(const Eigen::Vector2d &point) const { return plan().fromWorld(point); }

    QSize sizeHint() const override { return {560, 460}; }
    QSize minimumSizeHint() const override { return {240, 200}; }

Q_SIGNALS:
    void gatePicked(int gate);
    void gateMoved(int gate, const Eigen::Vector2d &from, const Eigen::Vector2d &to);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    enum class Part { None, From, To, Line };
    MapPlan plan() const;
    void fit();
    void paintStill(QPainter &painter) const override;
    void paintCurrent(QPainter &painter) const;
    void pick(int gate);
    void describe();
    bool moveByKey(const QKeyEvent &event);

    std::optional<MarkerLayout> m_layout;
    Task m_task;
    Eigen::AlignedBox2d m_bounds; ///< of the floor that must be seen
    int m_current = -1;
    bool m_editable = true;
    Part m_dragged = Part::None;
    Eigen::Vector2d m_grabbedAt = Eigen::Vector2d::Zero();
    Gate m_grabbed; ///< as it was when it was taken
};

} // namespace odo
