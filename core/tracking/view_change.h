// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <optional>

namespace odo {

/// How one image of a camera shows the scene against an earlier one: whether the camera was moved, zoomed,
/// turned or mirrored between the two, however long ago the earlier one was taken.
struct ViewChange
{
    enum class Kind {
        Same,    ///< to 0.6 px of the image reduced to 1280 px
        Shifted, ///< the camera was moved a little, as by a push
        // From here on it is another view than before, and nothing is known of where its pixels look.
        Panned, ///< shifted by more than a push does
        Zoomed,
        Turned, ///< about its optical axis
        Mirrored
    } kind = Kind::Same;
    double shiftPx = 0; ///< of what is seen in both, median
    double zoom = 1;    ///< of the later image against the earlier one, at its centre
    double turnRad = 0; ///< likewise, clockwise as seen in the image, -π to π

    bool isOtherView() const { return kind > Kind::Shifted; }
};

/// Compares two images of one size by what stands still in both. Distinct points (SIFT: Lowe 2004) of both
/// are matched where each is the other's nearest and clearly nearer than the next; the homography that most
/// of them follow (MAGSAC++: Barath et al. 2020) counts where it explains clearly more of them than that
/// nothing changed, and where they are all over the image: what fills a part of it may have moved by itself.
/// Other light, and things that moved, came or went, take few of them along. nullopt: too little is seen in
/// both to tell, or their sizes differ. Half a second and 200 MB. Pure; any thread.
std::optional<ViewChange> changeOfView(const PlaneView &before, const PlaneView &now);

} // namespace odo
