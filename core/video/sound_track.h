// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace odo {

/// The sound that was recorded with a video: all channels as one, at one rate, without gaps. An hour takes
/// 115 MB. A plain value.
struct SoundTrack
{
    static constexpr double rate = 16'000; ///< samples a second
    static constexpr double longestS = 2.5 * 3600;

    double firstS = 0;                 ///< time of the first sample, since the video's first frame
    std::vector<std::int16_t> samples; ///< full scale 32,767

    double durationS() const { return double(samples.size()) / rate; }
};

/// Reads and decodes all of a file's sound. Its times are the audio stream's own, counted from the first
/// frame that is shown, after what edit lists and the coder's start-up samples (priming) take off; where they
/// leave a gap there is silence, and where they run against the count of samples, the samples are moved by
/// steps of a millisecond. What cannot be decoded is silent. Opens the same containers as VideoInput. Any
/// thread. Errors: those of VideoInput; no sound in the file; none that can be decoded; longer than
/// `longestS`; cancelled.
Result<SoundTrack> readSound(const std::filesystem::path &file, const CancelToken &cancel);

} // namespace odo
