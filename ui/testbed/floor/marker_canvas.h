// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_detection.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/floor_view.h"

#include <QImage>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

namespace odo {

/// An image of the floor on which the user puts and drags markers, with a magnifier while one moves. A click
/// puts the current marker there; the arrow keys move it by a tenth of a pixel, with Shift by a whole one,
/// with Ctrl by twenty; Space asks to snap it to a nearby feature.
class MarkerCanvas : public QWidget
{
    Q_OBJECT
public:
    explicit MarkerCanvas(QWidget *parent = nullptr);
    /// size: of the image in whose pixels markers are given.
    void setImage(const QImage &image, QSize size);
    void setMarkers(std::vector<MarkerPixel> markers);
    void setCurrent(const QString &label);
    /// The floor's grid and axes as the registration sees them; nullopt: none.
    void setFloor(const std::optional<FloorView> &view, const MarkerLayout &layout);
    /// A line from the first marker to the second, as of a length that is measured.
    void setJoined(bool joined);
    void setEmptyText(const QString &text);

    QSize sizeHint() const override { return {720, 405}; }
    QSize minimumSizeHint() const override { return {320, 180}; }
    QPointF fromPixel(const Eigen::Vector2d &pixel) const;

Q_SIGNALS:
    /// A marker was set or moved; snap: by the mouse or by Space, so a mark near it may have been
    /// meant.
    void markerSet(const QString &label, const Eigen::Vector2d &pixel, bool snap);
    void picked(const QString &label); ///< a marker that was there already

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    QRectF imageRect() const;
    Eigen::Vector2d toPixel(const QPointF &position) const;
    MarkerPixel *markerAt(const QPointF &position);
    MarkerPixel *current();
    void paintFloor(QPainter &painter) const;
    void paintMarkers(QPainter &painter) const;
    void paintMagnifier(QPainter &painter) const;

    QImage m_image;
    QSize m_size;
    std::vector<MarkerPixel> m_markers;
    QString m_current, m_emptyText;
    std::optional<FloorView> m_view;
    MarkerLayout m_layout;
    bool m_dragging = false, m_movedByKeys = false, m_joined = false;
};

/// The kind of feature that a click snapped to: "tape crossing"; "by hand" if nothing was near.
QString snappedWords(SnappedMarker::Kind kind);

} // namespace odo
