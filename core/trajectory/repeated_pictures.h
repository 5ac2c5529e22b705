// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/observation.h"

#include <vector>

namespace odo {

/// Which observations are of a picture that repeats the one before it though it was coded anew, so that its
/// bytes differ: the robot stands still to a few hundredths of a pixel for one to four frames, and then is
/// where its motion before and after puts it, having caught up what it missed. No robot stops and leaps like
/// that; one that really rests does not catch up. Only a robot that moves by most of a pixel a frame can
/// tell. As long as the observations; pure.
std::vector<bool> repeatedPictures(const std::vector<Observation> &observations);

} // namespace odo
