// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/workflow/import/recording_source.h"
#include "core/workflow/media_copy.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// One video in the media folder that was made from what a recording consists of.
struct MadeRecording
{
    MediaCopy media;
    std::vector<Message> remarks; ///< whole sentences: what the user should know of it
};

/// Joins chapters (joinChapters), or writes images as a video (writeImageVideo) with these times. The
/// file goes unless it is kept. Errors: theirs, and those of copyIntoMedia. Any thread.
Result<MadeRecording> makeRecording(const RecordingSource &source, const std::vector<Nanoseconds> &times,
                                    const std::filesystem::path &mediaFolder, const std::string &name,
                                    const JobControl &control);

} // namespace odo
