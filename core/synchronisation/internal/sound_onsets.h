// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/sound_track.h"

#include <vector>

namespace odo {

/// A moment at which something was struck, clapped or blown.
struct SoundEvent
{
    double timeS = 0;    ///< by the view's own clock, to a few milliseconds
    double strength = 0; ///< how steeply and in how many bands it begins
};

/// Where the sound of a view begins anew, apart from what rings on.
struct SoundOnsets
{
    static constexpr double stepS = 0.001;

    double firstS = 0;        ///< time of the curve's first value
    std::vector<float> curve; ///< in steps of stepS
    /// in order of time; those at least a quarter as strong as the strongest
    std::vector<SoundEvent> events;

    double endS() const { return firstS + stepS * double(curve.size()); }
};

/// In four bands from 300 Hz to 7 kHz: how far the level rises above what there was before and rings on in a
/// room, on a scale that begins a few times above the band's usual level and is logarithmic beyond; the rise
/// of that within 3 ms, summed over the bands. A steady tone, noise and what a room adds to a sound hardly
/// show in it. Pure; any thread.
SoundOnsets findSoundOnsets(const SoundTrack &track);

} // namespace odo
