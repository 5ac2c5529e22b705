// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/video/video_reader.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// When the frames of one view were taken, if somebody says it: a table, or a rate of numbered images.
/// Empty: as its file says.
using GivenTimes = std::vector<Nanoseconds>;

/// The general advice where a file does not say it.
Message giveCameraRate();

/// Refuses files that hold several videos, times that are out of order, and those that are made up, or that
/// no camera's frames have, where nobody gives others. called: as messages call the file. Reads the file's
/// headers.
Result<void> checkTimes(const std::filesystem::path &called, const std::filesystem::path &file,
                        const VideoInfo &info, bool areGiven);

/// The rate at which the camera took the frames of slow motion or time lapse, where its file says so; nothing
/// where the frames play about as fast as they were taken. Undetermined: the two differ by too little to be
/// either. file: as messages call it. Pure.
Result<std::optional<double>> filmedRate(const std::filesystem::path &file, const VideoInfo &info);

/// That a video's times are those of filming, by filmedRate().
Message filmedRateWords(const VideoInfo &info, double filmedRate);

/// What the user should know of a video's times. times: those that count. Pure.
std::vector<Message> timeRemarks(const VideoInfo &info, const std::vector<Nanoseconds> &times, bool areGiven);

/// That a table has another number of times than a view has frames.
tl::unexpected<Error> timesOfOtherCount(const std::filesystem::path &table, std::size_t times,
                                        const std::string &camera, std::size_t frames);

/// The times of a table, one for each of so many frames; for twice as many fields of interlaced frames those
/// of both. Error: another number. Pure.
Result<GivenTimes> timesForFrames(const GivenTimes &given, const std::filesystem::path &table,
                                  const VideoInfo &info, const std::string &camera);

} // namespace odo
