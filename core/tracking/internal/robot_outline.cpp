// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/robot_outline.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double staleAfterS = 0.4;
constexpr double growthBelievedAfterS = 0.5, lossBelievedAfterS = 2.0;
constexpr double leastTolerancePx = 1.0, tolerancePerRadius = 0.05; ///< the latter in a 30th of a second
constexpr double mostStraying = 0.08;       ///< of the outline without being called disturbed
constexpr double mostStrayingAtOnce = 0.04; ///< of it, centre upon centre
constexpr double leastAgreeing = 0.5;       ///< of the outline, to repair it
constexpr double mostDrawnPx = 0.35, mostDrawnPerRadius = 0.01;
constexpr double wholeAreaSpan = 0.1; ///< of the area of a robot that comes out from behind something
constexpr int passes = 4;

} // namespace

/// 0 to `directions`, growing with the angle (but not evenly: the position on the unit square's rim costs no
/// arc tangent).
double OutlineMemory::directionOf(const Eigen::Vector2d &offset)
{
    const double sum = std::abs(offset.x()) + std::abs(offset.y());
    const double part = sum > 0 ? offset.y() / sum : 0;
    const double rim = offset.x() >= 0 ? (part < 0 ? 4 + part : part) : 2 - part;
    return rim * (directions / 4.0);
}

double OutlineMemory::radiusAt(double direction) const
{
    const double at = direction - directions * std::floor(direction / directions);
    const int i = std::min(static_cast<int>(at), directions - 1);
    const double part = at - i;
    return (1 - part) * static_cast<double>(m_radii[static_cast<std::size_t>(i)]) +
           part * static_cast<double>(m_radii[static_cast<std::size_t>((i + 1) % directions)]);
}

/// The outline's distance from its centre in each direction.
OutlineMemory::Radii OutlineMemory::radiiOf(const Outline &outline)
{
    Radii radii;
    std::array<bool, directions> set{};
    const Eigen::Vector2d &centre = outline.moments.centrePx;
    Eigen::Vector2d p = outline.points.back() - centre;
    double from = directionOf(p);
    for (const Eigen::Vector2d &point : outline.points) {
        const Eigen::Vector2d q = point - centre;
        const double to = directionOf(q);
        double way = to - from;
        if (std::abs(way) > directions / 2.0)
            way -= std::copysign(static_cast<double>(directions), way);
        // The rays between two points meet the straight line that joins them.
        int k = static_cast<int>(from);
        k += k < from;
        for (; way > 0 && k <= from + way; ++k) {
            const auto i = static_cast<std::size_t>(k) % directions;
            const double part = (k - from) / way;
            radii[i] = static_cast<float>(((1 - part) * p + part * q).norm());
            set[i] = true;
        }
        p = q;
        from = to;
    }
    for (std::size_t i = 0; i < directions; ++i) {
        if (!set[i])
            radii[i] = i > 0 ? radii[i - 1] : static_cast<float>(p.norm());
    }
    return radii;
}

void OutlineMemory::keep(const Outline &outline, const Radii &radii, double timeS)
{
    m_moments = outline.moments;
    m_meanRadius = std::sqrt(m_moments.areaPx2 / std::numbers::pi);
    m_radii = radii;
    m_known = true;
    m_disturbed = false;
    m_keptS = timeS;
}

double OutlineMemory::tolerance(double timeS) const
{
    const double frames = std::clamp((timeS - m_keptS) * 30, 1.0, 4.0);
    return std::max(leastTolerancePx, tolerancePerRadius * m_meanRadius * frames);
}

/// Whether the outline need not be aligned with the remembered one at all: centre upon centre it agrees
/// already, as nearly every one does.
bool OutlineMemory::agrees(const Radii &radii, double tolerancePx) const
{
    const auto most = static_cast<float>(tolerancePx);
    int straying = 0;
    for (std::size_t i = 0; i < directions; ++i)
        straying += std::abs(radii[i] - m_radii[i]) > most;
    return straying <= mostStrayingAtOnce * directions;
}

