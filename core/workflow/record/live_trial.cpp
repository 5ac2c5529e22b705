// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/live_trial.h"

#include "core/base/file_system.h"
#include "core/base/steady_now.h"
#include "core/capture/capture_session.h"
#include "core/project/project.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/media_copy.h"
#include "core/workflow/record/completed_recordings.h"
#include "core/workflow/shared_words.h"

#include <QString>
#include <algorithm>
#include <chrono>

namespace odo {

namespace {

constexpr double slowFromS = 1;

Message viewSubject(const std::string &camera)
{
    return ODO_TEXT("workflow.view", "view '%1'")(Named::camera(camera));
}

} // namespace

Result<std::shared_ptr<LiveTrial>> LiveTrial::begin(Project &project, TrialRecord trial,
                                                    const std::vector<std::string> &cameras,
                                                    CaptureSession &session, std::optional<RunStart> start)
{
    // Its disk may be unmounted: then the media folder would be made on another one.
    if (!files::exists(project.file()))
        return fail(ErrorCode::NotFound, recordingSubject(trial.name),
                    ODO_TEXT("workflow.project_file_gone", "the project file no longer exists"),
                    joined({reconnectDisk(), ODO_TEXT("workflow.nothing_recorded", "nothing was recorded")},
                           Join::Semicolon));
    auto lock = ODO_TRY(RecordingLock::take(project.mediaFolder()));
    std::shared_ptr<LiveTrial> live(new LiveTrial(session, std::move(lock)));
    live->m_trial = std::move(trial);
    live->m_trial.date = instantNow();
    live->m_trial.syncMethod = "none";
    if (auto added = project.inTransaction([&] { return live->addTo(project, cameras); }); !added)
        return tl::unexpected(added.error());
    std::vector<std::filesystem::path> files;
    for (View &view : live->m_views) {
        view.file.keep(); // it is the trial's
        files.push_back(view.file.path());
    }
    live->m_start = start;
    session.startRecording(files,
                           start ? std::max(Nanoseconds(0), steadyNow() - start->from) : Nanoseconds(0));
    live->m_recording = true;
    return live;
}

Result<void> LiveTrial::addTo(Project &project, const std::vector<std::string> &cameras)
{
    std::vector<RecordingRecord> records;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const bool isNew = !project.cameras().find(cameras[i]);
        const auto camera = ODO_TRY(findOrAddCamera(project, cameras[i]));
        if (isNew)
            m_newCameras.push_back(camera.id);
        const CameraDescription &description = m_session.description(i);
        auto file = ODO_TRY(claimMediaFile(project.mediaFolder(), m_trial.name + "_" + cameras[i], ".mkv"));
        View view;
        view.file = std::move(file);
        view.record.camera = camera.id;
        view.record.path = files::absolute(view.file.path()).string(); // stored relative to the project
        view.record.widthPx = description.widthPx;
        view.record.heightPx = description.heightPx;
        view.record.framesPerSecond = description.framesPerSecond;
        records.push_back(view.record);
        m_views.push_back(std::move(view));
    }
    m_trial = ODO_TRY(project.trials().begin(m_trial, records));
    const auto stored = ODO_TRY(project.trials().recordings(m_trial.id));
    for (std::size_t i = 0; i < m_views.size(); ++i)
        m_views[i].record = stored[i];
    return {};
}

LiveTrial::~LiveTrial()
{
    if (m_recording)
        m_session.stopRecording();
}

Result<void> LiveTrial::append(Project &project)
{
    for (std::size_t i = 0; i < m_views.size(); ++i) {
        View &view = m_views[i];
        const RecordedTimes fresh = m_session.takeWritten(i);
        if (fresh.frames.empty())
            continue;
        if (view.frames + view.pending.frames.size() == 0)
            view.first = fresh.frames.front().arrival;
        view.last = fresh.frames.back().arrival;
        view.pending.frames.insert(view.pending.frames.end(), fresh.frames.begin(), fresh.frames.end());
        view.pending.readings.insert(view.pending.readings.end(), fresh.readings.begin(),
                                     fresh.readings.end());
    }
    return store(project);
}

/// Within a transaction.
Result<void> LiveTrial::appendPending(Project &project) const
{
    for (const View &view : m_views)
        ODO_TRY(project.trials().appendRawTimes(view.record.id, view.pending));
    return {};
}

