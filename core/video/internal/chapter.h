// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/video/chapter_join.h"
#include "core/video/video_input.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace odo {

/// One file of a recording that a camera has split, as joinChapters looks at it before it copies.
struct Chapter
{
    std::filesystem::path file;
    std::unique_ptr<VideoInput> input; ///< at its end
    std::int64_t firstPts = 0, lastPts = 0;
    Nanoseconds usual{0}; ///< interval of its frames; 0 of a single one
    std::size_t packets = 0;
    Message warning;
    bool endsEarly = false;
    std::optional<RecordedSpan> recorded; ///< as its headers say, with the duration of its frames

    const AVCodecParameters &parameters() const { return *input->stream().codecpar; }
    const AVStream *sound() const { return input->sound(); } ///< null: none
};

/// Opens the files and walks through their packets. Errors as of joinChapters, except for those of writing.
Result<std::vector<Chapter>> readChapters(const std::vector<std::filesystem::path> &files,
                                          const JobControl &control);

/// Whether two streams were set up alike: what their decoder needs to know beforehand.
bool haveSameSetUp(const AVCodecParameters &a, const AVCodecParameters &b);

/// Whether the sound of all can be one track.
bool haveSameSound(const std::vector<Chapter> &chapters);

Message cannotJoin(const std::filesystem::path &file);

} // namespace odo
