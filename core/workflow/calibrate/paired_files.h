// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/video/frame.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace odo {

/// Files of two cameras taken at the same moments; a file without a counterpart is alone in its pair.
struct FilePair
{
    std::filesystem::path a, b; ///< empty: none
};

/// Pairs by a number in the names where the names share one (left07 with right07): the last number that
/// distinguishes the files of each camera, where at least four fifths of the fewer ones have a counterpart.
/// Otherwise in the order given. InvalidInput, naming both counts, where the order cannot say it; and for a
/// file that is there twice. Any thread; opens nothing.
Result<std::vector<FilePair>> pairFiles(const std::vector<std::filesystem::path> &a,
                                        const std::vector<std::filesystem::path> &b);

/// Two frames of one moment, each with its name ("file" or "file@frame").
struct FramePair
{
    Frame a, b;
    std::string nameA, nameB;
};

/// Gives the frames of a pair of files: the only ones of two images; of two videos two each second (at most
/// 120 in all), B's frame the one nearest in time, both counted from the first frame. Stops early when visit
/// returns false. Errors: an image paired with a video, neither image nor video; Cancelled.
Result<void> visitFramePairs(const FilePair &files, const std::function<bool(const FramePair &)> &visit,
                             const CancelToken &cancel);

} // namespace odo
