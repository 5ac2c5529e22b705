// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/clip_synchronisation.h"
#include "core/tracking/background.h"

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

/// Finds where the light of a view jumps: within three frames (or 0.12 s, which lamps take to glow up), by 6
/// % of the level or more and far beyond what the level does anyway, over a third of the frame or more, all
/// one way. A slow change, as of the sun or of an automatic exposure, is none; a flash is two, one up and one
/// down.
///
/// The moment is finer than a frame if a frame shows it half done: a share f of the exposure (of the rows,
/// with a rolling shutter) lies behind it, so it was (f − ½)·D before that frame's own time. D, exposure and
/// read-out together, is not known: any up to one frame interval P is as likely, and one that shows a frame
/// half done the likelier the longer it is, which makes its mean ⅔ P and its σ 0.24 P. Without such a frame
/// the moment is anywhere between two: σ = P/√12. f is read both as coded and as light (a gamma of 2.2); half
/// the difference is part of σ. Where the light is back at once, the peak's height does not determine the
/// moment, and σ is P/√6 for each edge, P/√12 for their middle. Pure; any thread.
std::vector<LightEdge> findLightEdges(const std::vector<LightLevel> &levels);

/// The jumps of light in one view, and how long it was recorded.
struct LightCourse
{
    std::vector<LightEdge> edges;
    double durationS = 0;
    double frameS = 0; ///< typical interval
};

LightCourse lightCourseOf(const std::vector<LightLevel> &levels);

/// Finds the offset between two views from the light of the room that both saw jump: every pairing of two
/// edges of one direction proposes an offset, under which the edges that pair up speak for it and those that
/// the other view should have seen and did not speak against it. Weighed as a likelihood: a pair that falls
/// together by chance is one in three hundred, one edge in ten is missed. Taken where no other offset comes
/// within a factor of 150. The offset is the pairs' weighted mean; σ follows from theirs, their scatter, and
/// a tenth of a frame interval for each view, because a rolling shutter sees the robot's rows at another
/// moment than the middle of the frame. With three pairs over 20 s the rate of the clocks is fitted too, and
/// taken beyond 3σ. score: share of the edges that paired up. Undetermined: no jump in one view; several
/// offsets that fit equally well; none that fits.
Result<ClipOffset> estimateFlashOffset(const LightCourse &first, const LightCourse &second);

} // namespace odo
