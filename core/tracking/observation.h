// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace odo {

/// An ellipse in luma pixels: of second moments equal to the region's (semi-axes are two standard
/// deviations).
struct Ellipse
{
    Eigen::Vector2d centrePx = Eigen::Vector2d::Zero();
    double semiMajorPx = 0, semiMinorPx = 0;
    double angleRad = 0; ///< of the major axis from the image's x axis towards y (down)
};

/// What would be different if shadows were other than was assumed (Background::Shadow): shares of an
/// outline's pixels that would be floor in shadow if shadows were darker, and if they were tinted; how many
/// pixels beside it, for each of its own, would be robot if shadows were lighter; how many of both are nearly
/// as dark as the darkest shadow; and the share of the outline that would be new if a shadow connected parts
/// of a robot.
struct ShadowAmbiguity
{
    float deep = 0, tinted = 0, light = 0, near = 0, apart = 0;
    /// Adds that of a part, of which the whole has this share.
    void addPart(const ShadowAmbiguity &part, float share);
};

/// What one view saw of one robot in one frame. Never edited once stored.
struct Observation
{
    std::int64_t frame = 0;      ///< index in the recording
    Nanoseconds time{0};         ///< of the recording, since its first frame
    bool found = false;          ///< when false the rest is meaningless
    bool duplicateFrame = false; ///< the frame repeats the one before it
    bool isDamaged = false;      ///< the frame could not be decoded; such are not stored
    Ellipse ellipse;
    Eigen::Matrix2d centreCovariancePx2 = Eigen::Matrix2d::Zero();
    /// What no mean over frames makes smaller: how far the centre would be elsewhere if shadows were other
    /// than was assumed, where that is nearly as likely. Zero where nothing was ambiguous.
    Eigen::Matrix2d lastingCovariancePx2 = Eigen::Matrix2d::Zero();
    double areaPx = 0;
    double score = 0;           ///< 0 to 1: how well colour, size and shape agree with what is expected
    bool touchesBorder = false; ///< cut by the frame's edge: the centre is biased
    /// Mean (Cb − 128, Cr − 128) of the region; zero where it was not measured. Distinguishes robots of
    /// similar colours right after the tracking; it is not stored.
    Eigen::Vector2d meanChroma = Eigen::Vector2d::Zero();
    /// Something thin that reaches out of it was left out: a cable, a mast. Not stored either.
    bool isTrimmed = false;
    ShadowAmbiguity shadowAmbiguity = {}; ///< not stored
    /// How far the outline's convex hull reaches from the centre in each direction of the image
    /// (core/geometry/silhouette.h), px; empty where only its ellipse was measured.
    std::vector<float> supportPx = {};
    bool isByHand = false; ///< where a person says that it is; only its centre is known then
};

/// The ellipse about a centre that has these second moments.
Ellipse ellipseOf(const Eigen::Vector2d &centrePx, const Eigen::Matrix2d &covariance);

} // namespace odo
