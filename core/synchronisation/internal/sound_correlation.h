// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/sound_track.h"

#include <cstddef>
#include <vector>

namespace odo {

/// How many steps later the first of two curves has what the second has, best first.
struct CurveLag
{
    double steps = 0;
    double height = 0; ///< of the correlation
};

/// The highest peaks of the generalised cross-correlation with phase transform (Knapp and Carter 1976) of two
/// curves, over all lags at which they overlap. Pure; any thread.
std::vector<CurveLag> correlationPeaks(const std::vector<float> &first, const std::vector<float> &second,
                                       std::size_t most);

/// The power of each frequency in most of a track's sound.
struct UsualSound
{
    std::vector<double> power;
};

UsualSound usualSoundOf(const SoundTrack &track);

/// What compareWaves takes of a view.
struct HeardSound
{
    const SoundTrack &track;
    const UsualSound &usual;
};

/// How alike two pieces of sound are, wave by wave.
struct WaveLikeness
{
    bool isAlike = false;
    double lagS = 0; ///< how much later than expected the first has it
    double sigmaS = 0;
};

/// Compares the sound about firstS in the first track with that about secondS in the second, by the phase
/// transform in the frequencies that stand out of the usual sound. Lags up to 4 ms are looked at, in
/// pieces of 22 ms and a quarter of a second. What two
/// microphones hear of one event agrees as far as the direct sound is part of it; other events of the same
/// kind do not. Pure; any thread.
WaveLikeness compareWaves(const HeardSound &first, double firstS, const HeardSound &second, double secondS);

} // namespace odo
