// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/chart_axis.h"

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

namespace {

double niceStep(double range, int most)
{
    const double rough = range / std::max(1, most);
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (rough <= factor * power * (1 + 1e-9))
            return factor * power;
    }
    return 10 * power;
}

AxisTicks ticksBetween(double firstIndex, double lastIndex, double step)
{
    AxisTicks ticks;
    ticks.step = step;
    ticks.first = firstIndex * step;
    ticks.count = std::max(0, static_cast<int>(lastIndex - firstIndex) + 1);
    ticks.decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    return ticks;
}

/// A range that a step can be computed of.
bool isUsable(double low, double high)
{
    return std::isfinite(low) && std::isfinite(high) && high > low;
}

} // namespace

std::vector<double> AxisTicks::values() const
{
    std::vector<double> all;
    for (int i = 0; i < count; ++i)
        all.push_back(first + i * step);
    return all;
}

QString AxisTicks::label(double value, const QLocale &locale) const
{
    QLocale plain = locale;
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    return plain.toString(std::abs(value) < step * 1e-6 ? 0.0 : value, 'f', decimals);
}

AxisTicks niceTicks(double low, double high, int most)
{
    if (!isUsable(low, high))
        return {};
    const double step = niceStep(high - low, most), slack = 1e-9;
    return ticksBetween(std::ceil(low / step - slack), std::floor(high / step + slack), step);
}

AxisTicks coveringTicks(double low, double high, int most)
{
    if (!isUsable(low, high)) {
        const double centre = std::isfinite(low) ? low : 0;
        low = centre - 0.5;
        high = centre + 0.5;
    }
    const double step = niceStep(high - low, most), slack = 1e-9;
    return ticksBetween(std::floor(low / step + slack), std::ceil(high / step - slack), step);
}

} // namespace odo
