// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/image/frame_fetcher.h"
#include "ui/views/image/image_overlay.h"

#include <QImage>
#include <QWidget>
#include <optional>

namespace odo {

class PatientLayer;
class Timeline;
class ZoomPan;

/// The image of one view with its overlays; inside CameraView.
class ImageArea : public QWidget
{
    Q_OBJECT
public:
    explicit ImageArea(Timeline &timeline, QWidget *parent = nullptr);

    void setScene(TrialScenePtr scene, std::size_t view);
    void setOverlay(ImageOverlay overlay);
    void setRobotColour(const QColor &colour);
    void setOutlinesShown(bool shown);
    void setLoupeShown(bool shown);
    void setPointing(bool pointing);
    void setReadOut(const QString &text);
    bool isSettled() const;
    QPointF fromImagePixels(const QPointF &pixel) const;
    ZoomPan &zoom() const { return *m_zoom; }

    QSize sizeHint() const override { return {480, 270}; }
    QSize minimumSizeHint() const override { return {160, 90}; }

Q_SIGNALS:
    void settled();
    void pointedAt(const QPointF &pixel, const QPoint &global);
    void hovered(const std::optional<QPointF> &pixel);

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    const SceneView *sceneView() const;
    std::optional<qint64> wantedFrame() const;
    void ask();
    void showImage(qint64 frame, const QImage &image);
    void showFailure(qint64 frame, const QString &message);
    QSize imageSizePx() const;
    QRectF imageRect() const;
    QSize wantedSize() const;
    void frameImage();
    void showZoomed();
    void paintImage(QPainter &painter) const;
    bool pointAt(const QPoint &position, const QPoint &global);
    void drawFloor(QPainter &painter);
    void paintRobots(QPainter &painter, qint64 frame) const;
    void paintLoupe(QPainter &painter, qint64 frame) const;
    void paintMessage(QPainter &painter, const QString &message) const;

    Timeline &m_timeline;
    ZoomPan *m_zoom;
    FrameFetcher m_fetcher;
    TrialScenePtr m_scene;
    ImageOverlay m_overlay;
    RobotMarkStyle m_style;
    std::size_t m_view = 0;
    QImage m_image;
    qint64 m_shownFrame = -1; ///< that m_image is of
    bool m_isOutside = false; ///< of the recording, when a frame was asked for last
    bool m_isPointing = false;
    bool m_hasLoupe = false; ///< about the robot
    QString m_failure, m_readOut;
    PatientLayer *m_floorLayer; ///< grid, axes and trails
};

} // namespace odo
