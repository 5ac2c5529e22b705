// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/axis_span.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {
constexpr double narrowest = 1e-4; // of the whole
}

void AxisSpan::setWhole(double low, double high)
{
    m_wholeLow = m_low = low;
    m_wholeHigh = m_high = high > low ? high : low + 1;
}

void AxisSpan::show(double low, double high)
{
    const double whole = m_wholeHigh - m_wholeLow;
    if (!std::isfinite(low) || !std::isfinite(high) || high < low)
        return;
    const double width = std::clamp(high - low, narrowest * whole, whole);
    low = std::clamp((low + high - width) / 2, m_wholeLow, m_wholeHigh - width);
    if (low == m_low && low + width == m_high)
        return;
    m_low = low;
    m_high = low + width;
    Q_EMIT spanChanged();
}

void AxisSpan::zoom(double factor, double about)
{
    show(about - (about - m_low) / factor, about + (m_high - about) / factor);
}

void AxisSpan::pan(double share)
{
    const double width = m_high - m_low;
    const double low = std::clamp(m_low + share * width, m_wholeLow, m_wholeHigh - width);
    show(low, low + width);
}

} // namespace odo
