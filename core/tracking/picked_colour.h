// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/video/frame.h"

namespace odo {

/// A robot's colour as one picture shows it.
struct PickedColour
{
    RgbColour colour; ///< the mean of all that has it, shaded sides and all
    double share = 0; ///< of the box that it covers, 0 to 1
};

/// The colour of what a person has drawn a box round, told apart from what lies around the box: of the chroma
/// that is commoner inside than in a frame about half as wide as the box, the hue that covers most. Good
/// enough to be told to ColourTracker, which learns the robot's own look from there. The box is in luma
/// pixels of a whole frame. Pure; any thread, some milliseconds. Errors: InvalidInput where the box is too
/// small or leaves nothing around it; Undetermined where it holds no colour that differs from the floor
/// around it, or where what differs is grey.
Result<PickedColour> pickColour(const Frame &frame, const PixelRect &box);

} // namespace odo
