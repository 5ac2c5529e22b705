// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/import_trial_job.h"

#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/base/job_control.h"
#include "core/files/protected_files.h"
#include "core/project/names.h"
#include "core/project/project.h"
#include "core/project/project_words.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/video/frame_times.h"
#include "core/video/video_reader.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/import/internal/clip_offsets.h"
#include "core/workflow/import/internal/view_times.h"
#include "core/workflow/import/teams.h"
#include "core/workflow/media_copy.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/frame_steps.h"
#include "core/workflow/track/registered_scene.h"
#include "core/workflow/track/settled_views.h"
#include "core/workflow/track/track_warnings.h"
#include "core/workflow/trial_sources.h"
#include "core/workflow/turned_recordings.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace odo {

namespace {

/// By what a view's offset is to be found; nullopt: it is not.
std::optional<OffsetSource> sourceOf(ImportSettings::Sync how)
{
    switch (how) {
    case ImportSettings::Sync::Automatic:
        return OffsetSource::Any;
    case ImportSettings::Sync::Motion:
        return OffsetSource::Motion;
    case ImportSettings::Sync::Flash:
        return OffsetSource::Flash;
    case ImportSettings::Sync::Sound:
        return OffsetSource::Sound;
    case ImportSettings::Sync::None:
    case ImportSettings::Sync::Given:
        break;
    }
    return std::nullopt;
}

const char *methodOf(OffsetSource source)
{
    return source == OffsetSource::Sound ? "audio" : source == OffsetSource::Flash ? "flash" : "auto";
}

double durationOf(const RecordingRecord &recording)
{
    return recording.frameTimes.empty() ? 0 : toSeconds(recording.frameTimes.back());
}

} // namespace

ImportTrialJob::ImportTrialJob(ImportSettings settings) : m_settings(std::move(settings)) {}

ImportTrialJob::~ImportTrialJob()
{
    m_files.clear(); // those that no trial has go
    m_sources.clear();
    if (!m_folderWasThere)
        files::remove(m_mediaFolder); // only when empty
}

Result<void> ImportTrialJob::prepare(Project &project)
{
    const Message what = importSubject(m_settings.trial);
    if (m_settings.videos.empty())
        return fail(ErrorCode::InvalidInput, what, ODO_TEXT("workflow.no_video_given", "no video was given"),
                    ODO_TEXT("workflow.give_views", "give one view or more, like --video A=a.mp4"));
    if (m_settings.videos.size() > mostViews)
        return tooManyViews(what, m_settings.videos.size());
    if (m_settings.rate && !(*m_settings.rate >= lowestFrameRate && *m_settings.rate <= highestFrameRate))
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("workflow.unusual_frame_rate",
                             "its frame rate is not between 0.1 and 100,000 frames a second"),
                    giveCameraRate());
    ODO_TRY(checkSteps());
    if (project.trials().find(m_settings.trial))
        return trialIsThere(what);
    std::set<std::string> names;
    for (const auto &video : m_settings.videos) {
        if (!names.insert(video.first).second)
            return fail(ErrorCode::InvalidInput, what,
                        ODO_TEXT("workflow.camera_given_two_videos",
                                 "camera '%1' was given two videos")(Named::camera(video.first)),
                        ODO_TEXT("workflow.join_or_name_camera",
                                 "give each view a camera of its own, or join the files of one recording "
                                 "with +, like --video A=1.mp4+2.mp4"));
    }
    m_sources = ODO_TRY(viewSourcesOf(m_settings));
    m_trial.name = m_settings.trial;
    m_trial.task = m_settings.task;
    const bool looks = std::any_of(m_settings.steps.begin(), m_settings.steps.end(),
                                   [](const auto &step) { return sourceOf(step.how).has_value(); });
    if (!m_settings.robots.empty() || looks) {
        auto robots = robotsToTrack(project, m_trial, m_settings.robots);
        if (!robots && !m_settings.robots.empty())
            return tl::unexpected(robots.error());
        if (robots)
            m_robots = std::move(*robots);
    }
    m_mediaFolder = project.mediaFolder();
    m_folderWasThere = files::exists(m_mediaFolder);

    const auto cameras = ODO_TRY(project.cameras().all());
    for (const auto &video : m_settings.videos) {
        const std::string &name = video.first;
        RegisteredView view;
        std::optional<Intrinsics> lens;
        view.recording.cameraName = name;
        for (const CameraRecord &camera : cameras) {
            if (camera.name != name)
                continue;
            view.registration = ODO_TRY(project.cameras().currentRegistration(camera.id));
            if (view.registration) {
                view.floorView = ODO_TRY(floorViewOf(project, *view.registration));
                view.registrationImage = imageFileOf(project, view.registration->image);
                lens = view.floorView->camera().intrinsics();
            } else if (auto stored = ODO_TRY(project.cameras().currentIntrinsics(camera.id))) {
                lens = std::move(stored->calibration.intrinsics);
            }
        }
        m_viewIntrinsics.push_back(std::move(lens));
        m_microphones.push_back(ODO_TRY(microphonePositionOf(project, view)));
        m_views.push_back(std::move(view));
    }
    return {};
}

