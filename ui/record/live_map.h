// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/live_track.h"
#include "ui/models/trial_scene.h"
#include "ui/record/health_words.h"
#include "ui/views/map_canvas.h"
#include "ui/views/map_painting.h"

namespace odo {

/// The floor from above while the robots drive: markers, the task's gates and path, where each robot is and
/// has been.
class LiveMap : public MapCanvas
{
    Q_OBJECT
public:
    explicit LiveMap(QWidget *parent = nullptr);

    /// A scene of a layout and a task, without robots; null: no camera is registered.
    void setFloor(TrialScenePtr floor);
    void setRobots(std::vector<RobotRecord> robots);
    void addPosition(std::size_t robot, const LivePosition &position);
    void forgetWays();

    /// The newest place of a robot; nullopt: not seen just now.
    std::optional<Eigen::Vector2d> place(std::size_t robot) const;

    /// Where each robot is; those that have not been heard of for a while are not seen.
    std::vector<SeenRobot> robots() const;

    QSize sizeHint() const override { return {420, 300}; }
    QSize minimumSizeHint() const override { return {180, 140}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    struct Driven
    {
        RobotRecord robot;
        std::vector<std::optional<Eigen::Vector2d>> way; ///< empty places: it was not seen
        std::optional<LivePosition> now;
        std::optional<double> headingRad;
    };
    MapPlan plan() const;
    void paintStill(QPainter &painter) const override;
    void drawStep(QPainter &painter, std::size_t robot, std::size_t to) const;
    QColor colourOf(std::size_t robot) const;

    TrialScenePtr m_floor;
    std::vector<Driven> m_robots;
    std::vector<int> m_places; ///< of their colours in the palette
};

} // namespace odo