OutlineMemory::Overlay OutlineMemory::lay(const Outline &outline, double timeS) const
{
    Overlay overlay;
    overlay.shift = outline.moments.centrePx - m_moments.centrePx;
    const double mostStray = tolerance(timeS);
    for (int pass = 0; pass < passes; ++pass) {
        // Wide at first: the centre of a disturbed outline is a bad start.
        const double width = mostStray * (pass == 0 ? 6 : pass == 1 ? 3.5 : 2);
        Eigen::Matrix4d normal = Eigen::Vector4d(1e-6, 1e-6, 1e-3 * m_meanRadius, 1e-3).asDiagonal();
        Eigen::Vector4d right = Eigen::Vector4d::Zero();
        double squares = 0;
        int agreeing = 0, out = 0, in = 0, all = 0;
        for (std::size_t i = 0; i < outline.points.size(); ++i) {
            const Eigen::Vector2d offset = outline.points[i] - m_moments.centrePx - overlay.shift;
            const double direction = directionOf(offset) - overlay.turn;
            const double remembered = radiusAt(direction) * (1 + overlay.scale), seen = offset.norm();
            const double slope =
                (radiusAt(direction + 0.5) - radiusAt(direction - 0.5)) * (1 + overlay.scale);
            const Eigen::Vector2d ray = offset / std::max(seen, 1e-9);
            // Along the outline's normal, which differs from the ray's by the slope of the radius.
            const double perStep = seen * 2 * std::numbers::pi / directions;
            const double cosine = perStep / std::sqrt(perStep * perStep + slope * slope);
            const double stray = (seen - remembered) * cosine;
            ++all;
            out += stray > mostStray;
            in += stray < -mostStray;
            if (!outline.found[i] || std::abs(stray) > width)
                continue;
            if (std::abs(stray) <= mostStray) {
                ++agreeing;
                squares += stray * stray;
            }
            const double bi = 1 - stray * stray / (width * width);
            // Aligned by normal = ray plus its turn: the derivatives of the stray.
            const Eigen::Vector2d across(-ray.y(), ray.x());
            const Eigen::Vector2d outward = cosine * (ray - slope / perStep * across);
            const Eigen::Vector4d row(outward.x(), outward.y(), remembered * cosine, -slope * cosine);
            normal += bi * bi * row * row.transpose();
            right += bi * bi * stray * row;
        }
        overlay.agreeing = static_cast<double>(agreeing) / all;
        overlay.strayingOut = static_cast<double>(out) / all;
        overlay.strayingIn = static_cast<double>(in) / all;
        overlay.residual = std::sqrt(squares / std::max(agreeing, 1));
        if (pass + 1 == passes)
            break;
        const Eigen::Vector4d step = normal.inverse() * right;
        overlay.shift += step.head<2>();
        overlay.scale = std::clamp(overlay.scale + step[2], -0.15, 0.15);
        overlay.turn = std::clamp(overlay.turn + step[3], -2.0, 2.0);
    }
    return overlay;
}

OutlineVerdict OutlineMemory::replaceBy(const Overlay &overlay, double timeS)
{
    OutlineVerdict verdict;
    const double grown = 1 + overlay.scale;
    verdict.as = OutlineVerdict::As::Repaired;
    verdict.moments.centrePx = m_moments.centrePx + overlay.shift;
    verdict.moments.areaPx2 = m_moments.areaPx2 * grown * grown;
    verdict.moments.covariancePx2 = m_moments.covariancePx2 * grown * grown;
    // What agrees fixes the centre the worse the less of the rim it takes up.
    const double sigma = 0.3 + overlay.residual * (1 - overlay.agreeing) * 2 + 0.01 * m_meanRadius;
    verdict.uncertainty = Eigen::Matrix2d::Identity() * sigma * sigma;
    verdict.trust = 0.5 * overlay.agreeing;
    m_moments = verdict.moments;
    for (float &radius : m_radii)
        radius *= static_cast<float>(grown);
    m_meanRadius *= grown;
    m_keptS = timeS;
    return verdict;
}

