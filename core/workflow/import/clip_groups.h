// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/video/chapter_join.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace odo {

/// A recording of one camera, with what its name and headers say of it.
struct FoundClip
{
    std::filesystem::path recording;  ///< a file, or several as recordingSourceOf() reads them
    std::string source;               ///< folder and beginning of the name: the same for one camera's files
    std::optional<RecordedSpan> span; ///< of the first file
};

/// Reads the headers of recordings. Any thread; opens each file.
std::vector<FoundClip> describeClips(std::span<const std::filesystem::path> recordings);

/// The clips of one run.
struct ClipGroup
{
    std::vector<std::filesystem::path> views; ///< one for each camera; empty where that has none
    std::optional<Instant> recorded;          ///< when it was, by the first clip that says so
    double lengthS = 0;                       ///< of the longest clip; 0: not known
};

/// The runs of a lesson, in the order in which they were filmed, each with as many views as there are
/// cameras. Clips that were recorded at the same time belong together (cameras note the beginning or the end,
/// by clocks that may be seconds apart). Their cameras are told apart by folder and name ("IMG_", "PXL_"), or
/// where those are equal, as of two phones of one kind, by the numbers in the names; where those are times,
/// the clips of equal sources stay apart, each by itself. Where headers say nothing
/// of the time, each camera's clips are taken in the order of their names, if all have equally many; else
/// each clip is by itself. Pure.
std::vector<ClipGroup> groupClips(std::vector<FoundClip> clips);

} // namespace odo
