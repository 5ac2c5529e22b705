// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/chapter_names.h"

#include "core/base/plain_text.h"
#include "core/base/units.h"
#include "core/video/chapter_join.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace odo {

namespace {

constexpr std::size_t mostDigits = 18; // of a number that is read

bool areDigits(std::string_view text)
{
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// GX010001, GH020001: two digits of the chapter, four of the recording; GOPR0001 and then GP010001.
std::optional<SeriesName> goproName(const std::string &stem, const std::string &ending)
{
    constexpr std::size_t letters = 8, chapterAt = 2, recordingAt = 4;
    if (stem.size() != letters || stem[0] != 'G' || !areDigits(stem.substr(recordingAt)))
        return std::nullopt;
    if (stem.starts_with("GOPR"))
        return SeriesName{"GP" + stem.substr(recordingAt) + ending, 0, true};
    const std::string chapter = stem.substr(chapterAt, recordingAt - chapterAt);
    if (std::string_view("HXLPS").find(stem[1]) == std::string_view::npos || !areDigits(chapter))
        return std::nullopt;
    return SeriesName{stem.substr(0, chapterAt) + stem.substr(recordingAt) + ending, std::stoi(chapter),
                      true};
}

/// Whether one was begun when the other ended. Cameras note when they began, or when they ended, in seconds.
bool follows(const std::filesystem::path &file, const std::filesystem::path &before)
{
    constexpr double tolerance = 3;
    const auto span = recordedSpan(file), itsSpan = recordedSpan(before);
    if (!span || !itsSpan)
        return false;
    const double laterS = toSeconds(span->at - itsSpan->at);
    return std::abs(laterS - toSeconds(itsSpan->duration)) <= tolerance ||
           std::abs(laterS - toSeconds(span->duration)) <= tolerance;
}

} // namespace

std::optional<SeriesName> SeriesName::of(const std::filesystem::path &file)
{
    const std::string stem = file.stem().string(), ending = lowerCaseAscii(file.extension().string());
    if (auto gopro = goproName(stem, ending))
        return gopro;
    const std::size_t last = stem.find_last_of("0123456789");
    if (last == std::string::npos)
        return std::nullopt;
    const std::size_t before = stem.find_last_not_of("0123456789", last);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const std::string digits = stem.substr(begin, last + 1 - begin);
    if (digits.size() > mostDigits)
        return std::nullopt;
    return SeriesName{stem.substr(0, begin) + "#" + stem.substr(last + 1) + ending, std::stoll(digits),
                      false};
}

std::vector<Message> chapterNameRemarks(const std::vector<std::filesystem::path> &chapters)
{
    std::vector<Message> remarks;
    for (std::size_t i = 1; i < chapters.size(); ++i) {
        const auto before = SeriesName::of(chapters[i - 1]), own = SeriesName::of(chapters[i]);
        if (!before || !own || before->series != own->series)
            continue;
        const MessageArgument beforeName = Named::file(chapters[i - 1].filename()),
                              name = Named::file(chapters[i].filename());
        if (own->number < before->number)
            remarks.push_back(ODO_TEXT("workflow.chapters_out_of_order",
                                       "by their names '%1' comes before '%2', and was joined behind it; "
                                       "check the order of the files")(name, beforeName));
        else if (own->number > before->number + 1)
            remarks.push_back(ODO_TEXT("workflow.chapter_missing",
                                       "by their names a file is missing between '%1' and '%2'; if so, all "
                                       "times behind it are wrong")(beforeName, name));
    }
    return remarks;
}

std::vector<std::vector<std::filesystem::path>> chapterGroups(const std::vector<std::filesystem::path> &files,
                                                              ChapterEvidence evidence)
{
    std::map<std::string, std::map<std::int64_t, std::filesystem::path>> bySeries;
    const auto keyOf = [](const std::filesystem::path &file, const SeriesName &name) {
        return (file.parent_path() / name.series).string();
    };
    for (const std::filesystem::path &file : files)
        if (const auto name = SeriesName::of(file))
            bySeries[keyOf(file, *name)].emplace(name->number, file);

    std::vector<std::vector<std::filesystem::path>> groups;
    std::map<std::filesystem::path, std::size_t> placed;
    for (const std::filesystem::path &file : files) {
        const auto name = SeriesName::of(file);
        if (placed.contains(file))
            continue;
        std::vector<std::filesystem::path> group{file};
        if (name) {
            const auto &series = bySeries[keyOf(file, *name)];
            const auto joins = [&](std::int64_t number) { // with the one before it
                const auto own = series.find(number), before = series.find(number - 1);
                return own != series.end() && before != series.end() &&
                       (name->isChapter ||
                        (evidence == ChapterEvidence::NameOrTime && follows(own->second, before->second)));
            };
            std::int64_t first = name->number, last = name->number;
            while (joins(first))
                --first;
            while (joins(last + 1))
                ++last;
            group.clear();
            for (std::int64_t number = first; number <= last; ++number)
                group.push_back(series.at(number));
        }
        for (const std::filesystem::path &each : group)
            placed.emplace(each, groups.size());
        placed.emplace(file, groups.size());
        groups.push_back(std::move(group));
    }
    return groups;
}

} // namespace odo
