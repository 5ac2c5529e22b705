// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/silhouette.h"
#include "core/tracking/background.h"
#include "core/tracking/chroma.h"
#include "core/tracking/observation.h"
#include "core/tracking/searched_area.h"

#include <memory>
#include <vector>

namespace odo {

/// A connected region of the foreground. Luma pixels of the whole frame.
struct SeenSilhouette
{
    PixelRect box;
    std::vector<Eigen::Vector2d> hullPx;
    int regions = 1; ///< more where it was joined from others (core/tracking/internal/silhouette_finder.h)
    RegionMoments moments;        ///< of its convex hull, which is the image of the body's convex hull
    std::vector<float> supportPx; ///< of the hull about the moments' centre
    Eigen::Matrix2d centreCovariancePx2 = Eigen::Matrix2d::Zero();
    Chroma meanChroma = Chroma::Zero();
    int shadowPiece = 0;   ///< one connected piece of the foreground, with its shadows, has one number
    double clearShare = 1; ///< of its pixels: that cannot be a shadow on the floor
    ShadowAmbiguity shadowAmbiguity;
    bool isTrimmed = false; ///< something was left out that reaches out of it or is near it: a cable, a mast
    bool touchesBorder = false; ///< cut by the frame's edge, or by that of the searched area
};

/// Finds the foreground of one view, whatever its colours: where luma or chroma differ from the background by
/// more than it usually varies. Shadows are left out: there the luma is lower by a factor that hardly changes
/// from pixel to pixel, the chroma is that of the darkened floor, and what the floor has of texture shows
/// through. Outside of the searched area nothing is foreground. The light may change as a whole. Keeps its
/// memory. Not thread-safe.
class SilhouetteFinder
{
public:
    explicit SilhouetteFinder(Background background, const SearchedArea &area = {});
    ~SilhouetteFinder();
    SilhouetteFinder(SilhouetteFinder &&) noexcept;
    SilhouetteFinder &operator=(SilhouetteFinder &&) noexcept;

    /// Those of a whole frame, the largest first; none of fewer than leastAreaPx pixels. Nothing in a frame
    /// of another size than the background, and where so much of the frame differs that the light or the
    /// camera must have changed.
    const std::vector<SeenSilhouette> &find(const Frame &frame);

    static constexpr double leastAreaPx = 60;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace odo