/// What is pending, in one transaction.
Result<void> LiveTrial::store(Project &project)
{
    auto stored = project.inTransaction([&]() -> Result<void> {
        ODO_TRY(appendPending(project));
        Nanoseconds longest{0};
        for (const View &view : m_views)
            longest = std::max(longest, view.last - view.first);
        return project.trials().setDuration(m_trial.id, toSeconds(longest));
    });
    if (!stored)
        return stored;
    for (View &view : m_views) {
        view.frames += view.pending.frames.size();
        view.readings += view.pending.readings.size();
        view.pending = {};
    }
    return {};
}

Result<void> LiveTrial::prepare(Project &project)
{
    return append(project);
}

Result<void> LiveTrial::run(const JobControl &control)
{
    control.report(0, ODO_TEXT("workflow.writing_last_pictures", "writing the last frames"));
    const std::vector<ViewHealth> health = m_session.health().views;
    m_delivering = std::ranges::any_of(
        health, [](const ViewHealth &view) { return view.state == ViewHealth::State::Delivering; });
    m_outcome = m_session.stopRecording();
    m_recording = false;
    std::vector<EndedView> ended;
    for (std::size_t i = 0; i < m_views.size(); ++i) {
        View &view = m_views[i];
        const ViewRecording &outcome = m_outcome.views[i];
        warnOf(outcome, view.record.cameraName, comesByWire(m_session.description(i).kind));
        if (health[i].slow)
            m_warnings.push_back(joined(
                {viewSubject(view.record.cameraName), wholeMessage(health[i].slow->error)}, Join::Colon));
        const auto added = [](const auto &all, std::size_t stored) {
            using Times = std::decay_t<decltype(all)>;
            return Times(all.begin() + static_cast<std::ptrdiff_t>(std::min(stored, all.size())), all.end());
        };
        view.pending = {added(outcome.times.frames, view.frames),
                        added(outcome.times.readings, view.readings)};
        ended.push_back({view.record, view.file.path(), outcome.taken, outcome.clockSigmaS});
        if (outcome.taken.empty())
            continue;
        ended.back().record.widthPx = outcome.format.width;
        ended.back().record.heightPx = outcome.format.height;
    }
    auto recordings = describeRecordings(ended);
    if (!recordings) {
        const auto cut = std::ranges::find_if(
            m_outcome.views, [](const ViewRecording &view) { return view.problem.has_value(); });
        // which is the cause
        return tl::unexpected(cut == m_outcome.views.end() ? recordings.error() : *cut->problem);
    }
    m_recordings = std::move(*recordings);
    return {};
}

/// Why nothing was recorded.
Error LiveTrial::withoutFrames() const
{
    const Message subject = recordingSubject(m_trial.name);
    if (const std::optional<Error> &problem = m_outcome.views.front().problem)
        return {ErrorCode::Io, subject, problem->why, problem->advice};
    if (m_delivering)
        return {ErrorCode::Io, subject,
                ODO_TEXT("workflow.stopped_before_first_frame", "it was stopped before the first frame came"),
                ODO_TEXT("workflow.record_for_longer", "record again, for longer")};
    return {ErrorCode::Io, subject,
            ODO_TEXT("workflow.no_camera_gave_picture", "no camera delivered a frame"),
            ODO_TEXT("workflow.check_they_are_connected",
                     "check that they are connected and not used by another program")};
}

Result<void> LiveTrial::commit(Project &project)
{
    if (m_recordings.empty()) {
        ODO_TRY(discard(project));
        return tl::unexpected(withoutFrames());
    }
    auto completed = project.note(ODO_TEXT("workflow.record", "record %1")(Named::trial(m_trial.name)),
                                  [&]() -> Result<void> {
                                      ODO_TRY(appendPending(project));
                                      describeTrial(m_trial, m_recordings);
                                      ODO_TRY(project.trials().complete(m_trial, m_recordings));
                                      return project.trials().setVariables(m_trial.id, startVariables());
                                  });
    if (!completed)
        return completed;
    for (std::size_t i = 0; i < m_views.size(); ++i) {
        if (m_outcome.views[i].taken.empty()) // no recording of the trial any more
            m_views[i].file.remove();
    }
    m_lock.reset();
    m_trial = ODO_TRY(project.trials().get(m_trial.id));
    return {};
}

Result<void> LiveTrial::discard(Project &project)
{
    if (m_recording)
        m_session.stopRecording();
    m_recording = false;
    auto removed = project.inTransaction([&]() -> Result<void> {
        ODO_TRY(project.trials().removeUnfinished(m_trial.id));
        for (const RecordId camera : m_newCameras)
            ODO_TRY(project.cameras().removeUnused(camera));
        return {};
    });
    if (!removed)
        return removed;
    for (View &view : m_views)
        view.file.remove();
    m_lock.reset();
    return {};
}

