// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/robot_outline.h"

namespace odo {

namespace {

constexpr double leastSolidity = 0.96, solidityGain = 0.1; ///< of a robot that is taken as convex

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
        perLuma.asDiagonal() * (m_outline.centreCovariance + verdict.doubt) * perLuma.asDiagonal();
    return verdict.trust;
}

} // namespace odo
