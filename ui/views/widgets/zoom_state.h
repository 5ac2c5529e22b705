// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>

namespace odo {

/// How much larger something is shown than where all of it fits, and which part of it: a point at p where it
/// fits is shown at scale() · p + shift(). What is shown never leaves the view empty where it could fill it.
/// In logical pixels. A plain value.
class ZoomState
{
public:
    /// fitted: where all of it is seen; view: what it is seen through; mostScale: not larger than that. The
    /// middle of the view stays in the middle, and what was fitted stays fitted.
    void setFrame(const QRectF &fitted, const QRectF &view, double mostScale);

    double scale() const { return m_scale; }
    QPointF shift() const { return m_shift; }
    bool isFitted() const { return m_scale <= 1; }
    bool isClosest() const { return m_scale >= m_mostScale; }
    QPointF toShown(const QPointF &fitted) const { return m_scale * fitted + m_shift; }
    QRectF toShown(const QRectF &fitted) const;
    QPointF toFitted(const QPointF &shown) const { return (shown - m_shift) / m_scale; }

    /// The point that is shown at the anchor stays there, unless the view would be left empty. False: nothing
    /// changed.
    bool zoomBy(double factor, const QPointF &anchor);
    bool panBy(const QPointF &by);
    bool fit();

private:
    void clamp();

    QRectF m_fitted, m_view;
    double m_mostScale = 1, m_scale = 1;
    QPointF m_shift;
};

} // namespace odo