Result<void> ImportTrialJob::run(const JobControl &control)
{
    for (std::size_t view = 0; view < m_settings.videos.size(); ++view) {
        std::ranges::move(ODO_TRY(findFile(m_sources[view], m_settings, view, m_mediaFolder, control)),
                          std::back_inserter(m_warnings));
        m_views[view].file = m_sources[view].file;
        ODO_TRY(readVideo(view, control.cancel));
    }
    m_trial.date = m_settings.date ? *m_settings.date : filmedAt(m_sources).value_or(instantNow());
    std::ranges::move(
        sceneWarnings(m_settings.trial, m_views, changesSinceRegistration(m_views, control.cancel)),
        std::back_inserter(m_warnings));
    ODO_TRY(synchronise(control));
    ODO_TRY(compareViews());
    for (std::size_t view = 0; view < m_settings.videos.size(); ++view)
        ODO_TRY(copyVideo(view, control));
    return {};
}

Result<void> ImportTrialJob::readVideo(std::size_t view, const CancelToken &cancel)
{
    const std::string &camera = m_settings.videos[view].first;
    const ViewSource &own = m_sources[view];
    const auto reader = ODO_TRY(VideoReader::open(m_views[view].file, cancel));
    const VideoInfo &info = reader->info();
    const bool areGiven = m_settings.rate.has_value() || !own.times.empty();
    ODO_TRY(checkTimes(own.source.called, info, areGiven));
    const std::optional<double> rate =
        areGiven ? m_settings.rate : ODO_TRY(filmedRate(own.source.called, info));
    RecordingRecord recording;
    recording.cameraName = camera;
    recording.position = static_cast<int>(view);
    recording.widthPx = info.format.width;
    recording.heightPx = info.format.height;
    recording.orientation = info.orientation;
    recording.framesPerSecond = info.framesPerSecond;
    recording.frameTimes = info.frameTimes;
    if (!own.times.empty()) {
        recording.frameTimes = ODO_TRY(timesForFrames(own.times, own.table, info, camera));
        recording.framesPerSecond = rateOfTimes(own.times);
    } else if (rate && info.framesPerSecond > 0) {
        // The file plays at another rate than the camera took the frames at (slow motion).
        const double scale = info.framesPerSecond / *rate;
        for (Nanoseconds &time : recording.frameTimes)
            time = fromSeconds(toSeconds(time) * scale);
        recording.framesPerSecond = *rate;
    }
    const double playsS = toSeconds(info.frameTimes.back()), tookS = durationOf(recording);
    m_playsOtherwise = m_playsOtherwise || std::abs(tookS - playsS) > 0.01 * playsS;
    const std::vector<Nanoseconds> &times = own.times.empty() ? info.frameTimes : recording.frameTimes;
    std::vector<Message> remarks = timeRemarks(info, times, areGiven);
    if (rate && !areGiven)
        remarks.push_back(filmedRateWords(info, *rate));
    for (const Message &warning : remarks) {
        if (!warning.isEmpty())
            m_warnings.push_back(
                joined({ODO_TEXT("workflow.video", "video '%1'")(Named::file(own.source.called)), warning},
                       Join::Colon));
    }
    m_views[view].recording = recording;
    ODO_TRY(fitView(m_views[view], m_viewIntrinsics[view]));
    m_recordings.push_back(std::move(recording));
    m_codings.push_back({info.codec, info.bitDepth, info.variableRate});
    return {};
}

/// Says what the size and the orientation of a view's frames mean for its camera's calibration, and converts
/// that where it can be.
Result<void> ImportTrialJob::fitView(RegisteredView &view, const std::optional<Intrinsics> &lens)
{
    const RecordingRecord &recording = view.recording;
    if (Message old = oldRegistrationWarning(m_settings.trial, view); !old.isEmpty())
        m_warnings.push_back(std::move(old));
    if (!lens || (lens->widthPx == recording.widthPx && lens->heightPx == recording.heightPx))
        return {};
    if (!view.registration) {
        m_warnings.push_back(wholeMessage(
            viewInTrialSubject(recording.cameraName, m_settings.trial),
            ODO_TEXT("workflow.lens_at_other_size", "its frames are %1, but the lens was calibrated at %2")(
                sizeText(recording.widthPx, recording.heightPx), sizeText(lens->widthPx, lens->heightPx)),
            registerInItsVideo()));
        return {};
    }
    view.floorView = ODO_TRY(floorViewAt(*view.registration, *lens, recording.widthPx, recording.heightPx));
    if (view.floorView) {
        view.convertedFromPx = {lens->widthPx, lens->heightPx};
        std::ranges::move(convertedViewWarnings(m_settings.trial, {view}), std::back_inserter(m_warnings));
    } else {
        const Error other = registeredAtOtherSize(m_settings.trial, recording, *lens);
        m_warnings.push_back(wholeMessage(other.what, other.why, other.advice));
    }
    return {};
}

