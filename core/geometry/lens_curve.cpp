// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/lens_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace odo {

namespace {

constexpr double farthestRadius = 100; // 89.4° from the axis: no picture through a flat lens model reaches it

} // namespace

double LensCurve::value(double argument) const
{
    const double u = argument * argument;
    if (m_fisheye)
        return argument * (1 + u * (m_k[0] + u * (m_k[1] + u * (m_k[2] + u * m_k[3]))));
    const double above = 1 + u * (m_k[0] + u * (m_k[1] + u * m_k[4]));
    const double below = 1 + u * (m_k[5] + u * (m_k[6] + u * m_k[7]));
    return argument * above / below;
}

double LensCurve::slope(double argument) const
{
    const double u = argument * argument;
    if (m_fisheye)
        return 1 + u * (3 * m_k[0] + u * (5 * m_k[1] + u * (7 * m_k[2] + u * 9 * m_k[3])));
    const double above = 1 + u * (m_k[0] + u * (m_k[1] + u * m_k[4]));
    const double below = 1 + u * (m_k[5] + u * (m_k[6] + u * m_k[7]));
    const double aboveByU = m_k[0] + u * (2 * m_k[1] + u * 3 * m_k[4]);
    const double belowByU = m_k[5] + u * (2 * m_k[6] + u * 3 * m_k[7]);
    if (below <= 0)
        return -1; // past a pole of the rational model: certainly not usable
    return (above + 2 * u * aboveByU) / below - 2 * u * above * belowByU / (below * below);
}

double LensCurve::limit() const
{
    const double end = m_fisheye ? std::numbers::pi : farthestRadius;
    if (std::all_of(m_k.begin(), m_k.end(), [](double k) { return k == 0; }))
        return m_fisheye ? end : std::numeric_limits<double>::infinity();
    double good = 0;
    for (double next = 1e-3; good < end; next = std::min(end, next * 1.002)) {
        if (slope(next) > 0) {
            good = next;
            continue;
        }
        double bad = next;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (good + bad);
            (slope(middle) > 0 ? good : bad) = middle;
        }
        return good;
    }
    return end;
}

std::optional<double> LensCurve::inverse(double wanted, double limit) const
{
    if (wanted == 0)
        return 0.0;
    double low = 0;
    double high = std::isinf(limit) ? wanted : limit; // without a limit the curve is the identity
    if (!(value(high) >= wanted))
        return std::nullopt;
    double argument = std::min(wanted, high);
    for (int i = 0; i < 100; ++i) {
        const double error = value(argument) - wanted;
        (error > 0 ? high : low) = argument;
        if (std::abs(error) < 1e-15 * std::max(1.0, wanted))
            break;
        double next = argument - error / slope(argument);
        if (!(next > low && next < high)) // Newton left the bracket
            next = 0.5 * (low + high);
        if (next == argument)
            break;
        argument = next;
    }
    return argument;
}

} // namespace odo
