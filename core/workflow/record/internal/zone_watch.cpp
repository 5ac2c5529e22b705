// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/internal/zone_watch.h"

#include <algorithm>
#include <limits>

namespace odo {

namespace {

constexpr double leastEdgeM = 0.005, edgeDeviations = 3;

/// To a polygon's edge, positive within (even-odd rule). Metres.
double distanceWithin(const Zone &zone, const Eigen::Vector2d &point)
{
    double nearest = std::numeric_limits<double>::max();
    bool isInside = false;
    for (std::size_t i = 0; i < zone.corners.size(); ++i) {
        const Eigen::Vector2d &a = zone.corners[i], &b = zone.corners[(i + 1) % zone.corners.size()];
        const Eigen::Vector2d side = b - a;
        const double along = std::clamp((point - a).dot(side) / side.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (point - a - along * side).norm());
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < a.x() + (point.y() - a.y()) / side.y() * side.x())
            isInside = !isInside;
    }
    return isInside ? nearest : -nearest;
}

} // namespace

void ZoneWatch::forget()
{
    m_last.reset();
    m_isInside.reset();
}

std::optional<ZoneCrossing> ZoneWatch::add(const LivePosition &position)
{
    const ProfilePoint &point = position.point;
    if (!point.valid || !point.position.allFinite())
        return std::nullopt;
    const Distance now{position.sample.time, distanceWithin(m_zone, point.position)};
    if (m_last && (m_last->m > 0) != (now.m > 0)) {
        const double share = m_last->m / (m_last->m - now.m);
        m_onEdge = m_last->time + fromSeconds(share * toSeconds(now.time - m_last->time));
    }
    m_last = now;
    if (std::abs(now.m) < std::max(leastEdgeM, edgeDeviations * std::max(point.sigmaXM, point.sigmaYM)))
        return std::nullopt;
    const bool isInside = now.m > 0;
    const bool crossed = m_isInside && *m_isInside != isInside;
    m_isInside = isInside;
    if (!crossed)
        return std::nullopt;
    return ZoneCrossing{isInside, m_onEdge};
}

} // namespace odo
