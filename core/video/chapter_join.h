// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/units.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// When a camera recorded a file, by its container's headers alone.
struct RecordedSpan
{
    Nanoseconds at{0}; ///< since 1970; cameras note the beginning, or the end
    Nanoseconds duration{0};
};
/// nullopt where the headers do not say both, or no video can be opened. Any thread.
std::optional<RecordedSpan> recordedSpan(const std::filesystem::path &file);

/// Of joined chapters: the ending that names the container in which they are written, ".mov" (which keeps
/// exact stamps and how the frames are to be turned), or ".mkv" where they come from Matroska or QuickTime
/// does not hold their codec. Error: a file that cannot be opened.
Result<std::string> endingOfJoined(const std::filesystem::path &firstChapter);

/// Writes the chapters of one recording, in this order, as one file: the coded frames bit for bit, none
/// decoded, with their own times; the first frame of each chapter one usual interval after the last of the
/// chapter before, whatever its own clock says. H.264 and HEVC get their parameter sets at each key frame
/// where those of the chapters differ. The first sound track goes along if all chapters have an equal one.
/// claimed: an empty file. At most a few seconds of packets in memory. Gives
/// what the user should know: a last chapter that ends early, recording times out of order, sound that was
/// left out. Any thread.
/// Errors, naming the chapter: one that is no video; another codec, size, pixel format, turn or coding than
/// the first; no time stamps of its own, or a clock that begins again; a chapter but the last that ends
/// early, for what follows would be joined at wrong times; frames that its edit list hides; Io; Cancelled.
Result<std::vector<Message>> joinChapters(const std::vector<std::filesystem::path> &chapters,
                                          const std::filesystem::path &claimed, const JobControl &control);

} // namespace odo