/// When it was started, where frames of before are recorded too.
std::map<std::string, std::string> LiveTrial::startVariables() const
{
    const auto first = std::ranges::find_if(m_outcome.views, [](const ViewRecording &view) {
        return !view.taken.empty(); // its first frame is the trial's beginning
    });
    if (!m_start || m_start->from >= m_start->at || first == m_outcome.views.end())
        return {};
    const double startS = toSeconds(m_start->at - first->taken.front());
    return {{startVariable, QString::number(std::max(0.0, startS), 'f', 3).toStdString()}};
}

/// That not all could be kept that was to be recorded before the start.
std::optional<Message> LiveTrial::keptLess(const ViewRecording &view) const
{
    if (!m_start || !view.keptOnlyFrom)
        return std::nullopt;
    const double keptS = std::max(0.0, toSeconds(m_start->at - *view.keptOnlyFrom));
    const double bytes = static_cast<double>(m_session.preRollBytesOfView());
    return ODO_TEXT("workflow.kept_before_start",
                    "only the %1 before the start were kept: %2 of this camera need more than %3")(
        quantity(keptS, 1, "s"), quantity(toSeconds(m_start->at - m_start->from), 1, "s"),
        quantity(bytes / 1e6, 0, "MB"));
}

void LiveTrial::warnOf(const ViewRecording &view, const std::string &camera, bool byWire)
{
    const auto warn = [&](Message why, Message advice = {}) {
        m_warnings.push_back(wholeMessage(viewSubject(camera), std::move(why), std::move(advice)));
    };
    const Message leftOut = ODO_TEXT("workflow.view_left_out", "it recorded nothing and was left out");
    if (view.taken.empty() && view.problem)
        warn(joined({leftOut, wholeMessage(*view.problem)}, Join::Colon));
    else if (view.taken.empty())
        warn(leftOut,
             ODO_TEXT("workflow.check_its_cable", "check its cable, and whether another program uses it"));
    else if (view.problem)
        warn(ODO_TEXT("workflow.view_ended_early", "it ended early because %1")(wholeMessage(*view.problem)));
    if (auto less = keptLess(view))
        warn(std::move(*less), ODO_TEXT("workflow.keep_less_before",
                                        "record fewer seconds before the start, or smaller frames"));
    for (const RecordingGap &gap : view.gaps)
        warn(ODO_TEXT("workflow.nothing_came", "no frame arrived for %1 because %2")(
            quantity(toSeconds(gap.length), 1, "s"), wholeMessage(gap.why)));
    if (view.longestWaitS > slowFromS && view.lostByUs == 0)
        warn(ODO_TEXT("workflow.waited_for_disk", "frames waited up to %1 for the disk, and none was lost")(
                 quantity(view.longestWaitS, 1, "s")),
             ODO_TEXT("workflow.record_to_faster_disk", "record to a faster disk"));
    if (view.lostByUs > 0)
        warn(view.lostByUs == 1
                 ? Message(ODO_TEXT("workflow.picture_lost_here",
                                    "1 frame was lost because this computer or its disk was too slow"))
                 : ODO_TEXT("workflow.pictures_lost_here",
                            "%1 frames were lost because this computer or its disk was too slow")(
                       view.lostByUs),
             ODO_TEXT("workflow.faster_disk_or_fewer_cameras",
                      "record to a faster disk, or fewer cameras at once"));
    if (view.lostOnWire > 0 && byWire)
        warn(view.lostOnWire == 1
                 ? Message(ODO_TEXT("workflow.picture_lost_on_wire",
                                    "1 frame was lost between the camera and this program"))
                 : ODO_TEXT("workflow.pictures_lost_on_wire",
                            "%1 frames were lost between the camera and this program")(view.lostOnWire),
             ODO_TEXT("workflow.check_cable_and_bandwidth",
                      "check the cable, the bandwidth and what else this computer is doing"));
    else if (view.lostOnWire > 0)
        warn(view.lostOnWire == 1
                 ? Message(ODO_TEXT("workflow.picture_made_too_late",
                                    "1 frame was lost: this computer was too slow to generate it in time"))
                 : ODO_TEXT("workflow.pictures_made_too_late",
                            "%1 frames were lost: this computer was too slow to generate them in time")(
                       view.lostOnWire),
             ODO_TEXT("workflow.take_fewer_cameras",
                      "close other programs, or use fewer such cameras at once"));
}

} // namespace odo