OutlineVerdict OutlineMemory::judge(const Outline &outline, double timeS, double wholeAreaPx)
{
    OutlineVerdict verdict;
    verdict.moments = outline.moments;
    m_lastS = timeS;
    const Radii radii = radiiOf(outline);
    if (!m_known || timeS - m_keptS > staleAfterS || agrees(radii, tolerance(timeS))) {
        keep(outline, radii, timeS);
        return verdict;
    }
    const Overlay overlay = lay(outline, timeS);
    const double straying = overlay.strayingOut + overlay.strayingIn;
    const double drawn = (outline.moments.centrePx - m_moments.centrePx - overlay.shift).norm();
    const bool comesOut = overlay.strayingOut > overlay.strayingIn &&
                          outline.moments.areaPx2 < (1 + wholeAreaSpan) * wholeAreaPx &&
                          m_moments.areaPx2 < (1 - wholeAreaSpan) * wholeAreaPx;
    if (comesOut || straying <= mostStraying || drawn < mostDrawnPx + mostDrawnPerRadius * m_meanRadius) {
        keep(outline, radii, timeS);
        return verdict;
    }
    if (!m_disturbed) {
        m_disturbed = true;
        m_disturbedSinceS = timeS;
    }
    const double patience =
        overlay.strayingOut > overlay.strayingIn ? growthBelievedAfterS : lossBelievedAfterS;
    if (timeS - m_disturbedSinceS > patience) {
        keep(outline, radii, timeS);
        return verdict;
    }
    if (overlay.agreeing >= leastAgreeing)
        return replaceBy(overlay, timeS);
    verdict.as = OutlineVerdict::As::Unreliable;
    verdict.uncertainty = Eigen::Matrix2d::Identity() * (drawn * drawn + 0.04 * m_meanRadius * m_meanRadius);
    verdict.trust = 0.15;
    // The remembered outline waits where the robot may be by now.
    m_moments.centrePx = outline.moments.centrePx;
    m_keptS = timeS;
    return verdict;
}

namespace {

constexpr double leastSolidity = 0.96, solidityGain = 0.1; ///< of a robot that counts as convex

} // namespace

void RobotOutline::reset()
{
    m_memory.forget();
    m_solidity = -1;
}

/// A region of a convex robot that is not convex for once has something else in it, or before it.
bool RobotOutline::fit(const TrackedFrame &frame, const RegionMask &mask, const OutlineHint &hint)
{
    const bool fitted = m_fit.fit(frame.frame(), frame.grid(), mask, hint, m_outline);
    m_solidity =
        m_solidity < 0 ? m_outline.solidity : m_solidity + solidityGain * (m_outline.solidity - m_solidity);
    return fitted && m_solidity > leastSolidity;
}

std::optional<double> RobotOutline::refine(const TrackedFrame &frame, const RegionMask &mask,
                                           const ExpectedOutline &expected, RegionShape &shape)
{
    if (!fit(frame, mask, {shape.colour, expected.motionPx}))
        return std::nullopt;
    const OutlineVerdict verdict = m_memory.judge(m_outline, frame.timeS(), expected.wholeAreaPx);
    const Eigen::Vector2d perLuma = frame.grid().scale.cwiseInverse();
    shape.area = verdict.moments.areaPx2 / frame.lumaPerSample();
    shape.centre = frame.grid().fromLuma(verdict.moments.centrePx);
    shape.covariance = perLuma.asDiagonal() * verdict.moments.covariancePx2 * perLuma.asDiagonal();
    shape.centreCovariance =
        perLuma.asDiagonal() * (m_outline.centreCovariance + verdict.uncertainty) * perLuma.asDiagonal();
    return verdict.trust;
}

} // namespace odo
