// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/workflow/import/internal/image_series.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// What the recording of one view consists of.
struct RecordingSource
{
    enum class Kind { File, Chapters, Images };
    Kind kind = Kind::File;
    std::vector<std::filesystem::path> files; ///< in order; a single one of Kind::File
    std::vector<std::int64_t> numbers;        ///< of images
    std::filesystem::path called;             ///< as messages call it
};

/// What a person means by the video of a view: a file; the chapters of one recording, joined by '+'
/// ("1.mp4+2.mp4", where later ones without a folder may lie beside the first); numbered images by a
/// pattern ("FOLDER/%06d.png") or the folder of one series. What names an existing file is that file, also
/// in parts, whatever signs the name holds. Looks at names alone. Any thread. Errors: those of imagesOf, a
/// chapter that is given twice.
Result<RecordingSource> recordingSourceOf(const std::filesystem::path &video);

/// "videos '1.mp4+2.mp4'": what messages about joined chapters begin with.
Message joinedVideosSubject(const std::filesystem::path &called);

/// The same files as a person writes them: joined by '+', without the folder of those that lie beside the
/// first.
std::filesystem::path joinedNames(const std::vector<std::filesystem::path> &chapters);

} // namespace odo
