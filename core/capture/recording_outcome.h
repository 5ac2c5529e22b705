// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/synchroniser.h"
#include "core/video/frame_times.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace odo {

/// The camera delivered nothing for a while.
struct RecordingGap
{
    std::size_t before = 0; ///< the picture after it, by its place in the file
    Nanoseconds length{0};  ///< from the arrival of the picture before
    Error why;
};

/// What became of one view's recording.
struct ViewRecording
{
    std::filesystem::path file;
    FrameFormat format;
    RecordedTimes times;
    std::vector<Nanoseconds>
        taken; ///< of each picture in the file, by this machine's steady clock; derived from times
    double clockSigmaS = 0;       ///< of all of these alike
    std::uint64_t frames = 0;     ///< that the camera delivered
    std::uint64_t lostOnWire = 0; ///< gaps in the camera's own count
    /// that this program or the disk was too slow for; not what `problem` cost
    std::uint64_t lostByUs = 0;
    std::vector<double> latenciesS; ///< of each picture, from when it was taken to when it was written
    std::vector<RecordingGap> gaps;
    double longestWaitS = 0;      ///< that a picture waited for the disk
    std::optional<Error> problem; ///< why it ended by itself
};

/// What became of a recording of several views.
struct RecordingOutcome
{
    std::vector<ViewRecording> views; ///< in the order of the cameras
    PairFigures pairs;                ///< of the pictures recorded
};

/// When recorded pictures were taken, by this machine's steady clock.
struct DerivedTimes
{
    std::vector<Nanoseconds> taken; ///< one for each picture, increasing
    double sigmaS = 0;              ///< of all of them alike
};

/// Derives from the raw times of a recording when each picture was taken: the camera's clock as ClockMap
/// learns it, with what came before and after. Pure.
DerivedTimes deriveTimes(const RecordedTimes &times);

/// The advice where a file that is needed for a recording is no longer there.
Message putDiskBack();

} // namespace odo
