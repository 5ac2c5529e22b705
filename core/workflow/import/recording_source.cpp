// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/recording_source.h"

#include "core/base/file_system.h"

#include <algorithm>
#include <optional>
#include <string>

namespace odo {

namespace {

using Files = std::vector<std::filesystem::path>;

constexpr char joint = '+';
constexpr std::size_t mostChapters = 1000;

/// A later chapter is where it says, or beside the first.
std::filesystem::path chapterAt(const std::string &name, const Files &before)
{
    std::filesystem::path file(name);
    if (before.empty() || file.has_parent_path() || files::exists(file))
        return file;
    std::filesystem::path beside = before.front().parent_path() / file;
    return files::exists(beside) ? beside : file;
}

/// The text as names of existing files, joined; the first that fit, for a name may hold the sign itself.
/// False: there are none.
bool splitIntoFiles(const std::string &text, std::size_t from, Files &found)
{
    if (found.size() == mostChapters)
        return false;
    for (std::size_t end = text.find(joint, from);; end = text.find(joint, end + 1)) {
        const bool isLast = end == std::string::npos;
        const std::string name = text.substr(from, isLast ? end : end - from);
        const std::filesystem::path file = chapterAt(name, found);
        if (!name.empty() && files::isFile(file)) {
            found.push_back(file);
            if (isLast || splitIntoFiles(text, end + 1, found))
                return true;
            found.pop_back();
        }
        if (isLast)
            return false;
    }
}

/// Where not all are there: those between the signs, if any of them is.
Files splitAnyhow(const std::string &text)
{
    Files parts;
    bool isAnyThere = false;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(joint, from), text.size());
        parts.push_back(chapterAt(text.substr(from, end - from), parts));
        isAnyThere = isAnyThere || files::isFile(parts.back());
        from = end + 1;
    }
    return isAnyThere ? parts : Files{text};
}

Result<void> checkEachOnce(const std::filesystem::path &video, const Files &chapters)
{
    for (std::size_t i = 0; i < chapters.size(); ++i) {
        const bool isTwice = std::any_of(
            chapters.begin(), chapters.begin() + static_cast<std::ptrdiff_t>(i),
            [&](const std::filesystem::path &before) { return files::isSame(before, chapters[i]); });
        if (isTwice)
            return fail(ErrorCode::InvalidInput, joinedVideosSubject(video),
                        ODO_TEXT("workflow.chapter_twice",
                                 "'%1' is given twice")(Named::file(chapters[i].filename())),
                        ODO_TEXT("workflow.give_chapter_once", "give each file once, in their order"));
    }
    return {};
}

} // namespace

Result<RecordingSource> recordingSourceOf(const std::filesystem::path &video)
{
    RecordingSource source;
    source.called = video.filename();
    source.files = {video};
    if (files::isFile(video))
        return source;
    if (files::isFolder(video) || isImagePattern(video)) {
        auto series = ODO_TRY(imagesOf(video));
        source.kind = RecordingSource::Kind::Images;
        source.called = video;
        source.files = std::move(series.files);
        source.numbers = std::move(series.numbers);
        return source;
    }
    const std::string text = video.string();
    Files chapters;
    if (!splitIntoFiles(text, 0, chapters))
        chapters = splitAnyhow(text);
    if (chapters.size() < 2)
        return source;
    ODO_TRY(checkEachOnce(video, chapters));
    source.kind = RecordingSource::Kind::Chapters;
    source.called = joinedNames(chapters).filename();
    source.files = std::move(chapters);
    return source;
}

Message joinedVideosSubject(const std::filesystem::path &called)
{
    return ODO_TEXT("workflow.joined_videos", "videos '%1'")(Named::file(called));
}

std::filesystem::path joinedNames(const std::vector<std::filesystem::path> &chapters)
{
    std::string text = chapters.front().string();
    for (std::size_t i = 1; i < chapters.size(); ++i) {
        const bool isBeside = chapters[i].parent_path() == chapters.front().parent_path();
        text += joint + (isBeside ? chapters[i].filename() : chapters[i]).string();
    }
    return text;
}

} // namespace odo
