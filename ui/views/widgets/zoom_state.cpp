// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/zoom_state.h"

#include <algorithm>
#include <utility>

namespace odo {

namespace {

/// The shift of one axis: content longer than the view covers all of it, shorter content stays in its middle.
double clampedShift(double shift, double scale, double begin, double end, double viewBegin, double viewEnd)
{
    if (scale * (end - begin) <= viewEnd - viewBegin)
        return (1 - scale) * (begin + end) / 2;
    return std::clamp(shift, viewEnd - scale * end, viewBegin - scale * begin);
}

} // namespace

void ZoomState::setFrame(const QRectF &fitted, const QRectF &view, double mostScale)
{
    const QPointF middle = toFitted(m_view.center());
    const bool isFirst = m_fitted.isEmpty() || isFitted();
    const QPointF part = isFirst ? QPointF()
                                 : QPointF((middle.x() - m_fitted.left()) / m_fitted.width(),
                                           (middle.y() - m_fitted.top()) / m_fitted.height());
    m_fitted = fitted;
    m_view = view;
    m_mostScale = std::max(1.0, mostScale);
    m_scale = std::clamp(m_scale, 1.0, m_mostScale);
    if (!isFirst)
        m_shift = view.center() - m_scale * QPointF(fitted.left() + part.x() * fitted.width(),
                                                    fitted.top() + part.y() * fitted.height());
    clamp();
}

QRectF ZoomState::toShown(const QRectF &fitted) const
{
    return {toShown(fitted.topLeft()), m_scale * fitted.size()};
}

bool ZoomState::zoomBy(double factor, const QPointF &anchor)
{
    const double scale = std::clamp(m_scale * factor, 1.0, m_mostScale);
    if (scale == m_scale)
        return false;
    m_shift = anchor - scale * toFitted(anchor);
    m_scale = scale;
    clamp();
    return true;
}

bool ZoomState::panBy(const QPointF &by)
{
    const QPointF before = m_shift;
    m_shift += by;
    clamp();
    return m_shift != before;
}

bool ZoomState::fit()
{
    if (isFitted())
        return false;
    m_scale = 1;
    clamp();
    return true;
}

void ZoomState::clamp()
{
    if (isFitted())
        m_shift = {}; // exactly: an image that fits lies on whole pixels
    else
        m_shift = {clampedShift(m_shift.x(), m_scale, m_fitted.left(), m_fitted.right(), m_view.left(),
                                m_view.right()),
                   clampedShift(m_shift.y(), m_scale, m_fitted.top(), m_fitted.bottom(), m_view.top(),
                                m_view.bottom())};
}

} // namespace odo
