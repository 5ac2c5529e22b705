// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"
#include "ui/models/scene_uncertainty.h"
#include "ui/views/widgets/card.h"

#include <memory>
#include <vector>

class QAction;
class QComboBox;
class QToolButton;

namespace odo {

class MapArea;
class Timeline;
class ZoomPan;

/// The virtual top-down map: X to the right, Y up. The floor as the cameras see it (muted), a grid, the
/// markers, each robot's trail coloured by its speed or by how far the views disagree, its present position
/// with heading and σ, and the spikes.
class FloorMap : public Card
{
    Q_OBJECT
public:
    explicit FloorMap(Timeline &timeline, QWidget *parent = nullptr);
    ~FloorMap() override;

    void setScene(TrialScenePtr scene);
    /// True when the image of the floor is there (or is not available), and so is what colours the trails.
    bool isSettled() const;

    /// Colours by the views' disagreement instead of the speed; with words and key, for menus and pages.
    QAction *disagreementAction() const { return m_disagreement; }

    /// Where a point of the floor (metres) lies in the map area, in its widget coordinates.
    QPointF fromWorld(const Eigen::Vector2d &pointInWorld) const;
    QWidget *mapArea() const;
    /// How closely it is looked at.
    ZoomPan &zoom() const;

Q_SIGNALS:
    void settled();

private:
    void setColouring(bool byDisagreement);
    void compare();
    void takeComparison();
    void explain();

    MapArea *m_area;
    QComboBox *m_colouring;
    QToolButton *m_how;
    QAction *m_disagreement;
    TrialScenePtr m_scene;
    TrialScenePtr m_compared; ///< of which m_found is, or is being made
    std::shared_ptr<std::vector<ViewDisagreement>> m_found;
    BackgroundTask m_task;
};

} // namespace odo