/// Afterwards there is one step for each view but the first.
Result<void> ImportTrialJob::checkSteps()
{
    const std::size_t others = m_settings.videos.size() - 1, given = m_settings.steps.size();
    const bool forAll =
        given == 0 ||
        (given == 1 && (others == 0 || m_settings.steps.front().how != ImportSettings::Sync::Given));
    if (given != others && !forAll)
        return fail(
            ErrorCode::InvalidInput, importSubject(m_settings.trial),
            ODO_TEXT("workflow.offsets_of_other_count",
                     "the number of views is %1, the number of offsets %2")(others + 1, given),
            ODO_TEXT("workflow.give_offset_for_each",
                     "give one offset for each view but the first, like --sync 0.1,0.2, or use --sync auto"));
    if (forAll)
        m_settings.steps.resize(others, given > 0 ? m_settings.steps.front() : ImportSettings::ViewStep{});
    return {};
}

Result<void> ImportTrialJob::synchronise(const JobControl &control)
{
    m_trial.syncMethod = "none";
    std::vector<std::size_t> toFind;
    for (std::size_t view = 1; view < m_recordings.size(); ++view) {
        const ImportSettings::ViewStep &step = m_settings.steps[view - 1];
        m_recordings[view].syncMethod = "none";
        if (sourceOf(step.how))
            toFind.push_back(view);
        if (step.how == ImportSettings::Sync::Given) {
            m_recordings[view].syncMethod = "told";
            m_recordings[view].startOffsetS = step.offsetS;
        }
    }
    if (!toFind.empty())
        ODO_TRY(findOffsets(toFind, control));
    if (m_recordings.size() > 1) {
        m_trial.syncMethod = m_recordings[1].syncMethod;
        m_trial.syncOffsetS = m_recordings[1].startOffsetS;
        m_trial.syncOffsetSigmaS = m_recordings[1].startOffsetSigmaS;
        m_trial.syncRate = m_recordings[1].clockRate;
        if (m_trial.syncMethod == "told")
            m_trial.syncScore = 1;
    }
    return {};
}

/// Moves the frame times to where they were taken, and says so.
void ImportTrialJob::repairTimes(RecordingRecord &recording, const ClockRepair &repair)
{
    for (Nanoseconds &time : recording.frameTimes)
        time = fromSeconds(repair.timeS(toSeconds(time)));
    for (const ClockStep &step : repair.steps)
        m_warnings.push_back(joined({ODO_TEXT("workflow.times_of_view", "time stamps of view '%1'")(
                                         Named::camera(recording.cameraName)),
                                     clockStepSentence(step)},
                                    Join::Colon));
}

Result<void> ImportTrialJob::findOffsets(const std::vector<std::size_t> &toFind, const JobControl &control)
{
    std::vector<RegisteredView> views{m_views.front()};
    ClipOffsetSearch search{m_settings.trial, {}, m_robots, {m_microphones.front()}, m_playsOtherwise};
    for (const std::size_t view : toFind) {
        views.push_back(m_views[view]);
        search.sources.push_back(*sourceOf(m_settings.steps[view - 1].how));
        search.microphones.push_back(m_microphones[view]);
    }
    auto [found, frameSteps, firstRepair] = ODO_TRY(findClipOffsets(views, search, control));
    std::ranges::move(frameSteps, std::back_inserter(m_warnings));
    m_recordings.front().frameTimes = views.front().recording.frameTimes;
    for (std::size_t i = 0; i < toFind.size(); ++i)
        m_recordings[toFind[i]].frameTimes = views[i + 1].recording.frameTimes;
    if (firstRepair)
        repairTimes(m_recordings.front(), *firstRepair);
    for (std::size_t i = 0; i < toFind.size(); ++i) {
        RecordingRecord &recording = m_recordings[toFind[i]];
        const Result<FoundOffset> &offset = found[i];
        const Message what = ODO_TEXT("workflow.synchronisation_of_view",
                                      "synchronisation of view '%1'")(Named::camera(recording.cameraName));
        if (!offset && search.sources[i] != OffsetSource::Any)
            return fail(offset.error().code, what, offset.error().why, offset.error().advice);
        if (!offset) {
            const Message taken = ODO_TEXT("workflow.taken_as_begun_together",
                                           "%1; the same start time was assumed")(offset.error().why);
            m_warnings.push_back(wholeMessage(what, taken, offset.error().advice));
            continue;
        }
        for (const Message &remark : offset->remarks)
            m_warnings.push_back(joined({what, remark}, Join::Colon));
        repairTimes(recording, offset->clock.second);
        if (Message sentence = clockRateSentence(recording, m_recordings.front(), offset->clock.rate);
            !sentence.isEmpty())
            m_warnings.push_back(joined({what, std::move(sentence)}, Join::Colon));
        recording.syncMethod = methodOf(offset->from);
        recording.startOffsetS = offset->clock.offsetS;
        recording.startOffsetSigmaS = offset->clock.sigmaS;
        recording.clockRate = offset->clock.rate;
        if (toFind[i] == 1) {
            m_trial.syncRateSigma = offset->clock.rateSigma;
            m_trial.syncScore = offset->clock.score;
        }
    }
    return {};
}

