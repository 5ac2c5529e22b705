// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace odo {

/// That a camera was moved during a recording: bumped, panned, zoomed.
struct CameraMove
{
    Nanoseconds time{0}; ///< of the recording: of the last frame at which it had not moved yet
    double shiftPx = 0;  ///< of what it sees, median over the image and the time since
};

/// Watches whether a camera moves, by what stands still before it: up to forty textured patches, spread over
/// the image, are found again in some frames a second (Lucas and Kanade 1981, with gain and offset of the
/// light; after a jump by a search first). What moves before the camera, and shadows, take few of them along;
/// the camera takes nearly all. It counts as moved where at least two thirds of the patches that are found
/// again are shifted by more than a pixel, for a second or up to the end. Costs about one per cent of
/// tracking. One a view; one thread at a time.
class CameraWatch
{
public:
    /// Frames in order; most are passed over. Of those that were decoded in part one a second is decoded
    /// whole. The first whole one says where everything was.
    void add(const Frame &frame);
    /// nullopt: it has not moved, or it has too little texture to tell.
    std::optional<CameraMove> move() const;

private:
    struct Patch
    {
        int x = 0, y = 0; ///< its left upper corner
        std::vector<float> values, slopesX, slopesY;
        Eigen::Matrix2d inverse = Eigen::Matrix2d::Zero(); ///< of the slopes' second moments
        double mean = 0, deviation = 0;
        Eigen::Vector2d shiftPx = Eigen::Vector2d::Zero(); ///< when it was last found
    };
    /// One look at all patches.
    struct Look
    {
        Nanoseconds time{0};
        double shiftPx = 0; ///< median of those found again
        bool isMoved = false;
    };

    void choosePatches(const PlaneView &luma);
    std::optional<Eigen::Vector2d> findNear(const Patch &patch, const PlaneView &luma,
                                            Eigen::Vector2d shift) const;
    std::optional<Eigen::Vector2d> searchCommonShift(const PlaneView &luma) const;
    void look(const PlaneView &luma, Nanoseconds time);

    std::vector<Patch> m_patches;
    bool m_isChosen = false, m_isTried = false;
    std::optional<Nanoseconds> m_lastLook;
    int m_width = 0, m_height = 0;
    std::vector<Look> m_looks; ///< those at which enough patches were found, from the last still one on
};

} // namespace odo
