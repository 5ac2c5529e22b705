// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_layout.h"

#include <QWidget>

namespace odo {

/// The markers from above, to scale, with the world's axes; they can be dragged, in steps of a centimetre.
class LayoutDrawing : public QWidget
{
    Q_OBJECT
public:
    explicit LayoutDrawing(QWidget *parent = nullptr);
    void setLayout(const MarkerLayout &layout, int current);
    QSize sizeHint() const override { return {420, 360}; }
    QSize minimumSizeHint() const override { return {240, 200}; }

Q_SIGNALS:
    void picked(int marker);
    void moved(int marker, const Eigen::Vector2d &pointInWorld);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void fit();
    QPointF toScreen(const Eigen::Vector2d &point) const;
    Eigen::Vector2d toWorld(const QPointF &place) const;

    MarkerLayout m_layout;
    int m_current = -1;
    bool m_dragging = false;
    Eigen::Vector2d m_middle = Eigen::Vector2d::Zero();
    double m_pixelsPerMetre = 100;
};

} // namespace odo
