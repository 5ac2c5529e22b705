// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/blob_finder.h"
#include "core/tracking/internal/outline_fit.h"
#include "core/tracking/internal/tracked_frame.h"

#include <array>
#include <optional>

namespace odo {

/// What an outline is worth beside the one seen before it.
struct OutlineVerdict
{
    enum class As {
        Seen,      ///< it changed as a robot's does that moves, turns and comes nearer
        Repaired,  ///< a part of it did not: the shape seen before, aligned with the rest
        Unreliable ///< too much of it did not
    } as = As::Seen;
    RegionMoments moments;
    Eigen::Matrix2d uncertainty = Eigen::Matrix2d::Zero(); ///< what to add to the centre's covariance, px²
    double trust = 1;                                      ///< factor of the score
};

/// Remembers a robot's outline, as its distance from its centre in each direction, and distinguishes a
/// reflection that has merged with it, or a thing that hides a part of it, from the robot's own motion.
///
/// The new outline is aligned with the remembered one by a shift, a turn and a scale, robustly (Tukey's
/// biweight, iterated): where more than a small part of it keeps away from that, and draws the centre with
/// it, it is no longer the robot's alone. Then the remembered shape, moved as the rest has moved, replaces
/// it, with less trust; or, when less than a good half agrees, the outline is called unreliable. A change
/// that stays is believed in the end: growth after half a second, for a robot may have been partly hidden;
/// loss only after two, for what hides it may stay. Growth back to a size that the robot had lately is
/// believed at once: it comes out from behind something.
class OutlineMemory
{
public:
    void forget() { m_known = false; }
    /// wholeAreaPx: that the robot had before it shrank; what it has where it did not.
    OutlineVerdict judge(const Outline &outline, double timeS, double wholeAreaPx);

private:
    static constexpr int directions = 64;
    struct Overlay
    {
        Eigen::Vector2d shift = Eigen::Vector2d::Zero();
        double scale = 0, turn = 0;             ///< relative; in steps of the directions
        double agreeing = 0;                    ///< share of the outline's points
        double strayingOut = 0, strayingIn = 0; ///< shares of those that do not
        double residual = 0;                    ///< rms of those that agree, px
    };
    using Radii = std::array<float, directions>;
    static double directionOf(const Eigen::Vector2d &offset);
    static Radii radiiOf(const Outline &outline);
    double radiusAt(double direction) const;
    double tolerance(double timeS) const;
    bool agrees(const Radii &radii, double tolerancePx) const;
    void keep(const Outline &outline, const Radii &radii, double timeS);
    Overlay lay(const Outline &outline, double timeS) const;
    OutlineVerdict replaceBy(const Overlay &overlay, double timeS);

    bool m_known = false;
    Radii m_radii{};
    RegionMoments m_moments;
    double m_meanRadius = 0;
    double m_keptS = 0, m_disturbedSinceS = 0, m_lastS = 0;
    bool m_disturbed = false;
};

/// What is known of a robot before it is measured.
struct ExpectedOutline
{
    Eigen::Vector2d motionPx; ///< since the last frame
    double wholeAreaPx = 0;   ///< of all of it, where only a part was seen of late
};

/// The outline of one robot from frame to frame: fitted where it can be, and set beside the one before.
class RobotOutline
{
public:
    void reset();
    /// Gives the shape the area, the position and the moments of the outline, and returns how far to trust it
    /// (0 to 1). The shape stays as it is, and nothing is returned, if no outline can be fitted, or if the
    /// robot is usually not convex: then its hull is not its outline.
    std::optional<double> refine(const TrackedFrame &frame, const RegionMask &mask,
                                 const ExpectedOutline &expected, RegionShape &shape);

private:
    bool fit(const TrackedFrame &frame, const RegionMask &mask, const OutlineHint &hint);

    OutlineFit m_fit;
    OutlineMemory m_memory;
    Outline m_outline;
    double m_solidity = -1; ///< running mean; below 0 before the first
};

} // namespace odo
