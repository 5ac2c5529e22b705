// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/internal/view_times.h"

#include "core/project/names.h"
#include "core/video/frame_times.h"
#include "core/workflow/import/internal/joined_file.h"
#include "core/workflow/shared_words.h"

#include <cmath>

namespace odo {

Message giveCameraRate()
{
    return ODO_TEXT("workflow.give_camera_rate", "give the rate at which the camera took the frames");
}

Result<void> checkTimes(const std::filesystem::path &called, const std::filesystem::path &file,
                        const VideoInfo &info, bool areGiven)
{
    const Message what = ODO_TEXT("workflow.video", "video '%1'")(Named::file(called.filename()));
    if (isSeveralFiles(file))
        return fail(ErrorCode::Undetermined, what,
                    ODO_TEXT("workflow.several_files_in_one",
                             "it consists of several video files joined byte by byte, so the time between "
                             "them is unknown"),
                    ODO_TEXT("workflow.import_parts", "import each of these files as its own trial"));
    if (info.restartsAt)
        return fail(
            ErrorCode::Undetermined, what,
            ODO_TEXT("workflow.clock_restarts",
                     "its time stamps begin again or stand still after %1: two files were joined, or the "
                     "camera's clock was reset")(quantity(toSeconds(*info.restartsAt), 2, "s")),
            ODO_TEXT("workflow.cut_at_restart", "cut it there, and import each part as its own trial"));
    if (areGiven)
        return {};
    if (info.timeSource == TimeSource::Nowhere && info.frameTimes.size() > 1)
        return fail(ErrorCode::Undetermined, what,
                    ODO_TEXT("workflow.no_times_in_file", "it has no time stamps and states no frame rate"),
                    giveCameraRate());
    if (info.framesPerSecond > highestFrameRate)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("workflow.stamps_too_dense", "its time stamps mean %1, which no camera takes")(
                        quantity(std::round(info.framesPerSecond), 0, "frames/s")),
                    giveCameraRate());
    return {};
}

Result<std::optional<double>> filmedRate(const std::filesystem::path &file, const VideoInfo &info)
{
    // Phones play no slow motion less than twice slower; they do not keep a rate to better than a tenth.
    constexpr double least = 1.5, sameUpTo = 1.15;
    if (!info.capturedPerSecond || info.framesPerSecond <= 0)
        return std::nullopt;
    const double slower = *info.capturedPerSecond / info.framesPerSecond,
                 differs = std::max(slower, 1 / slower);
    if (differs < sameUpTo)
        return std::nullopt;
    if (differs < least || *info.capturedPerSecond > highestFrameRate)
        return fail(ErrorCode::Undetermined,
                    ODO_TEXT("workflow.video", "video '%1'")(Named::file(file.filename())),
                    ODO_TEXT("workflow.filmed_at_doubtful_rate",
                             "its file says that it was filmed at %1, but its time stamps mean %2")(
                        quantity(*info.capturedPerSecond, 1), quantity(info.framesPerSecond, 1, "frames/s")),
                    giveCameraRate());
    return info.capturedPerSecond;
}

Message filmedRateWords(const VideoInfo &info, double filmedRate)
{
    return ODO_TEXT("workflow.filmed_at_rate",
                    "it was filmed at %1, as its file says, and plays at %2; its times are those of filming")(
        quantity(filmedRate, 1), quantity(info.framesPerSecond, 1, "frames/s"));
}

std::vector<Message> timeRemarks(const VideoInfo &info, const std::vector<Nanoseconds> &times, bool areGiven)
{
    std::vector<Message> remarks{info.warning, unevenRateWords(times)};
    if (info.areFields)
        remarks.push_back(
            joined({measuredByFields(), ODO_TEXT("workflow.film_progressive",
                                                 "choose a progressive mode of the camera (p, not i)")},
                   Join::Semicolon));
    if (info.timeSource == TimeSource::Rate && !areGiven)
        remarks.push_back(joined({ODO_TEXT("video.no_time_stamps", "the file has no time stamps"),
                                  ODO_TEXT("workflow.rate_of_header", "its header states an even %1")(
                                      quantity(info.framesPerSecond, 3, "frames/s"))},
                                 Join::Colon));
    return remarks;
}

tl::unexpected<Error> timesOfOtherCount(const std::filesystem::path &table, std::size_t times,
                                        const std::string &camera, std::size_t frames)
{
    return fail(ErrorCode::InvalidInput, quotedFileSubject(table),
                ODO_TEXT("workflow.times_of_other_count",
                         "it has %1 times, but the video of view '%2' has %3 frames")(
                    times, Named::camera(camera), frames),
                ODO_TEXT("workflow.give_each_frame_time", "give one time for each frame"));
}

Result<GivenTimes> timesForFrames(const GivenTimes &given, const std::filesystem::path &table,
                                  const VideoInfo &info, const std::string &camera)
{
    const std::size_t frames = info.areFields ? info.frameTimes.size() / 2 : info.frameTimes.size();
    if (given.size() != frames)
        return timesOfOtherCount(table, given.size(), camera, frames);
    return info.areFields ? fieldTimes(given) : given;
}

} // namespace odo