Result<void> ImportTrialJob::compareViews()
{
    const double firstEndS = durationOf(m_recordings[0]);
    m_trial.durationS = firstEndS;
    for (std::size_t view = 1; view < m_recordings.size(); ++view) {
        const RecordingRecord &other = m_recordings[view];
        const double startS = other.startOffsetS, endS = startS + durationOf(other);
        const double commonS = std::min(endS, firstEndS) - std::max(startS, 0.0);
        const MessageArgument firstName = Named::camera(m_recordings[0].cameraName),
                              otherName = Named::camera(other.cameraName);
        if (commonS <= 0)
            return fail(ErrorCode::InvalidInput, importSubject(m_settings.trial),
                        ODO_TEXT("workflow.no_common_time",
                                 "views '%1' and '%2' do not overlap with a time offset of %3")(
                            firstName, otherName, quantity(startS, 2, "s")),
                        ODO_TEXT("workflow.check_files_and_offset", "check the files and the --sync offset"));
        const auto warn = [&](Message why, Message advice) {
            m_warnings.push_back(
                wholeMessage(ODO_TEXT("workflow.two_views", "views '%1' and '%2'")(firstName, otherName),
                             std::move(why), std::move(advice)));
        };
        if (commonS < 0.9 * std::max(firstEndS, durationOf(other)))
            warn(ODO_TEXT("workflow.little_common_time", "%1 and %2 long, %3 in common")(
                     quantity(firstEndS, 2, "s"), quantity(durationOf(other), 2, "s"),
                     quantity(commonS, 2, "s")),
                 ODO_TEXT("workflow.check_views_of_one_run",
                          "only one view measures the rest, so check that both belong to one run"));
        const double a = m_recordings[0].framesPerSecond, b = other.framesPerSecond;
        const bool isLabelWrong = std::abs(other.clockRate) > largestClockRate; // said already
        if (a > 0 && b > 0 && std::abs(a - b) > 0.02 * a && !isLabelWrong)
            warn(ODO_TEXT("workflow.unequal_rates", "%1 and %2")(std::lround(a),
                                                                 quantity(std::round(b), 0, "frames/s")),
                 ODO_TEXT("workflow.check_rate",
                          "views are matched by time: check --rate if one is in slow motion"));
    }
    return {};
}

Result<void> ImportTrialJob::copyVideo(std::size_t view, const JobControl &control)
{
    ViewSource &own = m_sources[view];
    const std::string name = m_settings.trial + "_" + m_settings.videos[view].first;
    auto copy = own.made ? std::move(*own.made)
                         : ODO_TRY(copyIntoMedia(m_views[view].file, m_mediaFolder, name, control));
    m_recordings[view].path = files::absolute(copy.file.path()).string(); // stored relative to the project
    m_recordings[view].sha256 = copy.sha256;
    m_recordings[view].bytes = copy.bytes;
    m_files.push_back(std::move(copy.file));
    return {};
}

Result<void> ImportTrialJob::commit(Project &project)
{
    auto committed = project.note(importChange(m_settings.trial, m_sources), [&]() -> Result<void> {
        for (RecordingRecord &recording : m_recordings) {
            const auto camera = ODO_TRY(findOrAddCamera(project, recording.cameraName));
            recording.camera = camera.id;
        }
        if (!m_settings.team.empty()) {
            const auto team = ODO_TRY(findOrAddTeam(project, m_settings.team));
            m_trial.team = team.id;
        }
        if (!m_settings.robots.empty()) {
            for (const RobotRecord &robot : m_robots)
                m_trial.robots.push_back(robot.id);
        }
        m_trial = ODO_TRY(project.trials().add(m_trial, m_recordings));
        return {};
    });
    if (!committed)
        return committed;
    for (ClaimedFile &file : m_files)
        file.keep();
    m_files.clear();
    return {};
}

} // namespace odo
