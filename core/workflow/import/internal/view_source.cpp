// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/internal/view_source.h"

#include "core/base/platform/file_status.h"
#include "core/exchange/table/frame_times_file.h"
#include "core/files/protected_files.h"
#include "core/video/chapter_join.h"
#include "core/video/frame_times.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/import/internal/made_recording.h"
#include "core/workflow/import/internal/view_times.h"
#include "core/workflow/shared_words.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <utility>

namespace odo {

namespace {

Result<ViewSource> sourceOf(const std::filesystem::path &video)
{
    ViewSource view;
    view.source = ODO_TRY(recordingSourceOf(video));
    if (view.source.kind != RecordingSource::Kind::Images) // those were just listed
        for (const std::filesystem::path &file : view.source.files)
            ODO_TRY(checkMayBeRead(file, quotedName(Named::file(file))));
    return view;
}

/// A view that is its own partner would agree with itself in everything.
Result<void> checkOwnFiles(const ImportSettings &settings, const std::vector<ViewSource> &views)
{
    std::map<FileIdentity, std::size_t> viewOf;
    for (std::size_t view = 0; view < views.size(); ++view) {
        for (const std::filesystem::path &file : views[view].source.files) {
            const auto identity = identityOf(file);
            const auto before = identity ? viewOf.emplace(*identity, view).first->second : view;
            if (before != view)
                return fail(ErrorCode::InvalidInput, importSubject(settings.trial),
                            ODO_TEXT("workflow.cameras_given_one_file",
                                     "cameras '%1' and '%2' were given the same file, '%3'")(
                                Named::camera(settings.videos[before].first),
                                Named::camera(settings.videos[view].first), Named::file(file.filename())),
                            ODO_TEXT("workflow.give_each_its_file", "give each camera its own video"));
        }
    }
    return {};
}

/// The tables of frame times.
Result<void> takeTables(const ImportSettings &settings, std::vector<ViewSource> &views)
{
    const Message what = importSubject(settings.trial);
    for (const auto &[camera, table] : settings.times) {
        const auto video =
            std::ranges::find(settings.videos, camera, &std::pair<std::string, std::filesystem::path>::first);
        if (video == settings.videos.end())
            return fail(ErrorCode::InvalidInput, what,
                        ODO_TEXT("workflow.times_of_no_view", "there are frame times for camera '%1', but no "
                                                              "video of it")(Named::camera(camera)),
                        ODO_TEXT("workflow.give_times_to_view", "name the camera of one of the videos"));
        ViewSource &view = views[static_cast<std::size_t>(video - settings.videos.begin())];
        if (!view.table.empty())
            return fail(ErrorCode::InvalidInput, what,
                        ODO_TEXT("workflow.times_given_twice",
                                 "camera '%1' was given two tables of frame times")(Named::camera(camera)),
                        ODO_TEXT("workflow.give_one_table", "give one table for each view"));
        if (settings.rate)
            return fail(
                ErrorCode::InvalidInput, what,
                ODO_TEXT("workflow.rate_and_times",
                         "camera '%1' was given both a frame rate and frame times")(Named::camera(camera)),
                ODO_TEXT("workflow.give_rate_or_table", "give one of them"));
        ODO_TRY(checkMayBeRead(table, quotedFileSubject(table)));
        view.table = table;
    }
    return {};
}

} // namespace

Result<std::vector<ViewSource>> viewSourcesOf(const ImportSettings &settings)
{
    std::vector<ViewSource> views;
    for (const auto &video : settings.videos)
        views.push_back(ODO_TRY(sourceOf(video.second)));
    ODO_TRY(checkOwnFiles(settings, views));
    ODO_TRY(takeTables(settings, views));
    for (ViewSource &view : views) {
        if (view.source.kind != RecordingSource::Kind::Images || !view.table.empty())
            continue;
        if (!settings.rate)
            return fail(ErrorCode::Undetermined, quotedName(Named::file(view.source.called)),
                        ODO_TEXT("workflow.images_without_times", "images have no times"),
                        ODO_TEXT("workflow.give_rate_or_times",
                                 "give their rate or a table of their times, like --rate 30 or "
                                 "--times A=stamps.csv"));
        view.remark = ODO_TRY(missingImages(view.source.called, view.source.numbers));
    }
    return views;
}

Result<std::vector<Message>> findFile(ViewSource &own, const ImportSettings &settings, std::size_t index,
                                      const std::filesystem::path &mediaFolder, const JobControl &control)
{
    const std::string &camera = settings.videos[index].first;
    if (!own.table.empty()) {
        TrackReading reading;
        reading.timeUnit = settings.timeUnit;
        own.times = ODO_TRY(readFrameTimes(own.table, reading, control));
    }
    const RecordingSource &source = own.source;
    if (source.kind == RecordingSource::Kind::File) {
        own.file = source.files.front();
        return std::vector<Message>();
    }
    std::vector<Message> remarks;
    const bool areImages = source.kind == RecordingSource::Kind::Images;
    if (areImages && own.times.empty()) {
        own.times = timesOfNumbers(source.numbers, *settings.rate);
        if (!own.remark.isEmpty())
            remarks.push_back(own.remark);
    }
    if (areImages && own.times.size() != source.files.size())
        return timesOfOtherCount(own.table, own.times.size(), camera, source.files.size());
    auto made =
        ODO_TRY(makeRecording(source, own.times, mediaFolder, settings.trial + "_" + camera, control));
    std::ranges::move(made.remarks, std::back_inserter(remarks));
    own.file = made.media.file.path();
    own.made = std::move(made.media);
    return remarks;
}

namespace {

using namespace std::chrono;

/// Clocks that nobody set begin at 1904, 1970, 1980, 2000 or when the camera was made.
bool isSet(Instant time)
{
    constexpr Instant earliest = sys_days(2010y / January / 2);
    return time >= earliest && time <= instantNow() + hours(24);
}

} // namespace

std::optional<Instant> filmedAt(const std::vector<ViewSource> &views)
{
    std::vector<Instant> recorded, written;
    const auto keep = [](std::vector<Instant> &times, std::int64_t sinceEpochNs) {
        const Instant time(duration_cast<milliseconds>(nanoseconds(sinceEpochNs)));
        if (isSet(time))
            times.push_back(time);
    };
    for (const ViewSource &view : views) {
        const std::filesystem::path &first = view.source.files.front();
        if (const auto span = recordedSpan(first))
            keep(recorded, span->at.count());
        if (const auto status = statusOf(first))
            keep(written, status->modifiedNs);
    }
    const std::vector<Instant> &times = recorded.empty() ? written : recorded;
    if (times.empty())
        return std::nullopt;
    // A clock that lost its time goes back to a date of its maker's.
    const auto [first, last] = std::ranges::minmax(times);
    return last - first > hours(24) ? last : first;
}

double rateOfTimes(const std::vector<Nanoseconds> &times)
{
    const Nanoseconds usual = spacingOf(times).usual;
    return usual.count() > 0 ? 1 / toSeconds(usual) : 0;
}

Message importChange(const std::string &trial, const std::vector<ViewSource> &views)
{
    std::vector<std::string> names;
    for (const ViewSource &view : views)
        if (view.source.kind != RecordingSource::Kind::File)
            names.push_back(view.source.called.string());
    return names.empty() ? importChange(trial)
                         : ODO_TEXT("workflow.import_trial_from", "import trial %1 from %2")(
                               Named::trial(trial), listed(names, MessageArgument::Kind::File));
}

} // namespace odo
