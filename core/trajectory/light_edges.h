// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/light_meter.h"

#include <vector>

namespace odo {

/// A moment at which the light of the room went up or down at once.
struct LightEdge
{
    double timeS = 0; ///< by the view's own clock
    double sigmaS = 0;
    bool brighter = false;
    double change = 0; ///< of the level's logarithm
};

/// Finds where the light of a view jumps: within three frames (or 0.12 s, which lamps take to glow up), by 6 % of the
/// level or more and far beyond what the level does anyway, over a third of the picture or more, all one way. A slow
/// change, as of the sun or of an automatic exposure, is none; a flash is two, one up and one down.
///
/// The moment is finer than a frame where a picture shows it half done: a share f of the exposure (of the rows, with a
/// rolling shutter) lies behind it, so it was (f − ½)·D before that picture's own time. D, exposure and read-out
/// together, is not known: any up to one frame interval P is as likely, and one that shows a picture half done the
/// likelier the longer it is, which makes its mean ⅔ P and its σ 0.24 P. Without such a picture the moment lies
/// anywhere between two: σ = P/√12. f is read both as coded and as light (a gamma of 2.2); half the difference is
/// part of σ. Where the light is back at once, the peak's height tells nothing of the moment, and σ is P/√6 for each
/// edge, P/√12 for their middle. Pure; any thread.
std::vector<LightEdge> findLightEdges(const std::vector<LightLevel> &levels);

} // namespace odo
