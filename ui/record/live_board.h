// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_health.h"
#include "ui/models/trial_scene.h"
#include "ui/record/running_cameras.h"

#include <QWidget>
#include <vector>

class QAction;
class QSplitter;

namespace odo {

class Card;
class FactList;
class LiveMap;
class LivePictureArea;

/// What goes on now: a picture a camera, the map, and how cameras, map and disk do.
class LiveBoard : public QWidget
{
    Q_OBJECT
public:
    /// tools: buttons beside the health.
    explicit LiveBoard(const QList<QAction *> &tools, QWidget *parent = nullptr);

    /// A card a camera, before the first picture too.
    void setCameras(const RunningCameras &running);
    void setFloor(const TrialScenePtr &floor);
    void setRobots(const std::vector<RobotRecord> &robots);
    /// To where the robots' places are sent; nullopt: nowhere.
    void setTarget(const std::optional<BroadcastTarget> &target);
    void setPicture(const LivePicture &picture);
    void addMoment(const LiveMoment &moment);
    void forgetWays();
    /// before: losses are counted from there.
    void setHealth(const CaptureHealth &health, const std::vector<WantedCamera> &cameras,
                   const LiveFigures &live, const CaptureHealth &before);

    const LiveMap &map() const { return *m_map; }
    const std::vector<LivePictureArea *> &pictures() const { return m_areas; }

Q_SIGNALS:
    void shownSizeChanged(std::size_t view, const QSize &devicePixels);

private:
    QSplitter *m_pictures;
    Card *m_mapCard;
    std::vector<Card *> m_cards;
    std::vector<LivePictureArea *> m_areas;
    LiveMap *m_map;
    FactList *m_health;
};

} // namespace odo
