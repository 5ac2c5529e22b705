// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// What the name of a file says of its place in a series: "GX020001.MP4" is chapter 2 of "GX0001.MP4",
/// "run_003.mp4" number 3 of "run_#.mp4". Plain value.
struct SeriesName
{
    std::string series; ///< the same of all files of one
    std::int64_t number = 0;
    bool isChapter = false; ///< as GoPro names what it has split; of others only the number counts

    /// nullopt: the name holds no number.
    static std::optional<SeriesName> of(const std::filesystem::path &file);
};

/// What the names of chapters say against their order or their number: a sentence for each. Pure.
std::vector<Message> chapterNameRemarks(const std::vector<std::filesystem::path> &chapters);

/// By what files are taken for chapters: by their name alone where several recordings of one camera may
/// follow each other at once.
enum class ChapterEvidence { NameOrTime, Name };

/// Which of the files may be chapters of one recording, each group in order, groups and single files in the
/// order in which they were given: files of one folder and series with numbers that follow each other, and,
/// unless the name alone says it, of which each was begun when the one before ended, by the recording times
/// in their headers (NameOrTime; opens those files). Any thread.
std::vector<std::vector<std::filesystem::path>>
chapterGroups(const std::vector<std::filesystem::path> &files,
              ChapterEvidence evidence = ChapterEvidence::NameOrTime);

} // namespace odo
