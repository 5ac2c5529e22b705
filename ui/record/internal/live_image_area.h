// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/record/internal/running_cameras.h"
#include "ui/views/image/image_overlay.h"

#include <QPixmap>
#include <QWidget>

namespace odo {

/// What a camera sees now, with the floor's axes, each robot's outline and the way it has driven.
class LiveImageArea : public QWidget
{
    Q_OBJECT
public:
    explicit LiveImageArea(QWidget *parent = nullptr);

    /// The floor as the camera sees it: a scene of views without robots; null: not known.
    void setFloor(TrialScenePtr floor, std::size_t view);
    void setRobots(std::vector<RobotRecord> robots);
    void setImage(const LiveFrame &live);
    /// Of a robot: where it is now; joins its way.
    void addPosition(std::size_t robot, const Eigen::Vector2d &position);
    void forgetPaths();
    /// Shown over the frame, or instead of it; empty: nothing.
    void setWords(const QString &words);

    bool hasFrame() const { return !m_live.image.isNull(); }
    QSize sizeHint() const override { return {480, 270}; }
    QSize minimumSizeHint() const override { return {200, 112}; }

Q_SIGNALS:
    void shownSizeChanged(const QSize &devicePixels);

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    using Positions = std::vector<std::optional<Eigen::Vector2d>>;
    /// Where a robot was in the last seconds.
    struct RobotPath
    {
        Positions positions;
        std::size_t inLayer = 0; ///< the first so many are painted in m_pathLayer
    };
    QRectF imageRect() const;
    ImageMap imageMap() const;
    const FloorView *floorView() const;
    void forgetLayers();
    void renderFloorLayer();
    void renderPathLayer();
    void paintPathOf(QPainter &painter, std::size_t robot, const Positions &positions) const;
    void paintRobots(QPainter &painter) const;

    TrialScenePtr m_floor;
    std::size_t m_view = 0;
    std::vector<RobotRecord> m_robots;
    std::vector<int> m_colours;     ///< of each robot, in the palette
    std::vector<RobotPath> m_paths; ///< of each robot
    LiveFrame m_live;
    QString m_words;
    QPixmap m_floorLayer; ///< grid and axes; null: to be rendered
    QPixmap m_pathLayer;  ///< m_floorLayer with the paths; null: to be rendered
};

} // namespace odo
