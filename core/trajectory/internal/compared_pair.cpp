// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/compared_pair.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr std::size_t leastCommonTimes = 20,
                      mostComparedTimes = 72; // that both views saw; more are thinned out
constexpr int speedReach = 2;                 // sightings to either side that a speed is taken over
// of what lasts in all outlines of a view; more than that the fit of a solid leaves open because of a
// contradiction
constexpr double leastLastingPx = 0.1, mostLastingPx = 0.25;

} // namespace

bool isClear(const Sighting &sighting)
{
    return sighting.seen && !sighting.cut;
}

ComparedPair::ComparedPair(const FloorView &viewA, const FloorView &viewB, std::span<const Sighting> a,
                           std::span<const Sighting> b, const PairPriors &priors)
    : m_viewA(viewA), m_viewB(viewB), m_a(a), m_b(b), m_priors(priors)
{
    collect();
    if (m_common.size() < leastCommonTimes)
        return;
    const std::size_t step = (m_common.size() + mostComparedTimes - 1) / mostComparedTimes;
    for (std::size_t i = step / 2; i < m_common.size(); i += step)
        m_compared.push_back(i);
}

void ComparedPair::collect()
{
    const std::size_t times = std::min(m_a.size(), m_b.size());
    double travelM = 0;
    for (std::size_t i = 0; i < times; ++i) {
        if (!isClear(m_a[i]) || !isClear(m_b[i]))
            continue;
        m_common.push_back({i, toSeconds(m_a[i].time)});
    }
    for (std::size_t i = 0; i < m_common.size(); ++i) {
        const std::size_t before = m_common[i - std::min<std::size_t>(i, speedReach)].index,
                          behind = m_common[std::min(m_common.size() - 1, i + speedReach)].index;
        const double spanS = toSeconds(m_a[behind].time - m_a[before].time);
        if (spanS > 0)
            m_common[i].velocityMps =
                (m_a[behind].position.pointInWorld - m_a[before].position.pointInWorld +
                 m_b[behind].position.pointInWorld - m_b[before].position.pointInWorld) /
                (2 * spanS);
        if (i > 0)
            travelM += m_common[i].velocityMps.norm() * (m_common[i].timeS - m_common[i - 1].timeS);
        m_common[i].travelM = travelM;
    }
    if (!m_common.empty())
        m_middleS = (m_common.front().timeS + m_common.back().timeS) / 2;
}

Eigen::Matrix2d ComparedPair::lastingOf(const FloorView &view, const FloorPosition &position) const
{
    const Eigen::Vector2d &point = position.pointInWorld;
    const auto pixel = view.pixelFromWorld({point.x(), point.y(), m_priors.planeM});
    const auto onePx =
        pixel ? view.locate(*pixel, Eigen::Matrix2d::Identity(), m_priors.planeM) : std::nullopt;
    if (!onePx)
        return Eigen::Matrix2d::Zero();
    const double stated = (position.calibrationCovariance - onePx->calibrationCovariance).trace() /
                          onePx->pixelCovariance.trace();
    return std::clamp(stated, leastLastingPx * leastLastingPx, mostLastingPx * mostLastingPx) *
           onePx->pixelCovariance;
}

Eigen::Matrix2d ComparedPair::statedOf(const FloorView &view, const FloorPosition &position) const
{
    return position.pixelCovariance + lastingOf(view, position) +
           view.sharedCovariance(position.pointInWorld, position.pointInWorld, m_priors.planeM)
               .value_or(Eigen::Matrix2d::Zero());
}

/// A view's position some time later, linear between the common times.
Eigen::Vector2d ComparedPair::at(std::span<const Sighting> view, std::size_t i, double laterS) const
{
    const double timeS = m_common[i].timeS + laterS;
    std::size_t right = i;
    while (right + 1 < m_common.size() && m_common[right].timeS < timeS)
        ++right;
    while (right > 1 && m_common[right - 1].timeS > timeS)
        --right;
    right = std::max<std::size_t>(right, 1);
    const Eigen::Vector2d &before = view[m_common[right - 1].index].position.pointInWorld,
                          &behind = view[m_common[right].index].position.pointInWorld;
    const double spanS = m_common[right].timeS - m_common[right - 1].timeS;
    return before + (behind - before) * ((timeS - m_common[right - 1].timeS) / spanS);
}

