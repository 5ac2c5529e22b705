// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/doubtful_stretches.h"
#include "ui/models/scene_disagreement.h"
#include "ui/views/floor_picture.h"
#include "ui/views/map_canvas.h"
#include "ui/views/map_painting.h"

namespace odo {

class Timeline;

/// What colours the trails of a map.
enum class MapColouring {
    Speed,
    Disagreement, ///< of the views: a dot a frame
};

/// The floor from above; inside FloorMap. A click on a trail goes to the time when the robot was there. A haze lies where less than usual is known of
/// a robot, with words where the mouse rests.
class MapArea : public MapCanvas
{
    Q_OBJECT
public:
    explicit MapArea(Timeline &timeline, QWidget *parent = nullptr);

    void setScene(TrialScenePtr scene);
    void setColouring(MapColouring colouring);
    /// Of each robot of the scene; empty: not known yet.
    void setDisagreements(std::vector<ViewDisagreement> disagreements);
    bool isSettled() const { return !m_maker.isRunning(); }
    QPointF fromWorld(const Eigen::Vector2d &point) const;

    QSize sizeHint() const override { return {340, 300}; }
    QSize minimumSizeHint() const override { return {160, 140}; }

Q_SIGNALS:
    void settled();

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;

private:
    /// When a robot was nearest to a place; nullopt where none came near.
    std::optional<Nanoseconds> timeNear(const QPointF &place) const;
    MapPlan plan() const;
    void paintStill(QPainter &painter) const override;
    void paintDisagreements(QPainter &painter) const;
    void paintLegend(QPainter &painter) const;

    Timeline &m_timeline;
    FloorPictureMaker m_maker;
    TrialScenePtr m_scene;
    std::vector<DoubtfulStretch> m_stretches; ///< of the scene
    Eigen::AlignedBox2d m_bounds; ///< of the floor that must be seen
    double m_topSpeedMps = 0;     ///< end of the colour scale
    FloorPicture m_floor;
    MapColouring m_colouring = MapColouring::Speed;
    std::vector<ViewDisagreement> m_disagreements;
    double m_topDisagreementM = 0; ///< end of its colour scale
};

} // namespace odo
