// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/clip_groups.h"

#include "core/project/names.h"
#include "core/workflow/import/chapter_names.h"
#include "core/workflow/import/recording_source.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace odo {

namespace {

constexpr double clocksApartS = 5; // of two phones

/// The file's folder and what comes before the first digit of its name.
std::string sourceNameOf(const std::filesystem::path &file)
{
    const std::string stem = file.stem().string();
    return (file.parent_path() / stem.substr(0, stem.find_first_of("0123456789"))).string() +
           file.extension().string();
}

double lengthS(const FoundClip &clip)
{
    return clip.span ? toSeconds(clip.span->duration) : 0;
}

using Run = std::vector<FoundClip>;

bool hasSource(const Run &run, const std::string &source)
{
    return std::ranges::find(run, source, &FoundClip::source) != run.end();
}

/// Names that are the time of recording ("PXL_20260309_101500123") tell no two phones apart: the one that was
/// started first comes first.
bool isNamedByTime(const FoundClip &clip)
{
    constexpr std::ptrdiff_t digitsOfTime = 12;
    const std::string stem = clip.recording.stem().string();
    return std::ranges::count_if(stem, [](char c) { return c >= '0' && c <= '9'; }) >= digitsOfTime;
}

/// "IMG_99" before "IMG_100".
auto orderOf(const FoundClip &clip)
{
    const auto name = SeriesName::of(clip.recording);
    return std::tuple(clip.source, name ? name->number : 0, clip.recording);
}

/// Whether a clip, not older than the run's, was recorded at the same time.
bool belongsTo(const FoundClip &clip, const Run &run)
{
    const double laterS = toSeconds(clip.span->at - run.front().span->at);
    if (laterS <= clocksApartS) // at once: they are of two cameras, whatever their names
        return laterS < lengthS(run.front()) && !(isNamedByTime(clip) && hasSource(run, clip.source));
    // One camera may note the beginning and the other the end.
    const bool isEndOf = std::abs(laterS - lengthS(clip)) <= clocksApartS ||
                         std::abs(laterS - lengthS(run.front())) <= clocksApartS;
    return isEndOf && !hasSource(run, clip.source);
}

std::vector<Run> byTime(std::vector<FoundClip> clips)
{
    std::ranges::stable_sort(clips, {}, [](const FoundClip &clip) { return clip.span->at; });
    std::vector<Run> runs;
    for (FoundClip &clip : clips) {
        if (runs.empty() || runs.back().size() == mostViews || !belongsTo(clip, runs.back()))
            runs.emplace_back();
        runs.back().push_back(std::move(clip));
    }
    return runs;
}

/// Each by itself where the numbers of clips say nothing.
std::vector<Run> byName(std::vector<FoundClip> clips)
{
    std::map<std::string, Run> bySource;
    std::ranges::sort(clips, {}, orderOf);
    for (const FoundClip &clip : clips)
        bySource[clip.source].push_back(clip);
    const std::size_t count = bySource.begin()->second.size();
    const bool areEqual =
        std::ranges::all_of(bySource, [&](const auto &one) { return one.second.size() == count; });
    std::vector<Run> runs;
    if (bySource.size() > mostViews || !areEqual) {
        for (FoundClip &clip : clips)
            runs.push_back({std::move(clip)});
        return runs;
    }
    runs.resize(count);
    for (const auto &[source, own] : bySource)
        for (std::size_t i = 0; i < count; ++i)
            runs[i].push_back(own[i]);
    return runs;
}

/// The camera of each clip of a run, by its source and, among equal ones, by the order of their names.
using CameraKey = std::pair<std::string, std::size_t>;
std::vector<CameraKey> camerasOf(Run &run)
{
    std::ranges::sort(run, {}, orderOf);
    std::vector<CameraKey> cameras;
    for (const FoundClip &clip : run) {
        const bool again = !cameras.empty() && cameras.back().first == clip.source;
        cameras.emplace_back(clip.source, again ? cameras.back().second + 1 : 0);
    }
    return cameras;
}

} // namespace

std::vector<FoundClip> describeClips(std::span<const std::filesystem::path> recordings)
{
    std::vector<FoundClip> clips;
    for (const std::filesystem::path &recording : recordings) {
        const auto source = recordingSourceOf(recording);
        const std::filesystem::path &first = source ? source->files.front() : recording;
        clips.push_back({recording, sourceNameOf(first), recordedSpan(first)});
    }
    return clips;
}

std::vector<ClipGroup> groupClips(std::vector<FoundClip> clips)
{
    if (clips.empty())
        return {};
    const bool areTimed =
        std::ranges::all_of(clips, [](const FoundClip &clip) { return clip.span.has_value(); });
    std::vector<Run> runs = areTimed ? byTime(std::move(clips)) : byName(std::move(clips));
    std::map<CameraKey, std::size_t> columns;
    for (Run &run : runs)
        for (const CameraKey &camera : camerasOf(run))
            columns.emplace(camera, 0);
    std::size_t next = 0;
    for (auto &[camera, column] : columns)
        column = next++;
    std::vector<ClipGroup> groups;
    for (Run &run : runs) {
        ClipGroup group;
        group.views.resize(columns.size());
        const std::vector<CameraKey> cameras = camerasOf(run);
        for (std::size_t i = 0; i < run.size(); ++i) {
            group.views[columns.at(cameras[i])] = run[i].recording;
            group.lengthS = std::max(group.lengthS, lengthS(run[i]));
            if (!group.recorded && run[i].span)
                group.recorded =
                    Instant(std::chrono::duration_cast<std::chrono::milliseconds>(run[i].span->at));
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

} // namespace odo