/// What a cause makes of positions; laterB: where the second view saw it so many seconds later.
PairPositions ComparedPair::apply(const CauseModel &by, const Eigen::VectorXd &parameters, double timeS,
                                  PairPositions positions,
                                  const std::function<Eigen::Vector2d(double)> &laterB,
                                  const Eigen::Vector2d &perHeightA, const Eigen::Vector2d &perHeightB) const
{
    Eigen::Index next = 0;
    const bool isAfter = !by.sinceS || timeS >= *by.sinceS;
    const auto rotation = [&]() -> Eigen::Vector3d {
        const Eigen::Vector3d its = parameters.segment<3>(next);
        next += rotationParameters;
        return isAfter ? its : Eigen::Vector3d::Zero();
    };
    if (by.rotatesA)
        positions.a = turnedOnPlane(m_viewA.cameraInWorld(), rotation(), positions.a, m_priors.planeM);
    if (by.rotatesB)
        positions.b = turnedOnPlane(m_viewB.cameraInWorld(), rotation(), positions.b, m_priors.planeM);
    if (by.shiftsTime) {
        double laterS = parameters[next++];
        if (by.changesRate)
            laterS += parameters[next++] * (timeS - m_middleS);
        positions.b = laterB(laterS);
    }
    if (by.raises) {
        positions.a += parameters[next] * perHeightA;
        positions.b += parameters[next] * perHeightB;
    }
    return positions;
}

PairPositions ComparedPair::corrected(std::size_t i, const CauseModel &by,
                                      const Eigen::VectorXd &parameters) const
{
    const FloorPosition &seenA = m_a[m_common[i].index].position, &seenB = m_b[m_common[i].index].position;
    return apply(
        by, parameters, m_common[i].timeS, {seenA.pointInWorld, seenB.pointInWorld},
        [&](double laterS) { return at(m_b, i, laterS); }, seenA.displacementPerMetreHeight,
        seenB.displacementPerMetreHeight);
}

Eigen::VectorXd ComparedPair::residuals(const CauseModel &by, const Eigen::VectorXd &parameters) const
{
    Eigen::VectorXd all(2 * Eigen::Index(m_compared.size()));
    for (std::size_t k = 0; k < m_compared.size(); ++k) {
        const PairPositions positions = corrected(m_compared[k], by, parameters);
        all.segment<2>(Eigen::Index(2 * k)) = positions.a - positions.b;
    }
    return all;
}

Eigen::MatrixXd ComparedPair::slopes(const CauseModel &by, const Eigen::VectorXd &parameters,
                                     const Eigen::VectorXd &there) const
{
    constexpr double part = 1e-3; // of a standard deviation
    Eigen::MatrixXd all(there.size(), by.size());
    for (Eigen::Index p = 0; p < by.size(); ++p) {
        Eigen::VectorXd moved = parameters;
        const double step = part * by.sigmas[static_cast<std::size_t>(p)];
        moved[p] += step;
        all.col(p) = (residuals(by, moved) - there) / step;
    }
    return all;
}

Eigen::Vector2d ComparedPair::offAlone(std::size_t index, bool isA, const CauseModel &by,
                                       const Eigen::VectorXd &parameters) const
{
    const std::span<const Sighting> seen = isA ? m_a : m_b;
    const Sighting &here = seen[index];
    PairPositions positions{here.position.pointInWorld, here.position.pointInWorld};
    const std::size_t before = index - std::min<std::size_t>(index, speedReach),
                      behind = std::min(seen.size() - 1, index + speedReach);
    const double spanS = toSeconds(seen[behind].time - seen[before].time);
    const bool isKnown = seen[before].seen && seen[behind].seen && spanS > 0;
    const Eigen::Vector2d velocityMps =
        isKnown ? Eigen::Vector2d((seen[behind].position.pointInWorld - seen[before].position.pointInWorld) /
                                  spanS)
                : Eigen::Vector2d(Eigen::Vector2d::Zero());
    const auto later = [&](double byS) { return here.position.pointInWorld + byS * velocityMps; };
    const PairPositions is =
        apply(by, parameters, toSeconds(here.time), positions, later,
              here.position.displacementPerMetreHeight, here.position.displacementPerMetreHeight);
    return (isA ? is.a : is.b) - here.position.pointInWorld;
}

} // namespace odo
