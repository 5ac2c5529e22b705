// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/internal/made_recording.h"

#include "core/video/chapter_join.h"
#include "core/video/image_video.h"
#include "core/workflow/import/chapter_names.h"

#include <algorithm>
#include <iterator>

namespace odo {

namespace {

Result<MadeRecording> joinedRecording(const RecordingSource &source, const std::filesystem::path &mediaFolder,
                                      const std::string &name, const JobControl &control)
{
    MadeRecording made;
    for (Message &remark : chapterNameRemarks(source.files))
        made.remarks.push_back(joined({joinedVideosSubject(source.called), std::move(remark)}, Join::Colon));
    const std::string ending = ODO_TRY(endingOfJoined(source.files.front()));
    const auto join = [&](const std::filesystem::path &claimed) -> Result<void> {
        auto found = ODO_TRY(joinChapters(source.files, claimed, control));
        std::ranges::move(found, std::back_inserter(made.remarks));
        return {};
    };
    made.media =
        ODO_TRY(makeInMedia(mediaFolder, name, ending, joinedVideosSubject(source.called), join, control));
    return made;
}

} // namespace

Result<MadeRecording> makeRecording(const RecordingSource &source, const std::vector<Nanoseconds> &times,
                                    const std::filesystem::path &mediaFolder, const std::string &name,
                                    const JobControl &control)
{
    if (source.kind == RecordingSource::Kind::Chapters)
        return joinedRecording(source, mediaFolder, name, control);
    MadeRecording made;
    made.media = ODO_TRY(makeInMedia(
        mediaFolder, name, ".mkv", quotedName(Named::file(source.called)),
        [&](const std::filesystem::path &claimed) {
            return writeImageVideo(source.files, times, claimed, control);
        },
        control));
    return made;
}

} // namespace odo
