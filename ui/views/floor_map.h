// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/card.h"

namespace odo {

class MapArea;
class Timeline;

/// The virtual top-down map: X to the right, Y up. The floor as the cameras see it (muted), a grid, the
/// markers, each robot's trail coloured by its speed, its place now with heading and σ, and the spikes.
class FloorMap : public Card
{
    Q_OBJECT
public:
    explicit FloorMap(Timeline &timeline, QWidget *parent = nullptr);
    ~FloorMap() override;

    void setScene(TrialScenePtr scene);
    /// True when the picture of the floor is there (or cannot be had).
    bool isSettled() const;

    /// Where a point of the floor (metres) lies in the map area, in its widget coordinates.
    QPointF fromWorld(const Eigen::Vector2d &pointInWorld) const;
    QWidget *mapArea() const;

Q_SIGNALS:
    void settled();

private:
    MapArea *m_area;
};

} // namespace odo
