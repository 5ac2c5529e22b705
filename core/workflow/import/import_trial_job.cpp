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
#include "core/workflow/import/internal/view_times.h"
#include "core/workflow/import/teams.h"
#include "core/workflow/media_copy.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/frame_steps.h"
#include "core/workflow/track/registered_scene.h"
#include "core/workflow/track/settled_views.h"
#include "core/workflow/track/track_warnings.h"
#include "core/workflow/trial_sources.h"
#include "core/workflow/trials/trial_changes.h"
#include "core/workflow/turned_recordings.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace odo {

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
    m_sync.trial = m_settings.trial;
    m_sync.steps = ODO_TRY(stepsFor(what, m_settings.videos.size(), m_settings.steps));
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
    if (!m_settings.robots.empty() || isAnythingSought(m_sync)) {
        auto robots = robotsToTrack(project, m_trial, m_settings.robots);
        if (!robots && !m_settings.robots.empty())
            return tl::unexpected(robots.error());
        if (robots)
            m_sync.robots = std::move(*robots);
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
        m_views.push_back(std::move(view));
    }
    m_sync.microphones = ODO_TRY(microphonePositions(project, m_views));
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
    ODO_TRY(checkTimes(own.source.called, m_views[view].file, info, areGiven));
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
    const double playsS = toSeconds(info.frameTimes.back()), tookS = toSeconds(recording.frameTimes.back());
    m_sync.isSlowMotion = m_sync.isSlowMotion.value_or(false) || isPlayedOtherwise(playsS, tookS);
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
    m_views[view].recording = std::move(recording);
    ODO_TRY(fitView(m_views[view], m_viewIntrinsics[view]));
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

Result<void> ImportTrialJob::synchronise(const JobControl &control)
{
    std::ranges::move(ODO_TRY(synchroniseViews(m_views, m_sync, m_trial, control)),
                      std::back_inserter(m_warnings));
    m_recordings = recordingsOf(m_views);
    m_trial.durationS = toSeconds(m_recordings.front().frameTimes.back());
    std::ranges::move(ODO_TRY(commonTimeWarnings(importSubject(m_settings.trial), m_recordings)),
                      std::back_inserter(m_warnings));
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
    auto committed = addTrial(project, importChange(m_settings.trial, m_sources), [&]() -> Result<RecordId> {
        for (RecordingRecord &recording : m_recordings) {
            const auto camera = ODO_TRY(findOrAddCamera(project, recording.cameraName));
            recording.camera = camera.id;
        }
        if (!m_settings.team.empty()) {
            const auto team = ODO_TRY(findOrAddTeam(project, m_settings.team));
            m_trial.team = team.id;
        }
        if (!m_settings.robots.empty()) {
            for (const RobotRecord &robot : m_sync.robots)
                m_trial.robots.push_back(robot.id);
        }
        m_trial = ODO_TRY(project.trials().add(m_trial, m_recordings));
        return m_trial.id;
    });
    if (!committed)
        return committed;
    for (ClaimedFile &file : m_files)
        file.keep();
    m_files.clear();
    return {};
}

} // namespace odo
