// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_health.h"
#include "core/trajectory/live_track.h"
#include "ui/models/trial_scene.h"
#include "ui/record/internal/health_watch.h"
#include "ui/record/internal/running_cameras.h"
#include "ui/views/map/map_painting.h"

#include <QList>
#include <QPointer>
#include <QWidget>
#include <functional>
#include <vector>

class QAction;
class QSplitter;

namespace odo {

class Card;
class FactList;
class LiveMap;
class LiveImageArea;

/// The live state: a frame per camera, the map, and the health of cameras, map and disk.
class LiveBoard : public QWidget
{
    Q_OBJECT
public:
    /// tools: buttons beside the health.
    explicit LiveBoard(const QList<QAction *> &tools, QWidget *parent = nullptr);

    /// One card per camera, even before the first frame.
    void setCameras(const RunningCameras &running);
    void setFloor(const TrialScenePtr &floor);
    void setRobots(const std::vector<RobotRecord> &robots);
    /// Where the robots' positions are sent; nullopt: nowhere.
    void setTarget(const std::optional<BroadcastTarget> &target);
    void setImage(const LiveFrame &live);
    void addMoment(const LiveMoment &moment);
    void forgetPaths();
    /// One more that shows the same from now on; the caller owns it.
    QWidget *makeMap();
    /// before: losses are counted from there.
    void setHealth(const CaptureHealth &health, const std::vector<WantedCamera> &cameras,
                   const LiveStatistics &live, const CaptureHealth &before);

    const LiveMap &map() const { return *m_map; }
    const std::vector<LiveImageArea *> &imageAreas() const { return m_areas; }

Q_SIGNALS:
    void shownSizeChanged(std::size_t view, const QSize &devicePixels);
    void momentShown(); ///< a robot is somewhere else

private:
    /// On the map and those that were made besides.
    void onMaps(const std::function<void(LiveMap &)> &act);
    QSplitter *m_images;
    Card *m_mapCard;
    std::vector<Card *> m_cards;
    std::vector<LiveImageArea *> m_areas;
    LiveMap *m_map;
    QList<QPointer<LiveMap>> m_moreMaps;
    TrialScenePtr m_floor;
    std::vector<RobotRecord> m_robots;
    FactList *m_health;
};

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
    void forgetPaths();

    /// The newest position of a robot; nullopt: not seen just now.
    std::optional<Eigen::Vector2d> latestPosition(std::size_t robot) const;

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
        std::vector<std::optional<Eigen::Vector2d>> path; ///< an empty element: not detected
        std::optional<LivePosition> now;
        std::optional<double> headingRad;
    };
    MapPlan plan() const;
    void paintStill(QPainter &painter) const override;
    void drawStep(QPainter &painter, std::size_t robot, std::size_t to) const;
    QColor colourOf(std::size_t robot) const;

    TrialScenePtr m_floor;
    std::vector<Driven> m_robots;
    std::vector<int> m_positions; ///< of their colours in the palette
};

} // namespace odo
