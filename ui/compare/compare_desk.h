// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/comparison_scene.h"
#include "ui/views/dock_desk.h"

#include <memory>
#include <vector>

class QComboBox;

namespace odo {

class Card;
class CameraView;
class CompareMap;
class DistanceChart;
class Timeline;

/// The left part of Compare, which a person can arrange: a picture of each of the first two runs with the ghost of the other, the map,
/// and the charts against the distance in docks.
class CompareDesk : public DockDesk
{
    Q_OBJECT
public:
    explicit CompareDesk(Timeline &timeline, QWidget *parent = nullptr);
    ~CompareDesk() override;

    void setScene(ComparisonScenePtr scene);
    CompareMap &map() const { return *m_map; }
    DistanceChart &speed() const { return *m_speed; }
    DistanceChart &difference() const { return *m_difference; }
    const std::vector<CameraView *> &pictures() const { return m_pictures; }
    bool isSettled() const;

Q_SIGNALS:
    void gatesMoved(const std::vector<odo::PathGate> &gates);
    void settled();

private:
    void followTime();
    void showViews();

    Timeline &m_timeline;
    ComparisonScenePtr m_scene;
    std::vector<Timeline *> m_clocks; ///< of the runs that are pictured, in step with the shared one
    std::vector<CameraView *> m_pictures;
    std::vector<QComboBox *> m_viewLists;
    Card *m_mapCard;
    CompareMap *m_map;
    DistanceChart *m_speed, *m_difference;
};

} // namespace odo
