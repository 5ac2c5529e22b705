// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/clip_synchronisation.h"
#include "core/synchronisation/internal/sound_correlation.h"
#include "core/synchronisation/internal/sound_onsets.h"

#include <Eigen/Core>
#include <optional>

namespace odo {

/// The sound of one view.
struct SoundCourse
{
    SoundTrack track;
    SoundOnsets onsets;
    UsualSound usual;
};

SoundCourse soundCourseOf(SoundTrack track);

/// Where a camera hears from. Metres, in the world.
struct MicrophonePosition
{
    Eigen::Vector3d camera = Eigen::Vector3d::Zero();
    Eigen::Vector2d floorMiddle = Eigen::Vector2d::Zero();
    double floorRadiusM = 1;
};

/// How much later a sound reaches the second camera than the first.
struct SoundDelay
{
    double delayS = 0, sigmaS = 0;
};

/// Sound takes 2.9 ms a metre. Of cameras whose places are known: for a sound from the middle of the floor,
/// with the σ of one from anywhere on it. Of others: none, with the σ of a metre and a half.
SoundDelay soundDelay(const std::optional<MicrophonePosition> &first,
                      const std::optional<MicrophonePosition> &second);

/// "clap twice …", as advice.
Message clapForSound();

/// Finds the offset between two views from a clap, a knock or a whistle that both heard. The peaks of the
/// correlation of their onsets (correlationPeaks), over all of their overlap, propose offsets. For an offset
/// speak the pairs of onsets that fall together, the more the fewer there are, and far more if their waves
/// are alike (compareWaves); against it speaks each strong onset without a counterpart in the other view.
/// Taken where it is beyond chance and no other comes within a factor of 150 (score: one less the evidence of
/// the next, in parts of the best). Sounds that repeat in an even beat, as of music, are refused unless one
/// stands out.
///
/// The offset is the weighted mean over the pairs, each to 0.2 ms where the waves are alike and else to 0.8
/// ms, less the sound's delay. σ also holds that of the delay, 50 ppm of the time from the second view's
/// start to the pairs, unless they determine the rate, and 2 ms by which each camera may stamp sound and
/// frames apart. Pure; any thread. Undetermined: no sound stands out in one view; beats; several offsets that
/// fit equally well; none that fits.
Result<ClipOffset> estimateSoundOffset(const SoundCourse &first, const SoundCourse &second,
                                       const SoundDelay &delay);

} // namespace odo
