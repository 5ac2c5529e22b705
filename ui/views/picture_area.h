// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/frame_fetcher.h"
#include "ui/views/picture_overlay.h"

#include <QPixmap>
#include <QWidget>

namespace odo {

class Timeline;

/// The picture of one view with its overlays; inside CameraView.
class PictureArea : public QWidget
{
    Q_OBJECT
public:
    explicit PictureArea(Timeline &timeline, QWidget *parent = nullptr);

    void setScene(TrialScenePtr scene, std::size_t view);
    void setOverlay(PictureOverlay overlay);
    void setRobotColour(const QColor &colour);
    void setOutlinesShown(bool shown);
    void setPointing(bool pointing);
    bool isSettled() const;
    QPointF fromPicture(const QPointF &pixel) const;

    QSize sizeHint() const override { return {480, 270}; }
    QSize minimumSizeHint() const override { return {160, 90}; }

Q_SIGNALS:
    void settled();
    void pointedAt(const QPointF &pixel, const QPoint &global);

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    const SceneView *sceneView() const;
    std::optional<qint64> wantedFrame() const;
    void ask();
    void showPicture(qint64 frame, const QImage &picture);
    void showFailure(qint64 frame, const QString &message);
    QSize pictureSize() const;
    QRectF pictureRect() const;
    bool pointAt(const QPoint &place, const QPoint &global);
    void renderFloorLayer();
    void paintRobots(QPainter &painter, qint64 frame) const;
    void paintMessage(QPainter &painter, const QString &message) const;

    Timeline &m_timeline;
    FrameFetcher m_fetcher;
    TrialScenePtr m_scene;
    PictureOverlay m_overlay;
    RobotLook m_look;
    std::size_t m_view = 0;
    QImage m_picture;
    qint64 m_shownFrame = -1; ///< that m_picture is of
    bool m_isOutside = false; ///< of the recording, when a frame was asked for last
    bool m_isPointing = false;
    QString m_failure;
    QPixmap m_floorLayer; ///< grid, axes and trails; null: to be rendered
};

} // namespace odo
